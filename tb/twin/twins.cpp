// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/twins.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "sc/beam/engine.h"
#include "sc/beam/knob_parameters.h"
#include "sc/beam/navigator.h"
#include "sc/beam/pwm_sound.h"
#include "sc/beam/scene_rom.h"
#include "sc/beam/sequencer.h"
#include "sc/beam/subdivider.h"
#include "sc/beam/timeline.h"
#include "sc/block/block_core.h"
#include "sc/block/block_scheduler.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/sphere/sphere_host_link.h"
#include "sc/sphere/sphere_shader.h"
#include "sc/sphere/sphere_tracer.h"
#include "sc/store/frame_scanout.h"
#include "sc/video/vga_timing.h"
#include "sc/voxel/engine.h"
#include "sc/voxel/voxel_builder.h"
#include "sc/voxel/voxel_scan.h"
#include "sc/voxel/voxel_walker.h"
#include "tb/twin/beam_twins.h"
#include "tb/twin/block_twins.h"
#include "tb/twin/block_walk.h"
#include "tb/twin/frame_walks.h"
#include "tb/twin/host_walk.h"
#include "tb/twin/shader_walk.h"
#include "tb/twin/sphere_twins.h"
#include "tb/twin/subdivider_walk.h"
#include "tb/twin/tracer_walk.h"
#include "tb/twin/tune_walk.h"
#include "tb/twin/voxel_twins.h"
#include "tb/twin/voxel_walks.h"

namespace racebeam {

namespace {

template <class Walk>
std::function<void()> begin_walk(UnitBench& bench, const knob_values& k, unsigned seed) {
  return [walk = std::make_shared<Walk>(bench, k, seed)] { walk->next(); };
}

// All engines have the same raster.
UnitWalk through_a_frame() {
  return {vga_timing::unit_name, "through a frame", FrameWalk::Clocks, begin_walk<FrameWalk>};
}

Twins beam() {
  return {beam_engine(),
          [](const knob_values& k, const scene_tables* scene, bool traced) {
            return beam_plugins(k, scene, traced);
          },
          [](const knob_values& k, const scene_tables* scene, const std::string& unit) {
            return unit == scene_rom::unit_name ? room_table_inputs(k, scene) : beam_inputs(k);
          },
          [](const knob_values& k, const scene_tables* scene) {
            return !scene && without_pins(k) == knobs();
          },
          {{pwm_sound::unit_name, "through its tune", TuneWalk::Clocks, begin_walk<TuneWalk>},
           {sequencer::unit_name, "through all frames", FramesWalk::Clocks, begin_walk<FramesWalk>},
           {timeline::unit_name, "through many frames", FramesWalk::Clocks, begin_walk<FramesWalk>},
           {subdivider::unit_name, "through full stacks", SubdividerWalk::Clocks,
            begin_walk<SubdividerWalk>},
           through_a_frame()},
          true,
          {sequencer::unit_name, timeline::unit_name, navigator::unit_name}};
}

// It has the pins of a memory that the chip has inside.
bool no_top(const knob_values&, const scene_tables*) { return false; }

/// `others`, or those of the unit that reads the frame memory.
LegalInputs inputs_of(const std::string& unit, LegalInputs others) {
  return unit == frame_scanout::unit_name ? LegalInputs({scan_line()}) : std::move(others);
}

const sphere_tables& tables_of(const scene_tables* scene) {
  static const sphere_tables built_in;
  return scene ? *static_cast<const sphere_tables*>(scene) : built_in;
}

Twins sphere() {
  return {sphere_engine(),
          [](const knob_values& k, const scene_tables* scene, bool traced) {
            return sphere_plugins(k, tables_of(scene), traced);
          },
          [](const knob_values&, const scene_tables*, const std::string& unit) {
            return inputs_of(unit, LegalInputs({}));
          },
          no_top,
          {{sphere_tracer::unit_name, "to the end of two pictures", TracerWalk::Clocks,
            begin_walk<TracerWalk>},
           {sphere_host_link::unit_name, "until no CPU is there", HostWalk::Clocks,
            begin_walk<HostWalk>},
           {sphere_shader::unit_name, "through pixels", ShaderWalk::Clocks, begin_walk<ShaderWalk>},
           through_a_frame()}};
}

Twins block() {
  return {
      block_engine(),
      [](const knob_values& k, const scene_tables*, bool traced) {
        return block_plugins(k, traced);
      },
      [](const knob_values& k, const scene_tables*, const std::string& unit) {
        return inputs_of(unit, block_inputs_of(k));
      },
      no_top,
      {{block_core::unit_name, "through whole blocks", BlockWalk::Clocks, begin_walk<BlockWalk>},
       {block_scheduler::unit_name, "through pictures", DealWalk::Clocks, begin_walk<DealWalk>},
       through_a_frame()}};
}

Twins voxel() {
  return {
      voxel_engine(),
      [](const knob_values& k, const scene_tables*, bool traced) {
        return voxel_plugins(k, traced);
      },
      [](const knob_values& k, const scene_tables*, const std::string& unit) {
        return inputs_of(unit, voxel_inputs_of(k));
      },
      no_top,
      {{voxel_builder::unit_name, "through the world", BuildWalk::Clocks, begin_walk<BuildWalk>},
       {voxel_scan::unit_name, "to the end of a picture", PictureWalk::Clocks,
        begin_walk<PictureWalk>},
       {voxel_walker::unit_name, "along rays", RayWalk::Clocks, begin_walk<RayWalk>},
       through_a_frame()}};
}

}  // namespace

const UnitWalk* Twins::walk(const std::string& unit) const {
  for (const UnitWalk& one : walks)
    if (unit == one.unit) return &one;
  return nullptr;
}

const std::vector<Twins>& twins() {
  static const std::vector<Twins> table = {beam(), sphere(), block(), voxel()};
  return table;
}

const Twins& twins_of(const engine& built) {
  for (const Twins& row : twins())
    if (&row.engine == &built) return row;
  throw std::out_of_range(std::string("no twins of ") + built.name);
}

}  // namespace racebeam
