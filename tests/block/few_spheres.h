// A scene of which most blocks are cleared: small enough for the wired chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/block/block_world.h"

namespace racebeam {

/// Five small spheres; some mirror others.
inline block_tables few_tables() {
  block_tables tables;
  tables.balls = {{{0.5f, 0.5f, 8}, 0.25f, {0.25f, 0.75f, 0.5f}},
                  {{0.625f, 0.75f, 7.5f}, 0.125f, {0.75f, 0.25f, 0.25f}},
                  {{0.75f, 0.25f, 8}, 0.125f, {0.25f, 0.25f, 0.75f}},
                  {{-5, 3, 6}, 0.125f, {0.75f, 0.75f, 0.25f}},
                  {{3, -2.5f, 4}, 0.125f, {0.5f, 0.5f, 0.5f}}};
  return tables;
}

}  // namespace racebeam
