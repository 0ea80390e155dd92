// A Tiny Tapeout chip as the source of a viewer's frames: steps, inputs, its past, its sound.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/tt_source.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sc/beam/pwm_sound.h"
#include "tb/tt/tt_bench.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/view/frame_source.h"

namespace racebeam {
namespace {

constexpr int LineClocks = 800, FrameClocks = 525 * LineClocks, SoundPin = 7;
using Colours = std::vector<std::uint8_t>;

class TtSourceTest : public testing::Test {
 protected:
  TtSourceTest() {
    project.top = "tt_um_paddle";
    project.source_folder = RACEBEAM_SOURCE_DIR "/tests/tt/paddle/src";
    for (const char* name : {"/tt_um_paddle.sv", "/paddle_beam.sv"})
      project.sources.push_back(project.source_folder + name);
    project.clock_hz = 25'200'000;
    RtlSources sources;
    sources.top = project.top;
    sources.files = project.sources;
    sources.kind = RtlSources::Chip;
    plugin = rtl_plugin(sources);
  }
  TtRun run_of(const TtInputs& inputs = TtInputs()) const { return TtRun(project, plugin, inputs); }
  /// What the bench of `render` draws.
  std::vector<Colours> rendered(int frames, const TtInputs& inputs) const {
    TtRun run = run_of(inputs);
    TtBench bench(run, false, false, 0);
    std::vector<Colours> all;
    for (int i = 0; i < frames; ++i) all.push_back(bench.render().picture.colours);
    return all;
  }
  static Colours whole_frame(TtSource& source) {
    while (source.advance(source.clocks_left()) > 0 && !source.watch().whole()) {
    }
    return source.watch().screen().colours();
  }
  /// Rising edges a second of what was played.
  static double pitch(const std::vector<float>& sound) {
    int rises = 0;
    for (std::size_t i = 1; i < sound.size(); ++i) rises += sound[i - 1] < 0 && sound[i] >= 0;
    return rises * 1.0 * FrameSource::SoundRate / static_cast<double>(sound.size());
  }

