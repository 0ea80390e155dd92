// The units of the chip, in one table: what takes a unit by its name asks here.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

/// In the order of the contract.
const std::vector<unit_row>& unit_table();

/// Throws std::out_of_range.
const unit_row& unit_named(const std::string& name);

/// The units of a chip that shows the built-in demo, or a scene file.
std::vector<std::string> chip_units(bool scene_file);

/// All units wired in RTL: only beside the chip, in lockstep.
constexpr const char* WholeChip = "racebeam_top";

/// Name of the instance that a unit is in chip.
std::string instance_of(const std::string& unit);

}  // namespace racebeam
