// Plug-ins of verilated RTL: where they are, and how they are made.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/knobs.h"
#include "sc/rtl_library.h"

namespace racebeam {

/// The folder of this project's RTL: of the sources, or where it is installed.
std::string rtl_folder();

/// The plug-in of a unit's own RTL in the folder `rtl` beside the program, or, when installed, in
/// ../lib/racebeam. Where `k` asks for other parameters than it was built with, one with those,
/// built when it is asked for the first time, in the same folder or
/// the user's cache. `traced`: likewise one whose inner signals can be read. Throws RtlError.
std::string rtl_plugin_path(const std::string& unit, const knobs& k, bool traced = false);

/// The parameters, "Name=value", that RTL was built with and `k` wants otherwise.
std::vector<std::string> other_parameters(const rtl_model& model, const knobs& k);

/// Verilates RTL of a unit, the unit's own if there are no `sources`, into the plug-in `out`, with
/// parameters "Name=value"; `traced`: its inner signals can be read. Throws RtlError with what
/// Verilator says.
void build_rtl_plugin(const std::string& unit, std::vector<std::string> sources,
                      const std::vector<std::string>& parameters, const std::string& out,
                      bool traced = false);

/// The same of a whole chip, whose inputs, but `clk`, pass a register: they count one clock later.
void build_chip_plugin(const std::string& top, const std::vector<std::string>& sources,
                       const std::string& out);

}  // namespace racebeam
