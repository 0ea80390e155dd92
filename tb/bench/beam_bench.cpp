// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/beam_bench.h"

#include "tb/bench/signal_bench.h"
#include "tb/bench/tlm_bench.h"

namespace racebeam {

std::unique_ptr<ChipBench> make_beam_bench(const std::string& level,
                                           const WiredBench::Setting& setting,
                                           const BenchWishes& wishes) {
  const auto* program = static_cast<const scene_program*>(setting.scene);
  if (level == setting.built.levels.front())
    return std::make_unique<TlmBench>(
        TlmBench::Options{setting.k, true, wishes.crc, wishes.sound, program, wishes.intervals});
  if (wishes.intervals)
    return std::make_unique<SignalBench>(SignalBench::Options{
        setting.k, true, wishes.crc, wishes.sound, program, setting.units, wishes.intervals});
  return std::make_unique<WiredBench>(setting, WiredBench::Watches{true, wishes.crc, wishes.sound});
}

}  // namespace racebeam
