// The engines, in one table: what takes an engine, or what one engine alone has, by its name asks
// here. Units of one name in several engines are the same unit, as RTL modules are.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

const std::vector<const engine*>& engines();

/// The first engine that has a unit, or a whole chip. Throws std::out_of_range.
const engine& engine_of_unit(const std::string& unit);

/// The engine whose knobs these are. Throws std::out_of_range.
const engine& engine_of(const knob_values& k);

}  // namespace racebeam
