// A Tiny Tapeout project folder: what its info.yaml says about the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

struct TtProject {
  std::string folder;                ///< as it was named
  std::string top;                   ///< top module, tt_um_...
  std::string source_folder;         ///< src, or the folder itself
  std::vector<std::string> sources;  ///< paths, in the order of info.yaml
  std::uint64_t clock_hz = 0;
  int clocks_per_pixel = 0;  ///< clock_hz in pixels of 640x480 at 60 Hz, 1..8
  std::string hash;          ///< of all sources
};

/// Reads info.yaml; sources lie in src/ or beside it. Throws UsageError that names file and line,
/// what is wrong and what to do.
TtProject read_tt_project(const std::string& folder);

}  // namespace racebeam
