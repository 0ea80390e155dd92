// A build voxel by voxel, with a clock for each thing that is done: what builders are held to.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "sc/voxel/voxel_world.h"

namespace racebeam {

class PlainBuild {
 public:
  std::uint64_t clear = 0, fill = 0, up = 0, columns = 0;

  /// Changes the world's occupancy; `memory_clocks`: after those of its address, until a word is
  /// there.
  PlainBuild(voxel_world& world, const voxel_rectangle& rectangle, int memory_clocks = 1)
      : world_(world), levels_(world.levels()), read_(static_cast<unsigned>(memory_clocks) + 1) {
    const voxel_rectangle in = around(rectangle, 0);
    const vec3 side = {levels_.side(0, 0), levels_.side(0, 1), levels_.side(0, 2)};
    const int top = levels_.level(0).sides[2];
    for (int y = in.y_low; y < in.y_high; ++y)
      for (int x = in.x_low; x < in.x_high; ++x)
        for (int z = 0; z < top; ++z, clear += read_) put(0, x, y, z, false);
    for (int y = in.y_low * side[1]; y < in.y_high * side[1]; ++y)
      for (int x = in.x_low * side[0]; x < in.x_high * side[0]; ++x) {
        fill += read_;
        ++columns;
        for (int z = 0; z < top; ++z) {
          ++fill;
          if (!touches(world.column(x, y), z * side[2], side[2])) continue;
          put(0, x / side[0], y / side[1], z, true);
          fill += read_;
        }
      }
    for (int k = 1; k < levels_.count(); ++k) {
      const voxel_rectangle on = around(rectangle, k);
      for (int y = on.y_low; y < on.y_high; ++y)
        for (int x = on.x_low; x < on.x_high; ++x)
          for (int z = 0; z < levels_.level(k).sides[2]; ++z) look(k, x, y, z);
    }
  }

  std::uint64_t clocks() const { return clear + fill + up; }

 private:
  static bool touches(const voxel_column& c, int z, int side) {
    for (int at = z; at < z + side; ++at)
      if (c.solid(at)) return true;
    return false;
  }
  voxel_rectangle around(const voxel_rectangle& r, int k) const {
    const int x = levels_.side(k, 0), y = levels_.side(k, 1);
    return {r.x_low / x, r.y_low / y, (r.x_high + x - 1) / x, (r.y_high + y - 1) / y};
  }
  void put(int k, int x, int y, int z, bool value) {
    const voxel_place at = levels_.place(k, x, y, z);
    std::uint32_t& word = world_.occupancy()[at.word];
    word = value ? word | 1u << at.bit : word & ~(1u << at.bit);
  }
  void look(int k, int x, int y, int z) {
    bool found = false;
    for (int child = 0; child < 8 && !found; ++child, up += read_)
      found = world_.occupied(k - 1, 2 * x + (child & 1), 2 * y + (child >> 1 & 1),
                              2 * z + (child >> 2));
    put(k, x, y, z, found);
    up += read_;
  }

  voxel_world& world_;
  const voxel_levels& levels_;
  const unsigned read_;  // clocks of a read, and of a read and a write
};

inline int within(std::mt19937& random, int low, int high) {
  return std::uniform_int_distribution(low, high)(random);
}

/// Ground, and over some of it a roof.
inline std::uint32_t any_column(std::mt19937& random, int height) {
  voxel_column c;
  c.low = within(random, 0, height / 2);
  c.middle = within(random, c.low, height - 1);
  c.high = random() % 3 ? c.middle : within(random, c.middle, height - 1);
  return packed(c);
}

inline voxel_rectangle any_rectangle(std::mt19937& random, const vec3& size) {
  voxel_rectangle r;
  r.x_low = within(random, 0, size[0] - 1);
  r.y_low = within(random, 0, size[1] - 1);
  r.x_high = within(random, r.x_low + 1, size[0]);
  r.y_high = within(random, r.y_low + 1, size[1]);
  return r;
}

/// New columns in a rectangle.
inline void change(voxel_world& world, const voxel_rectangle& r, std::mt19937& random) {
  for (int y = r.y_low; y < r.y_high; ++y)
    for (int x = r.x_low; x < r.x_high; ++x)
      world.columns()[world.column_address(x, y)] = any_column(random, world.levels().size()[2]);
}

}  // namespace racebeam
