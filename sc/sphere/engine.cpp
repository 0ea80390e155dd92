// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/engine.h"

#include <string>

#include "sc/sphere/counters.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_chip.h"
#include "sc/sphere/sphere_parameters.h"
#include "sc/sphere/sphere_scene.h"
#include "sc/sphere/units.h"

namespace racebeam {

namespace {

const sphere_tables& tables_of(const scene_tables* scene) {
  static const sphere_tables built_in;
  return scene ? *static_cast<const sphere_tables*>(scene) : built_in;
}

knob_values standard_knobs(const scene_tables*) { return sphere_knobs(); }

std::string settle(knob_values& values) {
  const sphere_knobs k = values;
  if (!k.as_built) return "";
  values = k.resolved();
  std::string told;
  for (const knob_row& row : values.rows())
    for (const char* name : {"write_each_pass", "when_full", "table_entries"})
      if (std::string(name) == row.name)
        told += (told.empty() ? "as_built=on: " : ", ") + std::string(name) + "=" +
                row.text(values.of(name));
  return told;
}

std::string objection(const knob_values& values, const scene_tables* scene) {
  const sphere_knobs k = sphere_knobs(values).resolved();
  const int spheres = tables_of(scene).spheres;
  if (spheres < k.table_entries) return "";
  return "table_entries=" + std::to_string(k.table_entries) + " holds " +
         std::to_string(k.table_entries - 1) + " spheres and the light; the scene has " +
         std::to_string(spheres) +
         " spheres, and needs table_entries=" + std::to_string(spheres + 1);
}

video_clocks video(const knob_values& values) { return {sphere_knobs(values).clocks_per_pixel}; }

std::vector<rtl_parameter> parameters(const knob_values& k) { return sphere_knob_parameters(k); }

}  // namespace

const engine& sphere_engine() {
  static const engine row = {"sphere",
                             "fixed-point sphere tracer with a frame store and a host",
                             {"tlm", "signal"},
                             "",
                             false,
                             sphere_unit_table(),
                             sphere_knob_rows(),
                             sphere_counter_infos(),
                             sphere_histogram_infos(),
                             {},
                             {{"u_sphere_tracer.state_q", sphere_state_words()}},
                             standard_knobs,
                             settle,
                             objection,
                             video,
                             make_sphere_chip,
                             parameters};
  return row;
}

}  // namespace racebeam
