// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/engine.h"

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

std::unique_ptr<wired_chip> make_chip(const char* name, const knobs& k, const scene_tables* scene,
                                      const unit_choices& choices) {
  return std::make_unique<chip>(name, k, static_cast<const scene_program*>(scene), choices);
}

}  // namespace

const engine& beam_engine() {
  static const engine row = {"beam",
                             {"tlm", "signal"},
                             WholeChip,
                             unit_table(),
                             infos_of(counter_table()),
                             infos_of(histogram_table()),
                             infos_of(line_table()),
                             {{"u_subdivider.state_q", {"left", "right", "bisect", "return"}},
                              {"u_camera_unit.phase_q", {"product", "load", "scale", "run"}},
                              {"u_navigator.nav_state_q",
                               {"idle", "to_plus", "check_plus", "check_minus", "finish", "store",
                                "adjust", "7", "try_plus", "try_done", "try_check_plus",
                                "try_check_minus", "try_next", "13", "14", "15"}}},
                             make_chip,
                             knob_parameters};
  return row;
}

}  // namespace racebeam
