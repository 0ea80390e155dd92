// Plan: rooms from a floor plan drawn in characters.
//
// '#' is solid, '.' open, '@' open and called "start"; other letters are described in plan.cells.
// The first row is the most northern, the first storey the lowest. Each open cell is a room;
// a room meets all rooms of the neighbouring columns whose heights overlap with its own. Skylights
// and floor holes are shafts through the slab, rooms called "ID.up" and "ID.down"; they lead to the
// next cell of the column, or are niches. A shaft wider than its cell meets it in their common
// area. Each plan of a file has a set of its own, which the names of its rooms begin with.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "tb/scene/scene_file.h"
#include "tb/scene/toml_tree.h"

namespace racebeam {

/// Adds the rooms of a [plan] or of all [[plan]] tables and connects them. `text` is the whole
/// file: rows are looked up in it for their places.
void read_plans(const TomlNode& node, std::string_view text, std::vector<Room>& rooms,
                Faults& faults);

}  // namespace racebeam
