// The first difference between two value change dumps.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/trace/vcd_reader.h"

namespace racebeam {

struct VcdDifference {
  struct Row {
    std::string path, a, b;  ///< digits or words
  };
  std::uint64_t time = 0;
  std::string place;      ///< "frame 60, line -240, clock 12", if the dumps say so
  std::vector<Row> rows;  ///< all signals that differ at that time, by path
};

struct VcdComparison {
  std::vector<std::string> only_a, only_b;  ///< paths in one of them only, or of other widths
  std::uint64_t shared = 0, changes = 0;    ///< paths compared; changes of theirs in the first
  std::optional<VcdDifference> first;

  bool same() const { return only_a.empty() && only_b.empty() && !first; }
};

/// Reads both until shared signals differ. Throws UsageError if a file is broken.
VcdComparison compare_vcds(VcdReader& a, VcdReader& b);

}  // namespace racebeam
