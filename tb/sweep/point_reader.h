// [base] and [[point]] of a sweep file: the points that have names.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/scene/toml_tree.h"
#include "tb/sweep/sweep_file.h"

namespace racebeam {

/// Either node may be null.
void read_points(const TomlNode* base, const TomlNode* points, SweepFile& file, Faults& faults);

}  // namespace racebeam
