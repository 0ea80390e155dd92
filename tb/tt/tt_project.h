// A Tiny Tapeout project folder: what its info.yaml says about the chip, and what its other files
// say about how to read the sources.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace racebeam {

/// What the user adds to what the folder says.
struct TtReading {
  std::optional<long long> clock_hz;         ///< instead of that of info.yaml
  std::vector<std::string> defines;          ///< "NAME" or "NAME=VALUE"
  std::vector<std::string> include_folders;  ///< looked through first
  bool trust = false;                        ///< the RTL may do whatever it likes
};

struct TtProject {
  std::string folder;                        ///< as it was named
  std::string top;                           ///< top module, tt_um_...
  std::string source_folder;                 ///< src, or the folder itself
  std::vector<std::string> sources;          ///< paths, in the order of info.yaml
  std::vector<std::string> include_folders;  ///< those of the user, of src/config.json, all of src
  std::vector<std::string> defines;          ///< those of the user, then of src/config.json
  std::vector<std::string> config_defines;   ///< those of src/config.json
  std::vector<std::string> test_defines;     ///< of test/Makefile, which are not taken
  std::uint64_t clock_hz = 0;                ///< 0: not known
  bool clock_sure = false;                   ///< the user has named it
  std::vector<std::string> trusted_folders;  ///< include folders that the user named
  std::string hash;                          ///< of all sources
};

/// Reads info.yaml; sources lie in src/ or beside it, and in the folder unless `reading.trust`.
/// Throws UsageError that names file and line, what is wrong and what to do.
TtProject read_tt_project(const std::string& folder, const TtReading& reading = {});

/// A path lies in a folder, links resolved.
bool lies_in(const std::string& path, const std::string& folder);

}  // namespace racebeam
