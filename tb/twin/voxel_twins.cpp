// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/voxel_twins.h"

#include <cstdint>

#include "sc/voxel/voxel_levels.h"
#include "sc/voxel/voxel_parameters.h"

namespace racebeam {

PluginMaker voxel_plugins(const voxel_knobs& k, bool traced) {
  return PluginMaker(voxel_parameters(k), {}, traced);
}

LegalInputs voxel_inputs_of(const voxel_knobs& k) {
  using Raw = std::uint64_t;
  const auto below = [](int end) {
    return [end = static_cast<Raw>(end)](Raw raw) { return raw % end; };
  };
  // Mostly as a ray in the world has it; any at times.
  constexpr Raw Seldom = 8;
  const auto mostly_below = [](int end) {
    return
        [end = static_cast<Raw>(end)](Raw raw) { return raw % Seldom ? raw / Seldom % end : raw; };
  };
  constexpr int SmallRectangle = 12;  // columns: a larger one takes too long to build
  constexpr int Way = 64 << VoxelPositionFraction, Step = 2 << VoxelPositionFraction;
  return LegalInputs({
      {"level_i", below(voxel_levels(k).count())},
      {"rect_x_low_i", mostly_below(SmallRectangle), true},
      {"rect_y_low_i", mostly_below(SmallRectangle), true},
      {"rect_x_high_i", mostly_below(SmallRectangle), true},
      {"rect_y_high_i", mostly_below(SmallRectangle), true},
      {"origin_z_i", mostly_below(k.size_z << VoxelPositionFraction), true},
      {"t_from_i", mostly_below(Way), true},
      {"t_to_i", mostly_below(Way), true},
      {"step_i", mostly_below(Step), true},
  });
}

}  // namespace racebeam
