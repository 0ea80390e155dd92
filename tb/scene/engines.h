// The engines, in one table: what takes an engine, or what one engine alone has, by its name asks
// here. Names of units are unique among all engines, as names of RTL modules are.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

const std::vector<const engine*>& engines();

/// The engine of a unit, or of a whole chip. Throws std::out_of_range.
const engine& engine_of_unit(const std::string& unit);

}  // namespace racebeam
