// What the files beside a Tiny Tapeout project's info.yaml say about how to read its sources. A
// file that cannot be read, or is not as the template has it, says nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace racebeam {

struct TtSettings {
  std::vector<std::string> include_folders;
  std::vector<std::string> defines;  ///< "NAME" or "NAME=VALUE"
};

/// VERILOG_INCLUDE_DIRS and VERILOG_DEFINES or SYNTH_DEFINES of a config.json of LibreLane, which
/// lies in `folder`.
TtSettings read_config_json(std::istream& in, const std::string& folder);

/// The -D of COMPILE_ARGS in a Makefile of cocotb, but those of its gate-level part.
std::vector<std::string> read_test_defines(std::istream& in);

}  // namespace racebeam
