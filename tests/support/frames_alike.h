// Frames of two benches of an engine are the same in all that a bench tells.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "tb/bench/chip_bench.h"

namespace racebeam {

inline void expect_same(const engine& built, const ChipBench::Frame& a, const ChipBench::Frame& b) {
  EXPECT_EQ(a.number, b.number);
  const auto& infos = built.counters;
  for (std::size_t n = 0; n < infos.size(); ++n)
    EXPECT_EQ(a.stats->counters[n], b.stats->counters[n])
        << infos[n].name << " of picture " << a.number;
  EXPECT_EQ(a.stats->histograms, b.stats->histograms);
  EXPECT_EQ(a.time.clocks, b.time.clocks);
  EXPECT_EQ(a.time.frames, b.time.frames);
  EXPECT_EQ(a.picture.width, b.picture.width);
  EXPECT_EQ(a.picture.bits, b.picture.bits);
  EXPECT_TRUE(a.picture.colours == b.picture.colours) << "picture " << a.number;
  EXPECT_EQ(a.picture.image_crc, b.picture.image_crc);
  EXPECT_EQ(a.picture.pins_crc, b.picture.pins_crc);
}

}  // namespace racebeam
