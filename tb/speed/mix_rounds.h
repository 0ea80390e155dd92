// Chips of which some units are RTL, compared with runs of all models, and of the verilated top,
// just before or after them, so that what else the machine does falls on both sides of a ratio.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/speed/chip_rows.h"

namespace racebeam {

constexpr const char* BareTop = "mix: verilated top, without SystemC";

struct MixRow {
  std::string name;
  double clocks_per_second;    ///< of processor time, the median of all rounds
  double of_models;            ///< the median of its ratios to all models; BareTop: 0
  double of_top;               ///< to BareTop, if that is run; or 0
  double evaluations_a_clock;  ///< of each plug-in; of a mix without RTL 0
};

/// Rounds of Effort::repeats, each run in a process of its own: each mix once, and the first one,
/// all models, before every second of the others. `with_top`: so is BareTop, and is the first row.
/// `run_done` is called after each of its mix_runs().
std::vector<MixRow> measure_mixes(const std::vector<ChipMix>& mixes, bool with_top,
                                  const Effort& effort, const std::function<void()>& run_done);
int mix_runs(const std::vector<ChipMix>& mixes, bool with_top, const Effort& effort);

}  // namespace racebeam
