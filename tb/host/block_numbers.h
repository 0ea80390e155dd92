// What the host sends the block renderer of a scene, number by number.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/block/block_world.h"

namespace racebeam {

/// As block_convert takes it.
struct BlockNumber {
  std::uint32_t bits;  ///< of a float
  int field;           ///< block_field
  int index;           ///< of the sphere
};

/// Eye, light and screen, then each sphere: centre, radius, colour.
std::vector<BlockNumber> block_numbers(const block_tables& tables);

}  // namespace racebeam
