// The first difference between two value change dumps.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tb/wave/vcd_reader.h"

namespace racebeam {

struct VcdDifference {
  struct Row {
    std::string path, a, b;  ///< as GTKWave shows them with our save file; "unknown"
  };
  std::string time;       ///< "9920 ps"
  std::string place;      ///< "frame 60, line -240, clock 12", if the dumps say so
  std::vector<Row> rows;  ///< all signals that differ at that time, by path
};

struct VcdComparison {
  std::vector<std::string> only_a, only_b;  ///< paths in one of them only, or of other widths
  std::uint64_t shared = 0, changes = 0;    ///< paths compared; changes of theirs in the first
  std::string begin_a, begin_b;             ///< the later one is where the comparison begins
  std::string end;                          ///< of the file that ends while the other goes on
  std::optional<VcdDifference> first;       ///< in the time that both have

  bool same() const {
    return only_a.empty() && only_b.empty() && begin_a == begin_b && end.empty() && !first;
  }
};

/// Reads both until shared signals differ; `takes` chooses signals by path. Times are compared in
/// the finer of the two units. Throws UsageError if a file is broken, and if they have no time in
/// common.
VcdComparison compare_vcds(VcdReader& a, VcdReader& b,
                           const std::function<bool(const std::string&)>& takes);

}  // namespace racebeam
