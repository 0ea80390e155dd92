// `--use UNIT=IMPLEMENTATION,...`: which units of the chip are models, RTL, or both.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/knobs.h"
#include "sc/unit_choices.h"

namespace racebeam {

/// Adds choices such as "subdivider=rtl", "all=lockstep", "stacks=mine.sv", "stacks=mine.so", or
/// several with commas between; later ones replace earlier ones. SystemVerilog is verilated here,
/// with the parameters that `k` asks for. Throws UsageError, RtlError, MissingTool.
void use_units(unit_choices& choices, const std::string& text, const knobs& k);

/// The plug-in of a user's RTL: a .so as it is, a .sv verilated into a scratch folder that is
/// removed when the program ends. Throws UsageError, RtlError, MissingTool.
std::string user_plugin(const std::string& unit, const std::string& file, const knobs& k);

/// Refuses what a scene file cannot have: its rooms and shots are tables of the models. Throws
/// UsageError.
void check_tables(const unit_choices& choices, bool scene_file);

/// A unit of the chip. Throws UsageError with the nearest name.
void check_unit(const std::string& unit);

}  // namespace racebeam
