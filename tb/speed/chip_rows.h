// What `racebeam bench` runs of the whole chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/unit_choices.h"

namespace racebeam {

/// How much is run for a row.
struct Effort {
  int frames = 20;  ///< of each demo part
  int repeats = 5;  ///< of which the median counts
};

/// SystemC itself on this machine: the yardstick of the others.
void register_kernel(int repeats);

/// All models, in each part of the demo: rows "signal: PART".
void register_parts(const Effort& effort);
int part_count();

/// The transaction-level chip: rows "tlm: PART", and "tlm: all over the demo", frames evenly
/// spread.
void register_tlm_parts(const Effort& effort);

/// The chip's RTL behind Tiny Tapeout pins, verilated, without SystemC: a frame. `name`: of the
/// row; `alone`: by processor time.
void register_verilated(const std::string& name, int repeats, bool alone = false);

/// All models in a busy frame: rows "trace: ..." for what the flight recorder, waveforms and a
/// condition cost.
void register_traces(const Effort& effort);
constexpr int TraceRows = 5;

/// A chip of models and RTL.
struct ChipMix {
  std::string name;
  unit_choices units;
};
/// All models first; each unit as RTL; all RTL; all in lockstep.
std::vector<ChipMix> chip_mixes();
/// All models first; each two units that touch each other as RTL.
std::vector<ChipMix> neighbour_mixes();
/// In one part of the demo, by processor time, with evaluations of RTL a clock.
void register_mix(const ChipMix& mix, const Effort& effort);

}  // namespace racebeam
