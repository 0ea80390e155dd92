// The sources of a viewer's frames against the pictures and counters of the benches.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/frame_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "tb/bench/core_bench.h"
#include "tb/view/beam_signal_source.h"
#include "tb/view/beam_sound.h"
#include "tb/view/beam_tlm_source.h"
#include "tests/support/expect_stats.h"

namespace racebeam {
namespace {

constexpr int LineClocks = 2 * LinePixels;

class FrameSourceTest : public testing::TestWithParam<const char*> {
 protected:
  const knobs k;
  std::unique_ptr<BeamSource> make() const {
    if (std::string(GetParam()) == "tlm") return std::make_unique<TlmSource>(k);
    return std::make_unique<SignalSource>(k, nullptr, unit_choices{});
  }
};

TEST_P(FrameSourceTest, WholeFramesAreThoseOfTheBench) {
  const auto source = make();
  EXPECT_STREQ(source->level(), GetParam());
  for (const int frame : {60, 7223}) {
    source->seek(frame);
    EXPECT_EQ(source->advance(1 << 30), LineClocks * FrameLines);
    CoreBench bench(k, frame);
    const CoreBench::Frame expected = bench.render();
    EXPECT_EQ(source->watch().screen().colours(), expected.colours);
    expect_equal(source->watch().stats(), expected.stats);
    EXPECT_EQ(source->watch().frame(), frame);
    EXPECT_TRUE(source->watch().whole());
  }
}

TEST_P(FrameSourceTest, StepsOfAnySizeGiveTheSameFrame) {
  const auto source = make();
  source->seek(1000);
  for (int steps = 0; !source->watch().whole(); ++steps)
    source->advance(steps < 3000 ? 1 : steps % 2 ? 2 : 997);
  CoreBench bench(k, 1000);
  const CoreBench::Frame expected = bench.render();
  EXPECT_EQ(source->watch().screen().colours(), expected.colours);
  expect_equal(source->watch().stats(), expected.stats);
}

TEST_P(FrameSourceTest, TheBeamStandsWhereTheClocksHaveTakenIt) {
  const auto source = make();
  source->seek(5000);
  source->advance(LineClocks * 300 + 123);
  EXPECT_EQ(source->watch().seen(), LineClocks * 300 + 123);
  EXPECT_EQ(source->watch().screen().y(), FirstLine + 300);
  EXPECT_EQ(source->watch().screen().clock_of_line(), 123);
  EXPECT_EQ(source->clocks_left(), LineClocks * (FrameLines - 300) - 123);
}

TEST_P(FrameSourceTest, BelowTheBeamTheOldPictureStays) {
  const auto source = make();
  source->seek(60);
  source->advance(source->clocks_left());
  const auto before = source->watch().screen().colours();
  source->seek(7223);
  source->advance(LineClocks * (FirstVisibleLine - FirstLine + 100));
  const auto colours = source->watch().screen().colours();
  CoreBench bench(k, 7223);
  const auto after = bench.picture();
  for (int i = 0; i < VisibleColumns * VisibleRows; ++i)
    ASSERT_EQ(colours[i], (i < 100 * VisibleColumns ? after : before)[i]) << i;
}

TEST_P(FrameSourceTest, SeekingInTheMiddleOfAFrameStartsAWholeOne) {
  const auto source = make();
  source->seek(60);
  source->advance(LineClocks * 77 + 5);
  source->seek(7223);
  source->advance(1 << 30);
  CoreBench bench(k, 7223);
  EXPECT_EQ(source->watch().screen().colours(), bench.picture());
}

INSTANTIATE_TEST_SUITE_P(Level, FrameSourceTest, testing::Values("tlm", "signal"),
                         [](const auto& info) { return std::string(info.param); });

TEST(TlmSource, ShowsTheFrameAtAnyClocksAPixelAndAnySpeed) {
  for (const auto& [clocks_per_pixel, speed] :
       {std::pair{1, 0}, std::pair{3, 0}, std::pair{2, 7}}) {
    knobs k;
    k.clocks_per_pixel = clocks_per_pixel;
    k.speed = speed;
    TlmSource source(k);
    source.seek(6200);
    for (int frame = 0; frame < 2; ++frame) source.advance(source.clocks_left());
    EXPECT_EQ(source.watch().frame(), 6201);
    EXPECT_TRUE(source.watch().screen().colours() == CoreBench(k, 6201).picture())
        << clocks_per_pixel << ' ' << speed;
  }
}

TEST(BeamScreen, FindsItsPlaceByTheSyncsAlone) {
  const knobs k;
  chip_core chip;
  chip.clock(false, k);
  chip.deposit(60, k);
  for (int i = 0; i < LineClocks * 200 + 321; ++i) chip.clock(true, k);
  BeamScreen screen{Raster()};  // believes that this is the start of a frame
  for (int i = 0; i < LineClocks * (2 * FrameLines - 200) - 321; ++i)
    screen.clock(chip.clock(true, k).uo);
  EXPECT_EQ(screen.y(), FirstLine);
  EXPECT_EQ(screen.clock_of_line(), 0);
  CoreBench bench(k, 61);
  EXPECT_EQ(screen.colours(), bench.picture());
}

TEST(BeamSound, IsTheMeanLevelOfTheChipsPin) {
  const knobs k;
  chip_core chip;
  chip.clock(false, k);
  chip.deposit(6300, k);
  BeamSound sound;
  const std::vector<float> samples = sound.play(6300);
  ASSERT_EQ(samples.size(), static_cast<std::size_t>(FrameSamples));
  EXPECT_GT(*std::max_element(samples.begin(), samples.end()), 0.05F);
  std::vector<double> levels;
  for (int i = 0; i < FrameSamples; ++i) {
    int high = 0;
    for (int clock = 0; clock < LinePixels; ++clock) high += chip.clock(true, k).pwm;
    levels.push_back(2.0 * high / LinePixels - 1);
  }
  double mean = std::accumulate(levels.begin(), levels.end(), 0.0) / FrameSamples;
  for (int i = 0; i < FrameSamples; ++i) {
    mean += (1 - std::exp(-2 * M_PI * 5 / 63000)) * (levels[i] - mean);
    ASSERT_NEAR(samples[i], levels[i] - mean, 1e-5) << i;
  }
}

}  // namespace
}  // namespace racebeam
