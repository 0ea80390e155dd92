// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/twins.h"

#include <stdexcept>
#include <string>

#include "sc/beam/engine.h"
#include "sc/beam/knob_parameters.h"
#include "sc/sphere/engine.h"
#include "tb/twin/beam_twins.h"
#include "tb/twin/sphere_twins.h"

namespace racebeam {

namespace {

Twins beam() {
  return {beam_engine(),
          [](const knob_values& k, const scene_tables* scene, bool traced) {
            return beam_plugins(k, scene, traced);
          },
          [](const knob_values& k) { return beam_inputs(k); },
          [](const knob_values& k, const scene_tables* scene) {
            return !scene && without_pins(k) == knobs();
          }};
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
          [](const knob_values& k) { return sphere_inputs_of(k); },
          // It has the pins of a memory that the chip has inside.
          [](const knob_values&, const scene_tables*) { return false; }};
}

}  // namespace

const std::vector<Twins>& twins() {
  static const std::vector<Twins> table = {beam(), sphere()};
  return table;
}

const Twins& twins_of(const engine& built) {
  for (const Twins& row : twins())
    if (&row.engine == &built) return row;
  throw std::out_of_range(std::string("no twins of ") + built.name);
}

}  // namespace racebeam
