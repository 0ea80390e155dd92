// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_build.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace racebeam {

namespace {

constexpr std::uint64_t All = ~std::uint64_t{0};
constexpr int Octet = VoxelTile / 2;  // voxels along the side of a tile, seen from the next level

using tile_words = std::array<std::uint32_t, VoxelTileWords>;

/// Voxels of a column, z in bits 0 to 255.
class heights {
 public:
  void add(int from, int end) {
    for (int at = from / 64; at * 64 < end; ++at)
      words_[static_cast<std::size_t>(at)] |= below(end - at * 64) & ~below(from - at * 64);
  }
  /// Eight of them.
  std::uint32_t byte(int tile) const {
    return static_cast<std::uint32_t>(words_[static_cast<std::size_t>(tile / 8)] >> tile % 8 * 8) &
           255;
  }

 private:
  static std::uint64_t below(int bits) {
    return bits <= 0 ? 0 : bits >= 64 ? All : (std::uint64_t{1} << bits) - 1;
  }
  std::array<std::uint64_t, VoxelMaxHeight / 64> words_{};
};

/// Calls visit(x, y, part) for the squares of side * side that a rectangle touches; `part`: what of
/// it is in the square.
template <class Visit>
void each_square(const voxel_rectangle& r, int side, Visit visit) {
  for (int y = r.y_low / side; y * side < r.y_high; ++y)
    for (int x = r.x_low / side; x * side < r.x_high; ++x)
      visit(
          x, y,
          voxel_rectangle{std::max(r.x_low, x * side), std::max(r.y_low, y * side),
                          std::min(r.x_high, (x + 1) * side), std::min(r.y_high, (y + 1) * side)});
}

template <class Visit>
void each_place(const voxel_rectangle& r, Visit visit) {
  for (int y = r.y_low; y < r.y_high; ++y)
    for (int x = r.x_low; x < r.x_high; ++x) visit(x, y);
}

std::uint64_t area(const voxel_rectangle& r) {
  return static_cast<std::uint64_t>(r.x_high - r.x_low) *
         static_cast<std::uint64_t>(r.y_high - r.y_low);
}

/// The bit of a voxel in its tile.
std::uint32_t cell(int x, int y, int z) {
  return voxel_morton(static_cast<std::uint32_t>(x % VoxelTile),
                      static_cast<std::uint32_t>(y % VoxelTile),
                      static_cast<std::uint32_t>(z % VoxelTile));
}

std::uint32_t* tile_of(voxel_world& world, int level, int x, int y, int z) {
  const voxel_level& at = world.levels().level(level);
  const auto tile = static_cast<std::uint32_t>((z * at.tiles[1] + y) * at.tiles[0] + x);
  return world.occupancy().data() + at.offset + VoxelTileWords * tile;
}

/// Clocks of a read, or of a read and a write of what was read.
std::uint64_t access(int memory_clocks) { return 1 + static_cast<std::uint64_t>(memory_clocks); }

/// Adds a column's voxels; how many they are.
int add(const voxel_column& c, int bits, int top, heights& to) {
  const auto up = [&](int z) { return std::min(top, (z + (1 << bits) - 1) >> bits); };
  const int low = up(c.low);
  to.add(0, low);
  if (c.middle >= c.high) return low;
  const int middle = std::max(low, c.middle >> bits), high = up(c.high);
  to.add(middle, high);
  return low + std::max(0, high - middle);
}

/// Sets the bits of the voxel column (x, y).
void put(voxel_world& world, int x, int y, const heights& solid) {
  const voxel_level& at = world.levels().level(0);
  const std::uint32_t first = cell(x, y, 0);
  // z is in bits 2, 5 and 8 of a bit's place: in the word, and as bits 0 and 3 of its number.
  constexpr std::uint32_t Pairs[] = {0, 1, 1 << 4, 1 | 1 << 4};
  constexpr std::size_t Words[] = {0, 1, 8, 9};
  for (int z = 0; z < at.tiles[2]; ++z) {
    const std::uint32_t eight = solid.byte(z);
    if (!eight) continue;
    std::uint32_t* words = tile_of(world, 0, x / VoxelTile, y / VoxelTile, z) + (first >> 5);
    for (std::size_t pair = 0; pair < 4; ++pair)
      words[Words[pair]] |= Pairs[eight >> 2 * pair & 3] << (first & 31);
  }
}

/// Clocks to look at children, as bits of a byte, and to write what was found.
struct look_clocks {
  std::array<std::uint64_t, 256> of{};

  explicit look_clocks(int memory_clocks) {
    for (std::size_t children = 0; children < of.size(); ++children) {
      std::uint64_t looks = 1;
      while (looks < 8 && !(children >> (looks - 1) & 1)) ++looks;
      of[children] = (looks + 1) * access(memory_clocks);
    }
  }
};

/// Voxels above a tile: n-th bit of the result: a child is in the n-th byte of the tile. Adds the
/// clocks of those in `mask`.
std::uint64_t above(const std::uint32_t* tile, std::uint64_t mask, const look_clocks& clocks,
                    std::uint64_t& spent) {
  std::uint64_t found = 0;
  for (int n = 0; n < 64; ++n) {
    const std::uint32_t children = tile[n / 4] >> n % 4 * 8 & 255;
    found |= std::uint64_t{children != 0} << n;
    spent += clocks.of[children] & (0 - (mask >> n & 1));
  }
  return found;
}

}  // namespace

