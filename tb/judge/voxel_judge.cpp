// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/voxel_judge.h"

#include <algorithm>
#include <cstdlib>

#include "sc/voxel/voxel_colour.h"
#include "sc/voxel/voxel_tracer.h"
#include "tb/bench/store_pins.h"
#include "tb/golden/voxel_golden.h"
#include "tb/judge/hit_maps.h"

namespace racebeam {

namespace {

constexpr int Bits = 8, Levels = 1 << Bits;

/// A column's solid.
struct Met {
  bool sky = true;
  int x = 0, y = 0;
  bool upper = false;
};

Met met(const VoxelGolden::Hit& hit) { return {hit.sky, hit.x, hit.y, hit.upper}; }

/// Columns from one to the other in a world that repeats.
int apart(int a, int b, int size) {
  const int way = voxel_wrapped(a - b, size);
  return std::min(way, size - way);
}

/// A sample that missed the edge of a column is in the next one: that is right.
bool wrong(const Met& chip, const Met& golden, const vec3& size) {
  if (chip.sky || golden.sky) return chip.sky != golden.sky;
  return apart(chip.x, golden.x, size[0]) > 1 || apart(chip.y, golden.y, size[1]) > 1;
}

/// What a pixel shows, as voxel_shade takes it.
Met met(const voxel_end& end, bool down, const voxel_world& world) {
  if (end.kind == VoxelSky) return {};
  const int x = end.position[0] >> VoxelPositionFraction;
  const int y = end.position[1] >> VoxelPositionFraction;
  const int z = end.position[2] >> VoxelPositionFraction;
  return {false, x, y, voxel_surface_of(world.column(x, y), z, down).upper};
}

voxel_world built(const VoxelShow& show, const voxel_knobs& k) {
  return {voxel_levels(k), show.columns()};
}

Met met(const voxel_world& world, const voxel_knobs& k, const voxel_view& view, int x, int y) {
  voxel_walked walked;
  const voxel_ray ray{view.origin, voxel_direction(view, x, y)};
  return met(voxel_walk(world, k, ray, {k.max_outer, k.max_inner}, walked), ray.direction[2] < 0,
             world);
}

/// What the program calls it.
int object(const Met& met, const voxel_world& world, const VoxelProgram& program) {
  if (met.sky) return HitMap::Nothing;
  return program.object(world.column_address(met.x, met.y), met.upper);
}

VoxelShow at_picture(const scene_tables* scene, const voxel_knobs& k, int picture) {
  VoxelShow show(voxel_program_of(scene), k);
  show.go_to(picture);
  show.next();
  return show;
}

template <class Hit>
std::vector<int> all_pixels(const voxel_knobs& k, const Hit& hit) {
  std::vector<int> hits;
  for (int y = 0; y < k.picture_height; ++y)
    for (int x = 0; x < k.picture_width; ++x) hits.push_back(hit(x, y));
  return hits;
}

}  // namespace

std::vector<int> voxel_first_hits(const VoxelShow& show, const voxel_knobs& k) {
  const voxel_world world = built(show, k);
  return all_pixels(k, [&](int x, int y) {
    return object(met(world, k, show.view(), x, y), world, show.program());
  });
}

std::vector<int> voxel_golden_hits(const VoxelShow& show, const voxel_knobs& k) {
  const voxel_world world = built(show, k);
  const VoxelGolden golden(k, show.columns(), show.palette(), show.view());
  return all_pixels(
      k, [&](int x, int y) { return object(met(golden.hit(x, y)), world, show.program()); });
}

VgaFrame voxel_golden_picture(const scene_tables* scene, const knob_values& values, int picture) {
  const voxel_knobs k = values;
  const VoxelShow show = at_picture(scene, k, picture);
  const VoxelGolden golden(k, show.columns(), show.palette(), show.view());
  VgaFrame drawn;
  drawn.width = k.picture_width;
  drawn.height = k.picture_height;
  drawn.bits = Bits;
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x) {
      const auto [red, green, blue] = golden.pixel(x, y);
      drawn.push(static_cast<std::uint32_t>((red << Bits | green) << Bits | blue));
    }
  drawn.image_crc = image_crc(drawn);
  return drawn;
}

PictureErrors voxel_golden_errors(const scene_tables* scene, const knob_values& values, int picture,
                                  const PackedPicture& chip, int step) {
  const voxel_knobs k = values;
  const VoxelShow show = at_picture(scene, k, picture);
  const voxel_world world = built(show, k);
  const VoxelGolden golden(k, show.columns(), show.palette(), show.view());
  PictureErrors errors;
  errors.most = Levels - 1;
  for (int y = 0; y < chip.height; y += step)
    for (int x = 0; x < chip.width; x += step) {
      const std::uint32_t colour =
          chip.colour(static_cast<std::size_t>(y) * static_cast<std::size_t>(chip.width) +
                      static_cast<std::size_t>(x));
      const std::array<int, 3> wanted = golden.pixel(x, y);
      int most = 0;
      for (int c = 0; c < 3; ++c) {
        const int level = static_cast<int>(colour >> (2 - c) * Bits) & (Levels - 1);
        const int off = std::abs(level - wanted[static_cast<std::size_t>(c)]);
        most = std::max(most, off);
        errors.squares += static_cast<std::uint64_t>(off) * static_cast<std::uint64_t>(off);
      }
      ++errors.pixels;
      errors.differing += most > 0;
      errors.by_more += most > 1;
      errors.wrong_hits += wrong(met(world, k, show.view(), x, y), met(golden.hit(x, y)), k.size());
    }
  return errors;
}

}  // namespace racebeam
