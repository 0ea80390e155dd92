// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/engine.h"

#include "sc/base/constants.h"
#include "sc/beam/chip.h"
#include "sc/beam/counters.h"
#include "sc/beam/knob_parameters.h"
#include "sc/beam/units.h"

namespace racebeam {

namespace {

template <class Row>
auto infos_of(const std::vector<Row>& rows) {
  std::vector<decltype(Row::info)> infos;
  for (const Row& row : rows) infos.push_back(row.info);
  return infos;
}

const scene_program* program_of(const scene_tables* scene) {
  return static_cast<const scene_program*>(scene);
}

knob_values standard_knobs(const scene_tables* scene) {
  return scene ? program_of(scene)->fitted({}) : knobs();
}

std::string settle(knob_values& values) {
  knobs k = values;
  const int counts = k.room_depth_limit();
  if (counts == k.max_room_depth) return "";
  const std::string told = "max_room_depth=" + std::to_string(k.max_room_depth) + " counts as " +
                           std::to_string(counts) + ": a room takes an entry of face_stack_depth=" +
                           std::to_string(k.face_stack_depth) + ", and one is not for rooms";
  k.max_room_depth = counts;
  values = k;
  return told;
}

std::string objection(const knob_values& k, const scene_tables* scene) {
  if (!scene && knobs(k).corner_bits > CornerBits)
    return "corner_bits is at most " + std::to_string(CornerBits) +
           " in the built-in demo, whose rooms count modulo 4096; render a scene file for more";
  return "";
}

video_clocks video(const knob_values& values) {
  const knobs k = values;
  return {k.clocks_per_pixel, k.speed};
}

std::unique_ptr<wired_chip> make_chip(const char* name, const knob_values& k,
                                      const scene_tables* scene, const unit_choices& choices) {
  return std::make_unique<chip>(name, k, program_of(scene), choices);
}

std::vector<rtl_parameter> parameters(const knob_values& k) { return knob_parameters(k); }

}  // namespace

const engine& beam_engine() {
  static const engine row = {"beam",
                             "interval tracer that races the beam",
                             {"tlm", "signal"},
                             WholeChip,
                             true,
                             unit_table(),
                             knob_rows(),
                             infos_of(counter_table()),
                             infos_of(histogram_table()),
                             infos_of(line_table()),
                             {{"u_subdivider.state_q", {"left", "right", "bisect", "return"}},
                              {"u_camera_unit.phase_q", {"product", "load", "scale", "run"}},
                              {"u_navigator.nav_state_q",
                               {"idle", "to_plus", "check_plus", "check_minus", "finish", "store",
                                "adjust", "7", "try_plus", "try_done", "try_check_plus",
                                "try_check_minus", "try_next", "13", "14", "15"}}},
                             standard_knobs,
                             settle,
                             objection,
                             video,
                             make_chip,
                             parameters};
  return row;
}

}  // namespace racebeam
