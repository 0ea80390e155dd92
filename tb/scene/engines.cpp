// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/engines.h"

#include <stdexcept>

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"

namespace racebeam {

const std::vector<const engine*>& engines() {
  static const std::vector<const engine*> table = {&beam_engine(), &sphere_engine(),
                                                   &block_engine(), &voxel_engine()};
  return table;
}

const engine& engine_of_unit(const std::string& unit) {
  for (const engine* one : engines())
    if (unit == one->top || one->unit(unit)) return *one;
  throw std::out_of_range("no engine has a unit " + unit);
}

const engine& engine_of(const knob_values& k) {
  for (const engine* one : engines())
    if (&one->knobs == &k.rows()) return *one;
  throw std::out_of_range("knobs of no engine");
}

}  // namespace racebeam