  TtProject project;
  std::string plugin;
};

TEST_F(TtSourceTest, WholeFramesAreThoseOfTheBench) {
  TtRun run = run_of(TtInputs({2, 0}));
  TtSource source(run, SoundPin);
  for (const Colours& expected : rendered(3, TtInputs({2, 0})))
    EXPECT_EQ(whole_frame(source), expected);
  EXPECT_EQ(source.watch().frame(), 2);
}

TEST_F(TtSourceTest, StepsOfAnySizeGiveTheSameFrame) {
  TtRun run = run_of();
  TtSource source(run, SoundPin);
  int clocks = 0;
  for (int steps = 0; !source.watch().whole(); ++steps)
    clocks += source.advance(steps < 3000 ? 1 : steps % 2 ? 2 : 997);
  EXPECT_EQ(clocks, FrameClocks);
  EXPECT_EQ(source.watch().screen().colours(), rendered(1, TtInputs())[0]);
}

TEST_F(TtSourceTest, ABeamInTheMiddleStandsWhereTheClocksHaveTakenIt) {
  TtRun run = run_of();
  TtSource source(run, SoundPin);
  EXPECT_EQ(source.advance(100 * LineClocks + 7), 100 * LineClocks + 7);
  EXPECT_EQ(source.watch().screen().y(), -273 + 100);
  EXPECT_EQ(source.watch().screen().clock_of_line(), 7);
  EXPECT_EQ(source.clocks_left(), FrameClocks - 100 * LineClocks - 7);
}

TEST_F(TtSourceTest, PressedInputsGoOnTheSameWayWhenItsPastIsSoughtAgain) {
  TtRun run = run_of();
  TtSource source(run, SoundPin);
  std::vector<Colours> seen = {whole_frame(source)};
  source.press({1, 0});
  seen.push_back(whole_frame(source));
  source.advance(300 * LineClocks);  // in the picture: too late to move the bar
  source.press({2, 0});
  seen.push_back(whole_frame(source));
  seen.push_back(whole_frame(source));
  source.seek(1);
  EXPECT_EQ(source.inputs(), TilePins());
  for (int frame = 1; frame < 4; ++frame) EXPECT_EQ(whole_frame(source), seen[frame]) << frame;
  EXPECT_EQ(source.watch().frame(), 3);
  EXPECT_EQ(source.inputs(), (TilePins{2, 0}));
  EXPECT_EQ(source.inputs_text(),
            "frame,line,clock,ui,uio\nreset,0,0,0,0\n1,-273,0,1,0\n2,27,0,2,0\n");
  EXPECT_EQ(rendered(4, run.inputs()), seen);
}

TEST_F(TtSourceTest, AKeyDropsTheInputsThatWereToCome) {
  TtInputs inputs;
  inputs.change({1, 0, 0, {4, 0}});
  inputs.change({3, 0, 0, {8, 0}});
  TtRun run = run_of(inputs);
  TtSource source(run, SoundPin);
  whole_frame(source);
  whole_frame(source);
  EXPECT_EQ(source.inputs(), (TilePins{4, 0}));
  source.press({5, 0});
  source.press({6, 0});  // in the same clock
  EXPECT_EQ(source.inputs_text(),
            "frame,line,clock,ui,uio\nreset,0,0,0,0\n1,0,0,4,0\n2,-273,0,6,0\n");
}

TEST_F(TtSourceTest, AFarFrameIsSoughtInPiecesThatNobodySees) {
  TtRun run = run_of(TtInputs({1, 0}));
  TtSource source(run, SoundPin);
  const Colours first = whole_frame(source);
  source.take_sound();
  source.seek(4);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(source.advance(FrameClocks), FrameClocks);
    EXPECT_EQ(source.watch().seen(), 0);
    EXPECT_EQ(source.watch().screen().colours(), first);
  }
  EXPECT_TRUE(source.take_sound().empty());
  EXPECT_EQ(whole_frame(source), rendered(5, TtInputs({1, 0}))[4]);
  EXPECT_EQ(source.watch().frame(), 4);
}

// uio_out[7] is bit 5 of the row, or bit 4 with uio_in 1: it rises 8 or 16 times a frame.
TEST_F(TtSourceTest, TheToneOfThePinIsHeard) {
  for (const int octave : {0, 1}) {
    TtRun run = run_of(TtInputs({0, static_cast<std::uint8_t>(octave)}));
    TtSource source(run, SoundPin);
    for (int frame = 0; frame < 6; ++frame) whole_frame(source);
    const std::vector<float> sound = source.take_sound();
    EXPECT_NEAR(static_cast<double>(sound.size()), 6 * FrameSamples, 1);
    EXPECT_NEAR(pitch(sound), octave ? 16 * 60 : 8 * 60, 20);
    EXPECT_GT(*std::max_element(sound.begin(), sound.end()), 0.5);
    TtSource other(run, 3);  // which the chip does not drive
    whole_frame(other);
    for (const float sample : other.take_sound()) EXPECT_EQ(sample, 0);
  }
}

TEST(PinSoundTest, SamplesAreTheMeanLevelOfTheirTime) {
  PinSound sound(48'000 * 10.0, 48'000);
  sound.add(5, false);
  sound.add(5, true);
  EXPECT_EQ(sound.take(), std::vector<float>{0});  // what the capacitor is charged with
  sound.add(10, true);
  sound.add(7, false);
  const std::vector<float> one = sound.take();
  ASSERT_EQ(one.size(), 1u);
  EXPECT_NEAR(one[0], 1, 1e-3);
  sound.add(3, true);
  EXPECT_NEAR(sound.take().at(0), -0.4, 2e-3);
}

}  // namespace
}  // namespace racebeam
