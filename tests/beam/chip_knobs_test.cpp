// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "tb/bench/core_bench.h"
#include "tb/bench/signal_bench.h"
#include "tb/scene/scene_reader.h"
#include "tb/show/set_knob.h"
#include "tb/show/show.h"
#include "tests/support/expect_stats.h"

namespace racebeam {
namespace {

constexpr int CrowdedFrame = 7223;  // open heights: a frame that starves much

/// The setting of one knob.
class ChipKnobs : public testing::TestWithParam<const char*> {
 protected:
  static void expect_the_cores(int frame) {
    SCOPED_TRACE("frame " + std::to_string(frame));
    knobs k;
    set_knob(k, GetParam());
    SignalBench bench({k, true, true, false});
    bench.seek(frame);
    const auto got = bench.render();
    const auto expected = CoreBench(k, frame).render();
    EXPECT_EQ(got.picture.pins_crc, expected.pins_crc);
    expect_equal(*got.stats, expected.stats);
  }
};
using LongChipKnobs = ChipKnobs;

// A module that sleeps on an input that a knob makes matter would differ here.
TEST_P(ChipKnobs, WiresGiveThePinsAndCountersOfTheCores) { expect_the_cores(CrowdedFrame); }
TEST_P(LongChipKnobs, WiresGiveThePinsAndCountersOfTheCoresInThePortals) { expect_the_cores(3900); }
TEST_P(LongChipKnobs, WiresGiveThePinsAndCountersOfTheCoresInTheTunnel) { expect_the_cores(9500); }

const auto Settings = testing::Values(
    "interval_stack_depth=1", "interval_stack_depth=64", "face_stack_depth=4", "max_room_depth=5",
    "fifo_entries=3", "fifo_entries=64", "fifo_short_length_bits=3", "hurry_threshold=-1",
    "dr_bits=8", "dr_bits=13", "corner_bits=11", "corner_factor_bits=6", "corner_factor_bits=12",
    "partial_products_cut=0", "bisection=midpoint", "stepping=fraction", "interlace=off",
    "dithering=off", "dithering=checkered", "clocks_per_pixel=1", "clocks_per_pixel=3",
    "skip_shared_edges=on", "skip_shared_edges=table", "speed=7", "head_start=320",
    "bisection=floor", "stepping=fraction_dr2", "ddr_fraction_bits=4", "corner_rounding=on",
    "fifo_merge=off", "camera_cosine=exact");
INSTANTIATE_TEST_SUITE_P(Settings, ChipKnobs, Settings);
INSTANTIATE_TEST_SUITE_P(LongSettings, LongChipKnobs, Settings);

/// Statistics of a frame with one knob changed.
frame_stats with(const char* setting, int frame = CrowdedFrame) {
  knobs k;
  set_knob(k, setting);
  return CoreBench(k, frame).render().stats;
}
const frame_stats& chip() {
  static const frame_stats stats = with("speed=0");
  return stats;
}

TEST(KnobEffects, DeepStackNeverRestartsAndShallowStackRestartsMore) {
  EXPECT_EQ(with("interval_stack_depth=64").restarts, 0u);
  EXPECT_GT(with("interval_stack_depth=1").restarts, 4 * chip().restarts);
}

TEST(KnobEffects, FaceStackLimitsTheRoomDepthToOneLessThanItsEntries) {
  EXPECT_EQ(with("face_stack_depth=4").decisions(), with("max_room_depth=3").decisions());
  EXPECT_LT(with("max_room_depth=3").rooms_entered, chip().rooms_entered);
}

TEST(KnobEffects, DeeperRoomsNeedADeeperFaceStack) {
  constexpr int FarView = 5555;  // tunnel
  knobs deep;
  deep.max_room_depth = 14;
  EXPECT_EQ(CoreBench(deep, FarView).render().pins_crc, CoreBench({}, FarView).render().pins_crc);
  deep.face_stack_depth = 15;
  EXPECT_NE(CoreBench(deep, FarView).render().pins_crc, CoreBench({}, FarView).render().pins_crc);
}

TEST(KnobEffects, SmallFifoStallsTheTracerMore) {
  EXPECT_GT(with("fifo_entries=3", 700).fifo_full_stalls,
            with("fifo_entries=10", 700).fifo_full_stalls);
  EXPECT_EQ(with("fifo_entries=3").fifo_fill[4], 0u);
}

TEST(KnobEffects, WithoutHurryNothingIsGivenUpAndMorePixelsStarve) {
  EXPECT_EQ(with("hurry_threshold=-1").give_ups, 0u);
  EXPECT_GT(with("hurry_threshold=-1").starved_pixels, chip().starved_pixels);
}

TEST(KnobEffects, SkippingSharedEdgesSavesDecisionsAndLetsNothingStarve) {
  const frame_stats s = with("skip_shared_edges=on");
  EXPECT_LT(s.decisions(), chip().decisions() * 3 / 4);
  EXPECT_LT(s.starved_pixels, chip().starved_pixels / 100);
}

// The scene's bits say what comparing rooms says, in every clock.
TEST(KnobEffects, EdgesSkippedByTableAreThoseSkippedByComparing) {
  for (const int frame : {200, 2000, 3900, 5555, CrowdedFrame, 8400, 9500, 11263}) {
    SCOPED_TRACE(frame);
    const auto render = [frame](const char* setting) {
      knobs k;
      set_knob(k, setting);
      return CoreBench(k, frame).render();
    };
    const auto compared = render("skip_shared_edges=on"), told = render("skip_shared_edges=table");
    EXPECT_EQ(told.pins_crc, compared.pins_crc);
    expect_equal(told.stats, compared.stats);
  }
}

// Where faces have several portals it knows more.
TEST(KnobEffects, EdgesOfSceneFilesSkippedByTableAreThoseSkippedByComparingAndMore) {
  int single = 0, several = 0;
  for (const char* name : {"grid", "spiral"}) {
    SCOPED_TRACE(name);
    const std::string file = RACEBEAM_SOURCE_DIR "/scenes/" + std::string(name) + ".toml";
    const Show show(read_scene_file(file).scene, "");
    const auto render = [&show](int rule) {
      knobs k = show.standard_knobs();
      k.skip_shared_edges = rule;
      return CoreBench(k, show.frames() / 3, show.program()).render();
    };
    const auto compared = render(SharedEdgesOn), told = render(SharedEdgesTable);
    if (show.program()->portals_per_face == 1) {
      EXPECT_EQ(told.pins_crc, compared.pins_crc);
      expect_equal(told.stats, compared.stats);
      EXPECT_LT(told.stats.decisions(), render(SharedEdgesOff).stats.decisions());
      ++single;
    } else {
      EXPECT_LT(told.stats.decisions(), compared.stats.decisions());
      ++several;
    }
  }
  EXPECT_GT(single, 0);
  EXPECT_GT(several, 0);
}

// Behind the FIFO six tones are told apart, before it four indices.
TEST(KnobEffects, CheckeredDitheringMergesLess) {
  constexpr int Dithered = 5119;
  const frame_stats before = with("dithering=on", Dithered);
  const frame_stats behind = with("dithering=checkered", Dithered);
  EXPECT_LT(behind.merges, before.merges);
}

// Rooms and their decisions are the same; only the beam is nearer.
TEST(KnobEffects, WithoutItsHeadStartEveryLineBeginsLaterAndMorePixelsStarve) {
  const frame_stats s = with("head_start=320");
  for (std::size_t line = 0; line < s.camera_clocks.size(); ++line)
    ASSERT_EQ(s.camera_clocks[line], chip().camera_clocks[line] + 320) << line;
  EXPECT_GT(s.starved_pixels, chip().starved_pixels);
  EXPECT_GE(s.starved_pixels, 480u * 44 / 2) << "the camera alone takes 44 clocks";
}

TEST(KnobEffects, WithoutMergingTheFifoIsFullMoreOften) {
  EXPECT_GT(with("fifo_merge=off", 700).fifo_full_stalls, with("speed=0", 700).fifo_full_stalls);
}

TEST(KnobEffects, NoStoredFractionBitsIsTheJumper) {
  knobs k;
  k.stepping = SteppingFraction;
  k.stepping_fraction_bits = 0;
  EXPECT_EQ(CoreBench(k, CrowdedFrame).render().pins_crc,
            CoreBench({}, CrowdedFrame).render().pins_crc);
  k.stepping_fraction_bits = 4;
  EXPECT_NE(CoreBench(k, CrowdedFrame).render().pins_crc,
            CoreBench({}, CrowdedFrame).render().pins_crc);
}

TEST(KnobEffects, MoreClocksPerPixelStarveLess) {
  EXPECT_GT(with("clocks_per_pixel=1").starved_pixels, chip().starved_pixels);
  EXPECT_EQ(with("clocks_per_pixel=4").starved_pixels, 0u);
}

}  // namespace
}  // namespace racebeam
