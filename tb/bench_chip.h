// What `racebeam bench` runs of the whole chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/unit_choices.h"
#include "tb/command_bench.h"

namespace racebeam {

/// SystemC itself on this machine: the yardstick of the others.
void register_kernel(int repeats);

/// All models, in each part of the demo: rows "signal: PART".
void register_parts(const BenchOptions& options);
int part_count();

/// The transaction-level chip: rows "tlm: PART", and "tlm: all over the demo", frames evenly
/// spread.
void register_tlm_parts(const BenchOptions& options);

/// The chip's RTL behind Tiny Tapeout pins, verilated, without SystemC: a frame.
void register_verilated(int repeats);

/// All models in a busy frame: rows "trace: ..." for what the flight recorder, waveforms and a
/// condition cost.
void register_traces(const BenchOptions& options);
constexpr int TraceRows = 5;

/// A chip of models and RTL.
struct ChipMix {
  std::string name;
  unit_choices units;
};
/// All models first; each unit as RTL; all RTL; all in lockstep.
std::vector<ChipMix> chip_mixes();
/// In one part of the demo.
void register_mix(const ChipMix& mix, const BenchOptions& options);

}  // namespace racebeam
