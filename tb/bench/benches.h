// How chips are put on the bench, one row for each engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tb/bench/chip_bench.h"
#include "tb/bench/pixel_clocks.h"
#include "tb/bench/surroundings.h"
#include "tb/bench/wired_bench.h"

namespace racebeam {

/// What is wanted of a bench besides pictures and counters.
struct BenchWishes {
  bool crc = false;        ///< the CRCs of VgaFrame
  bool sound = false;      ///< the PWM pin is heard
  bool intervals = false;  ///< IntervalEvents are collected
};

struct BenchKind {
  const racebeam::engine& engine;
  bool sound, intervals;  ///< what it can do
  /// Throws RtlError.
  std::unique_ptr<ChipBench> (*make)(const std::string& level, const WiredBench::Setting& setting,
                                     const BenchWishes& wishes);
  /// What is around a wired chip, which was connected; nullptr: nothing.
  std::unique_ptr<Surroundings> (*around)(wired_chip& chip, const WiredBench::Setting& setting);
  /// The pixels of a picture that begins in clock 0; nullptr: the engine races the beam.
  PixelClocks (*pixels)(const WiredBench::Setting& setting, int picture);
};

const std::vector<BenchKind>& benches();

/// The row of an engine. Throws std::out_of_range.
const BenchKind& bench_of(const engine& built);

}  // namespace racebeam
