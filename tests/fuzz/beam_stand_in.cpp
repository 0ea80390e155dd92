// The interval tracer with its knobs and without its chip, as the only engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/engine.h"
#include "sc/beam/knobs.h"
#include "tb/base/console.h"
#include "tb/scene/engines.h"
#include "tests/fuzz/stand_in_engines.h"

// What set_knob would say on stderr.
void racebeam::tell(std::string_view) {}

namespace racebeam {

namespace {

engine knobs_only() {
  engine row = stand_in_engine("beam", knob_rows());
  row.standard = [](const scene_tables*) { return knob_values(knobs()); };
  row.settle = [](knob_values& values) {
    knobs k = values;
    k.max_room_depth = k.room_depth_limit();
    values = k;
    return std::string();
  };
  return row;
}

}  // namespace

const engine& beam_engine() {
  static const engine row = knobs_only();
  return row;
}

const std::vector<const engine*>& engines() {
  static const std::vector<const engine*> table = {&beam_engine()};
  return table;
}

const engine& engine_of(const knob_values&) { return beam_engine(); }

}  // namespace racebeam
