// A number of a scene file that moves: [camera] yaw = { start = 0, step = 2 }.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/scene/table_reader.h"

namespace racebeam {

/// A turn given by itself or by its start alone, from a frame on; what it does not say starts
/// afresh. `units`: it counts modulo these.
void read_turn(const TableReader& camera, const std::string& key, int units, int frame, Turn& turn,
               const std::vector<FileKey>& keys = scene_keys());

}  // namespace racebeam
