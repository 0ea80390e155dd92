// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/engine.h"

#include <string>

#include "sc/block/block_chip.h"
#include "sc/block/block_parameters.h"
#include "sc/block/codes.h"
#include "sc/block/counters.h"
#include "sc/block/knobs.h"
#include "sc/block/units.h"

namespace racebeam {

namespace {

knob_values standard_knobs(const scene_tables*) { return block_knobs(); }

std::string settle(knob_values&) { return ""; }

std::string objection(const knob_values& values, const scene_tables*) {
  const block_knobs k = values;
  if (BlockSide % k.lanes == 0) return "";
  return "lanes=" + std::to_string(k.lanes) + ": a core has 1, 2, 4 or 8 lanes";
}

video_clocks video(const knob_values&) { return {block_knobs::clocks_per_pixel}; }

std::vector<rtl_parameter> parameters(const knob_values& k) { return block_parameters(k); }

}  // namespace

const engine& block_engine() {
  static const engine row = {"block",
                             "integer renderer of 16 x 16 blocks on many small cores",
                             {"tlm", "signal"},
                             "",
                             false,
                             block_unit_table(),
                             block_knob_rows(),
                             block_counter_infos(),
                             block_histogram_infos(),
                             {},
                             {{"u_block_core.state_q", block_state_words()}},
                             standard_knobs,
                             settle,
                             objection,
                             video,
                             make_block_chip,
                             parameters};
  return row;
}

}  // namespace racebeam
