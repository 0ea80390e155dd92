// What a Tiny Tapeout info.yaml says of the chip, from its text alone.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

struct TtInfo {
  struct Source {
    std::string name;
    int line;  ///< from 1
  };

  std::string top;              ///< top module, tt_um_...
  std::vector<Source> sources;  ///< in the order of the file; one at least
  std::uint64_t clock_hz = 0;   ///< 0: not known
};

/// `clock_is_known`: clock_hz is not looked at. Throws UsageError that names the file, called
/// `name`, and the line, what is wrong and what to do.
TtInfo read_tt_info(const std::string& text, const std::string& name, bool clock_is_known = false);

}  // namespace racebeam
