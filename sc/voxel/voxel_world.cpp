// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_world.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "sc/voxel/voxel_build.h"

namespace racebeam {

namespace {

std::size_t columns_of(const voxel_levels& levels) {
  return static_cast<std::size_t>(levels.size()[0]) * static_cast<std::size_t>(levels.size()[1]);
}

}  // namespace

voxel_world::voxel_world(const voxel_levels& levels)
    : levels_(levels), columns_(columns_of(levels)), occupancy_(levels.words()) {}

voxel_world::voxel_world(const voxel_levels& levels, std::vector<std::uint32_t> columns)
    : levels_(levels), columns_(std::move(columns)), occupancy_(levels.words()) {
  if (columns_.size() != columns_of(levels))
    throw std::invalid_argument("a world of " + std::to_string(columns_of(levels)) +
                                " columns cannot have " + std::to_string(columns_.size()));
  build();
}

std::uint32_t voxel_world::column_address(int x, int y) const {
  const vec3& size = levels_.size();
  return static_cast<std::uint32_t>(voxel_wrapped(y, size[1])) *
             static_cast<std::uint32_t>(size[0]) +
         static_cast<std::uint32_t>(voxel_wrapped(x, size[0]));
}

void voxel_world::build() { voxel_build(*this); }

std::uint64_t voxel_world::bits_set() const {
  std::uint64_t count = 0;
  for (const std::uint32_t word : occupancy_)
    count += static_cast<unsigned>(__builtin_popcount(word));
  return count;
}

}  // namespace racebeam
