// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/voxel_twins.h"

#include <cstdint>

#include "sc/base/constants.h"
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
  return LegalInputs({
      {"level_i", below(voxel_levels(k).count())},
      {"y_i", [](Raw raw) { return static_cast<Raw>(FirstLine) + raw % FrameLines; }},
  });
}

}  // namespace racebeam
