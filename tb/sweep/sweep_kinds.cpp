// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_kinds.h"

#include <stdexcept>

#include "sc/beam/engine.h"
#include "sc/beam/silicon.h"
#include "sc/block/engine.h"
#include "sc/block/silicon.h"
#include "sc/sphere/engine.h"
#include "sc/sphere/silicon.h"
#include "sc/voxel/engine.h"
#include "sc/voxel/silicon.h"
#include "tb/sweep/model_hash.h"

namespace racebeam {

const std::vector<SweepKind>& sweep_kinds() {
  static const std::vector<SweepKind> table = {
      {beam_engine(),
       {true, SweepReference::Base},
       {"error_pixels", "visible_error_pixels"},
       {"picture_error", "starved", "busy.max"},
       {"busy_clocks.max", "seen_starved_pixels"},
       {"speed", "interlace"},
       beam_silicon,
       make_beam_frame_judge},
      {sphere_engine(),
       {false, SweepReference::Geometry},
       {"pixels", "golden_error_pixels", "golden_level_pixels"},
       {"picture_error", "clocks", "stalls"},
       {"clocks", "buffer_stalls"},
       {"clocks_per_pixel", "host_clocks_per_word", "capture_guard", "as_built"},
       sphere_silicon,
       make_sphere_frame_judge},
      {block_engine(),
       {false, SweepReference::Geometry},
       {"pixels", "golden_error_pixels", "golden_level_pixels"},
       {"picture_error", "clocks", "cores.busy"},
       {"clocks", "bus_stalls"},
       {"time_skip", "load_bar"},
       block_silicon,
       make_block_frame_judge},
      {voxel_engine(),
       {false, SweepReference::Geometry},
       {"pixels", "golden_error_pixels", "golden_level_pixels"},
       {"picture_error", "clocks", "fetches"},
       {"clocks", "buffer_stalls"},
       {"build_chunk"},
       voxel_silicon,
       make_voxel_frame_judge}};
  return table;
}

const SweepKind& sweep_kind(const engine& built) {
  for (const SweepKind& kind : sweep_kinds())
    if (std::string(kind.engine.name) == built.name) return kind;
  throw std::out_of_range(std::string("no sweeps of ") + built.name);
}

const engine* engine_of_model(const std::string& hash) {
  for (const SweepKind& kind : sweep_kinds())
    if (model_hash(kind.engine.name) == hash) return &kind.engine;
  return nullptr;
}

}  // namespace racebeam