voxel_rectangle voxel_aligned(const voxel_rectangle& columns, const voxel_levels& levels,
                              int level) {
  const int x = levels.voxel_bits()[0] + level, y = levels.voxel_bits()[1] + level;
  return {columns.x_low >> x, columns.y_low >> y, (columns.x_high + (1 << x) - 1) >> x,
          (columns.y_high + (1 << y) - 1) >> y};
}

std::uint64_t voxel_clear(voxel_world& world, const voxel_rectangle& columns, int memory_clocks) {
  const voxel_rectangle voxels = voxel_aligned(columns, world.levels(), 0);
  const voxel_level& level = world.levels().level(0);
  each_square(voxels, VoxelTile, [&](int x, int y, const voxel_rectangle& part) {
    tile_words cleared{};
    if (area(part) == VoxelTile * VoxelTile) cleared.fill(~0u);
    else
      each_place(part, [&](int voxel_x, int voxel_y) {
        for (int z = 0; z < VoxelTile; ++z) {
          const std::uint32_t bit = cell(voxel_x, voxel_y, z);
          cleared[bit >> 5] |= 1u << (bit & 31);
        }
      });
    for (int z = 0; z < level.tiles[2]; ++z) {
      std::uint32_t* tile = tile_of(world, 0, x, y, z);
      for (std::size_t n = 0; n < cleared.size(); ++n) tile[n] &= ~cleared[n];
    }
  });
  return area(voxels) * static_cast<std::uint64_t>(level.sides[2]) * access(memory_clocks);
}

std::uint64_t voxel_fill(voxel_world& world, const voxel_rectangle& columns, int memory_clocks) {
  const voxel_rectangle voxels = voxel_aligned(columns, world.levels(), 0);
  const vec3 bits = world.levels().voxel_bits();
  const int top = world.levels().level(0).sides[2];
  std::uint64_t set = 0;
  // Tile by tile, so that what is written stays near.
  each_square(voxels, VoxelTile, [&](int, int, const voxel_rectangle& part) {
    each_place(part, [&](int x, int y) {
      heights solid;
      for (int j = y << bits[1]; j < (y + 1) << bits[1]; ++j)
        for (int i = x << bits[0]; i < (x + 1) << bits[0]; ++i)
          set += static_cast<std::uint64_t>(add(world.column(i, j), bits[2], top, solid));
      put(world, x, y, solid);
    });
  });
  const std::uint64_t all = area(voxels) << (bits[0] + bits[1]);
  return all * (access(memory_clocks) + static_cast<std::uint64_t>(top)) +
         set * access(memory_clocks);
}

std::uint64_t voxel_up(voxel_world& world, const voxel_rectangle& columns, int memory_clocks) {
  const voxel_levels& levels = world.levels();
  const look_clocks clocks(memory_clocks);
  std::uint64_t spent = 0;
  for (int k = 1; k < levels.count(); ++k) {
    const voxel_rectangle voxels = voxel_aligned(columns, levels, k);
    const int top = levels.level(k).sides[2];
    // The children in a tile below are of 4 x 4 x 4 voxels, whose bits follow each other.
    each_square(voxels, Octet, [&](int x, int y, const voxel_rectangle& part) {
      for (int z = 0; z * Octet < top; ++z) {
        std::uint64_t mask = All;
        if (area(part) < Octet * Octet || (z + 1) * Octet > top) {
          mask = 0;
          each_place(part, [&](int voxel_x, int voxel_y) {
            for (int at = z * Octet; at < std::min((z + 1) * Octet, top); ++at)
              mask |= std::uint64_t{1} << cell(voxel_x % Octet, voxel_y % Octet, at % Octet);
          });
        }
        const std::uint64_t found = above(tile_of(world, k - 1, x, y, z), mask, clocks, spent);
        std::uint32_t* words = tile_of(world, k, x / 2, y / 2, z / 2) +
                               (cell(x % 2 * Octet, y % 2 * Octet, z % 2 * Octet) >> 5);
        for (int n = 0; n < 2; ++n) {
          const auto own = static_cast<std::uint32_t>(mask >> 32 * n);
          words[n] = (words[n] & ~own) | (static_cast<std::uint32_t>(found >> 32 * n) & own);
        }
      }
    });
  }
  return spent;
}

void expect_buildable(const voxel_rectangle& r, const vec3& size) {
  if (voxel_buildable(r, size)) return;
  const auto text = [](int number) { return std::to_string(number); };
  throw std::invalid_argument("columns " + text(r.x_low) + ".." + text(r.x_high) + " by " +
                              text(r.y_low) + ".." + text(r.y_high) +
                              " cannot be built; low < high, in 0.." + text(size[0]) + " by 0.." +
                              text(size[1]));
}

voxel_built voxel_build(voxel_world& world, const voxel_rectangle& columns, int memory_clocks) {
  expect_buildable(columns, world.levels().size());
  voxel_built built;
  built.clear = voxel_clear(world, columns, memory_clocks);
  built.fill = voxel_fill(world, columns, memory_clocks);
  built.up = voxel_up(world, columns, memory_clocks);
  built.clocks = built.clear + built.fill + built.up;
  const vec3& bits = world.levels().voxel_bits();
  built.columns = area(voxel_aligned(columns, world.levels(), 0)) << (bits[0] + bits[1]);
  return built;
}

voxel_built voxel_build(voxel_world& world, int memory_clocks) {
  const vec3& size = world.levels().size();
  return voxel_build(world, {0, 0, size[0], size[1]}, memory_clocks);
}

}  // namespace racebeam
