// Knobs in a sweep file: one value each, or the values that a search takes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/scene/toml_tree.h"
#include "tb/sweep/sweep_file.h"

namespace racebeam {

/// Sets knobs of a point from a table { knob = value, ... }; what is wrong is added to the faults.
void read_point_knobs(const TomlNode& node, SweepPoint& point, Faults& faults);

/// [knobs]: values, lists of values, { from, to, step }, and `where`.
void read_swept_knobs(const TomlNode& node, SweepFile& file, Faults& faults);

}  // namespace racebeam
