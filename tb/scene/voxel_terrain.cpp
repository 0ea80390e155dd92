// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_terrain.h"

#include <algorithm>
#include <cmath>

#include "sc/voxel/voxel_world.h"
#include "tb/scene/value_noise.h"

namespace racebeam {

namespace {

constexpr int Cell = 128;  // units of the coarsest octave

/// Calls column(x, y) for all.
template <class Column>
std::vector<std::uint32_t> columns_of(const vec3& size, Column&& column) {
  std::vector<std::uint32_t> columns;
  columns.reserve(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x) columns.push_back(packed(column(x, y)));
  return columns;
}

/// Solid up to a height.
voxel_column ground(int height, int material, const vec3& size) {
  height = std::clamp(height, 0, voxel_top(size));
  return {height, height, height, material, material};
}

std::uint32_t hash(int x, int y, int n, int seed) {
  return hash_of(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                 static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(seed));
}

/// What noise is seldom beyond, to the whole of 0..1.
double stretched(double noise) { return std::clamp((noise - 0.2) / 0.6, 0.0, 1.0); }

/// Puts a roof over the ground: `share` of its thickest, 0..1; its edges are thin.
void add_roof(double underside, double share, const vec3& size, voxel_column& to) {
  const int middle = static_cast<int>(underside);
  const int high = std::min(middle + 1 + static_cast<int>(share * size[2] / 8), voxel_top(size));
  if (to.low >= high) return;
  if (to.low >= middle) {
    to = ground(high, Roof, size);
    return;
  }
  to.middle = middle;
  to.high = high;
  to.high_material = Roof;
}

}  // namespace

int ground_material(int height, const vec3& size) {
  const int share = height * 128 / size[2];
  return share < 10 ? Sand : share < 30 ? Meadow : share < 58 ? Forest : share < 82 ? Rock : Snow;
}

std::vector<std::uint32_t> tiny_terrain(const vec3& size) {
  return columns_of(size, [&](int x, int y) {
    return ground(4 + ((7 * x + 13 * y) & 7) + (x == 20 && y == 30 ? 16 : 0), Meadow, size);
  });
}

std::vector<std::uint32_t> hills_terrain(const vec3& size, const HillsTerrain& how) {
  enum { Post = 100, PostHeight };  // numbers of hashes, beside those of octaves
  constexpr double Roofed = 0.58;   // of noise; above it there is a roof
  const ValueNoise heights(size[0], size[1], Cell, how.octaves, how.seed);
  const ValueNoise roofs(size[0], size[1], Cell / 2, 3, how.seed + 1);
  const ValueNoise undersides(size[0], size[1], Cell, 2, how.seed + 2);
  const double unit = size[2] / 128.0;
  return columns_of(size, [&](int x, int y) {
    const double noise = stretched(heights.at(x, y));
    const int low = static_cast<int>(unit * (4 + 96 * noise * noise));
    voxel_column column = ground(low, ground_material(low, size), size);
    if (how.caves) {
      const double roof = (roofs.at(x, y) - Roofed) / (1 - Roofed);
      if (roof > 0) add_roof(unit * (20 + 30 * undersides.at(x, y)), roof, size, column);
    }
    if (how.posts && hash(x, y, Post, how.seed) % static_cast<unsigned>(how.posts) == 0) {
      const int post = 20 + static_cast<int>(hash(x, y, PostHeight, how.seed) % 21);
      column =
          ground(std::max(column.low, column.high) + static_cast<int>(unit * post), Wood, size);
    }
    return column;
  });
}

std::vector<std::uint32_t> canyon_terrain(const vec3& size, const CanyonTerrain& how) {
  enum { Left = 100, Right, Stones };
  const ValueNoise plain(size[0], size[1], Cell, 4, how.seed);
  const double unit = size[2] / 128.0;
  const auto rough = [&](int y, int side) {
    return static_cast<int>(hash(0, y, side, how.seed) % 3);
  };
  return columns_of(size, [&](int x, int y) {
    const int from = voxel_wrapped(x - how.offset, size[0]);
    const bool inside =
        from >= size[0] / 4 + rough(y, Left) && from < size[0] * 3 / 4 - rough(y, Right);
    const bool stone = hash(x, y, Stones, how.seed) % 64 == 0;
    const int low = static_cast<int>(
        unit * (inside ? 6 + 8 * plain.at(x, y) + (stone ? 3 : 0) : 80 + 24 * plain.at(x, y)));
    return ground(low, inside ? Sand : Rock, size);
  });
}

std::vector<std::uint32_t> picture_terrain(const vec3& size, const PictureTerrain& pictures) {
  const auto height = [&](const GreyPicture& of, int x, int y) {
    const int white = voxel_top(size), most = (1 << of.bits) - 1;
    return static_cast<int>((std::int64_t{of.at(x, y)} * white + most / 2) / most);
  };
  return columns_of(size, [&](int x, int y) {
    const int row = size[1] - 1 - y;
    voxel_column column;
    column.low = column.middle = column.high = height(*pictures.low, x, row);
    if (pictures.middle && pictures.high && pictures.high->at(x, row)) {
      column.middle = height(*pictures.middle, x, row);
      column.high = height(*pictures.high, x, row);
    }
    column.low_material = ground_material(column.low, size);
    column.high_material = Roof;
    if (pictures.materials)
      column.low_material = column.high_material =
          pictures.materials->at(x, row) >> (pictures.materials->bits - 3);
    return column;
  });
}

}  // namespace racebeam
