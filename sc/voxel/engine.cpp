// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/engine.h"

#include <stdexcept>
#include <string>

#include "sc/voxel/counters.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/units.h"
#include "sc/voxel/voxel_chip.h"
#include "sc/voxel/voxel_parameters.h"
#include "sc/voxel/voxel_tables.h"

namespace racebeam {

namespace {

constexpr std::uint64_t MostBytes = std::uint64_t{1} << 30;  // of both memories

knob_values standard_knobs(const scene_tables* scene) {
  static const voxel_tables builtin;
  const voxel_tables& tables = scene ? *static_cast<const voxel_tables*>(scene) : builtin;
  voxel_knobs k;
  k.size_x = tables.size[0];
  k.size_y = tables.size[1];
  k.size_z = tables.size[2];
  k.voxel_x = tables.voxel[0];
  k.voxel_y = tables.voxel[1];
  k.voxel_z = tables.voxel[2];
  k.picture_width = tables.width;
  k.picture_height = tables.height;
  return k;
}

std::string settle(knob_values&) { return ""; }

std::string objection(const knob_values& values, const scene_tables*) {
  const voxel_knobs k = values;
  try {
    const voxel_levels levels(k);
    const std::uint64_t columns =
        static_cast<std::uint64_t>(k.size_x) * static_cast<std::uint64_t>(k.size_y);
    const std::uint64_t bytes = 4 * (columns + levels.words());
    if (bytes > MostBytes)
      return "the world takes " + std::to_string(bytes >> 20) +
             " MiB of memory: 1024 at most; make it smaller or its voxels larger";
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  if (k.leaf == VoxelLeafVoxel && k.voxel() != vec3{1, 1, 1})
    return "leaf=voxel is for voxels of 1 x 1 x 1: others are not solid as a whole";
  return "";
}

video_clocks video(const knob_values&) { return {voxel_knobs::clocks_per_pixel}; }

std::vector<rtl_parameter> parameters(const knob_values& k) { return voxel_parameters(k); }

}  // namespace

const engine& voxel_engine() {
  static const engine row = {"voxel",
                             "octree tracer of height fields with caves",
                             {"tlm", "signal"},
                             "",
                             false,
                             voxel_unit_table(),
                             voxel_knob_rows(),
                             voxel_counter_infos(),
                             voxel_histogram_infos(),
                             {},
                             {{"u_voxel_walker.state_q", voxel_state_words()},
                              {"u_voxel_scan.state_q", voxel_scan_words()},
                              {"u_voxel_builder.state_q", voxel_builder_words()}},
                             standard_knobs,
                             settle,
                             objection,
                             video,
                             make_voxel_chip,
                             parameters};
  return row;
}

}  // namespace racebeam
