// Scenes of the block renderer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/block/block_world.h"

namespace racebeam {

inline block_tables quad_tables() {
  block_tables tables;
  tables.balls = {{{0, 0, 6}, 2.5f, {0.25f, 0.75f, 0.5f}},
                  {{-2, 1, 2}, 0.75f, {0.75f, 0.25f, 0.25f}},
                  {{2, -1, 3}, 0.75f, {0.25f, 0.25f, 0.75f}},
                  {{0.5f, 2, 1}, 0.75f, {0.75f, 0.75f, 0.25f}}};
  return tables;
}

}  // namespace racebeam
