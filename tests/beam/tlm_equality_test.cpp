// The transaction-level chip is the chip: pixels, pins and counters against the cores in a loop,
// which chip_test.cpp holds to the wired chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sc/beam/tlm/line_raster.h"
#include "tb/bench/core_bench.h"
#include "tb/bench/tlm_bench.h"
#include "tb/show/demo_parts.h"
#include "tb/show/show.h"
#include "tests/support/expect_stats.h"
#include "tests/support/random_knobs.h"
#include "tests/support/room_scenes.h"

namespace racebeam {
namespace {

void expect_frame_of_the_cores(TlmBench& bench, int frame, const knobs& k,
                               const scene_program* program = nullptr) {
  SCOPED_TRACE("frame " + std::to_string(frame));
  bench.seek(frame);
  const auto got = bench.render();
  const auto want = CoreBench(k, frame, program).render();
  EXPECT_EQ(got.number, frame);
  EXPECT_EQ(got.picture.pins_crc, want.pins_crc);
  EXPECT_TRUE(got.picture.colours == want.colours);
  expect_equal(*got.stats, want.stats);
  expect_whole_lines(*got.stats, line_raster(k).size());
}

class TlmDemoPart : public testing::TestWithParam<int> {};

TEST_P(TlmDemoPart, HasThePixelsPinsAndCountersOfTheCores) {
  const DemoPart& part = demo_parts()[GetParam()];
  TlmBench bench({{}, true, true, false});
  expect_frame_of_the_cores(bench, (part.first_frame + part.last_frame) / 2, {});
}

INSTANTIATE_TEST_SUITE_P(Demo, TlmDemoPart,
                         testing::Range(0, static_cast<int>(demo_parts().size())));

class TlmScene : public testing::TestWithParam<std::string> {};

TEST_P(TlmScene, HasThePixelsPinsAndCountersOfTheCores) {
  const Show show(room_scene(GetParam()), "");
  const knobs k = show.standard_knobs();
  TlmBench bench({k, true, true, false, show.program()});
  for (const int frame : {show.frames() / 3, show.frames() - 1})
    expect_frame_of_the_cores(bench, frame, k, show.program());
}

INSTANTIATE_TEST_SUITE_P(Scenes, TlmScene, testing::ValuesIn(room_scenes()), [](const auto& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
});

class TlmKnobs : public testing::TestWithParam<int> {};

TEST_P(TlmKnobs, HasThePixelsPinsAndCountersOfTheCores) {
  const knobs k = random_knobs(GetParam());
  TlmBench bench({k, true, true, false});
  constexpr int CrowdedFrame = 7223;
  const int frame = GetParam() % 3 ? GetParam() * 419 % DemoFrames : CrowdedFrame;
  expect_frame_of_the_cores(bench, frame, k);
}

INSTANTIATE_TEST_SUITE_P(Random, TlmKnobs, testing::Range(1, 31));

class TlmSound : public testing::TestWithParam<int> {};

// Two frames in a row, then one from elsewhere: the sound goes on.
TEST_P(TlmSound, IsThePinOfTheCoresSampleBySample) {
  knobs k;
  k.speed = GetParam();
  TlmBench bench({k, false, false, true});
  SoundMonitor pin;
  pin.change(0, true);
  chip_core chip;
  chip.clock(false, k);
  std::uint64_t clock = 0;
  int frame = 0;
  for (const int next : {3000, 3001, 9000}) {
    bench.seek(next);
    bench.render();
    if (next != frame) chip.deposit(next, k);
    frame = next + 1;
    const int frame_clocks = Raster(2, k.speed).frame_clocks();
    for (int i = 0; i < frame_clocks; ++i, ++clock) pin.change(clock, chip.clock(true, k).pwm);
    pin.advance(clock);
  }
  EXPECT_EQ(bench.clocks(), clock);
  EXPECT_TRUE(bench.sound()->samples() == pin.samples());
}

INSTANTIATE_TEST_SUITE_P(Speeds, TlmSound, testing::Values(0, 3, 7));

}  // namespace
}  // namespace racebeam
