// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/sphere_judge.h"

#include <zlib.h>

#include <algorithm>
#include <cstdlib>

#include "tb/bench/sphere_bench.h"
#include "tb/host/sphere_picture.h"

namespace racebeam {

SphereGoldenScene golden_scene(const SphereProgram& program, const sphere_knobs& k, int picture) {
  const sphere_inputs_core in = program.inputs_before(picture);
  SphereGoldenScene scene;
  scene.spheres = spheres_of(program, k, picture);
  scene.tables.planes = program.planes;
  scene.tables.start = {in.origin_q, in.light_q, in.screen_q};
  scene.columns = k.columns(in.narrow_q);
  scene.rows = sphere_knobs::rows(in.narrow_q);
  scene.reflections = in.max_reflections_q;
  scene.sub_rays = last_sub(in.alias_q) + 1;
  scene.planes = in.planes_q;
  scene.min_weight = k.min_weight;
  scene.colour_bits = k.colour_bits;
  scene.shadows = k.shadow_rays != 0;
  scene.plane_shadows = k.plane_shadows != 0;
  return scene;
}

VgaFrame sphere_golden_picture(const scene_tables* tables, const knob_values& values, int picture) {
  const sphere_knobs k = sphere_knobs(values).resolved();
  const SphereGoldenScene scene = golden_scene(sphere_program_of(tables), k, picture);
  const SphereGolden golden(scene);
  VgaFrame drawn;
  drawn.width = scene.columns;
  drawn.height = scene.rows;
  drawn.bits = scene.colour_bits;
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x) {
      const auto [red, green, blue] = golden.pixel(x, y);
      drawn.push(static_cast<std::uint32_t>((red << drawn.bits | green) << drawn.bits | blue));
    }
  drawn.image_crc = static_cast<std::uint32_t>(
      crc32(0, drawn.colours.data(), static_cast<uInt>(drawn.colours.size())));
  return drawn;
}

PictureErrors sphere_golden_errors(const scene_tables* tables, const knob_values& values,
                                   int picture, const PackedPicture& chip, int step) {
  const sphere_knobs k = sphere_knobs(values).resolved();
  const SphereProgram& program = sphere_program_of(tables);
  return sphere_errors(golden_scene(program, k, picture), program, k, picture, chip, step);
}

PictureErrors sphere_errors(const SphereGoldenScene& scene, const SphereProgram& program,
                            const sphere_knobs& k, int picture, const PackedPicture& chip,
                            int step) {
  const SphereGolden golden(scene);
  const auto core = core_before(program, k, picture);
  PictureErrors errors;
  errors.most = (1 << chip.bits) - 1;
  for (int y = 0; y < chip.height; y += step)
    for (int x = 0; x < chip.width; x += step) {
      const std::uint32_t colour = chip.colour(static_cast<std::size_t>(y) * chip.width + x);
      const std::array<int, 3> wanted = golden.pixel(x, y);
      int most = 0;
      for (int c = 0; c < 3; ++c) {
        const int level = static_cast<int>(colour >> (2 - c) * chip.bits) & errors.most;
        const int off = std::abs(level - wanted[static_cast<std::size_t>(c)]);
        most = std::max(most, off);
        errors.squares += static_cast<std::uint64_t>(off) * static_cast<std::uint64_t>(off);
      }
      ++errors.pixels;
      errors.differing += most > 0;
      errors.by_more += most > 1;
      errors.wrong_hits += golden.first_hit(x, y) != core->first_hit(x, y);
    }
  return errors;
}

}  // namespace racebeam
