// Promises of stalls between units: every channel that may stall tolerates it, and nothing but time
// moves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/shake_run.h"

#include <gtest/gtest.h>

#include "tb/base/errors.h"
#include "tb/scene/engines.h"
#include "tb/twin/channels.h"

namespace racebeam {
namespace {

constexpr const char* Beam = "demo";
constexpr const char* Voxel = RACEBEAM_SOURCE_DIR "/tests/museum/voxel.toml";
constexpr const char* Block = RACEBEAM_SOURCE_DIR "/tests/museum/block.toml";
constexpr const char* Sphere = RACEBEAM_SOURCE_DIR "/tests/museum/sphere.toml";
constexpr int Tunnel = 5000;

Run run_of(const std::string& scene, const std::vector<std::string>& assignments = {}) {
  RunOptions options;
  options.scene = scene;
  options.assignments = assignments;
  return open_run(options, true);
}

/// `channels`: none are all.
std::shared_ptr<const stall_plan> plan_of(const Run& run, const std::string& shake,
                                          const std::vector<std::string>& channels = {}) {
  return stall_plan_of(run.show.engine(), {shake, channels});
}

struct Channel {
  const char *scene, *name;
};
void PrintTo(const Channel& channel, std::ostream* out) { *out << channel.name; }

class ShakenChannel : public testing::TestWithParam<Channel> {
 protected:
  static void expect_tolerated() {
    const bool beam = GetParam().scene == std::string(Beam);
    const racebeam::Run run =
        run_of(GetParam().scene,
               beam ? std::vector<std::string>{"clocks_per_pixel=8"} : std::vector<std::string>{});
    ShakeRun shaken(run, plan_of(run, "1,0.05,0.75", {GetParam().name}));
    const int picture = beam ? Tunnel : 0;
    ASSERT_EQ(shaken.objection(picture), "");
    const ShakenPicture got = shaken.shake(1, picture);
    EXPECT_EQ(got.pixels, 0u) << "seed 1, (" << got.x << ", " << got.y << ")";
    EXPECT_EQ(got.starved, 0u);
    EXPECT_GT(got.stalled, 10000u) << "it was not stalled";
  }
};

using BeamChannel = ShakenChannel;
TEST_P(BeamChannel, ToleratesStalls) { expect_tolerated(); }
INSTANTIATE_TEST_SUITE_P(Names, BeamChannel,
                         testing::Values(Channel{Beam, "interval"}, Channel{Beam, "decision"},
                                         Channel{Beam, "camera"}));

using VoxelChannel = ShakenChannel;
TEST_P(VoxelChannel, ToleratesStalls) { expect_tolerated(); }
INSTANTIATE_TEST_SUITE_P(Names, VoxelChannel,
                         testing::Values(Channel{Voxel, "colour"}, Channel{Voxel, "word"},
                                         Channel{Voxel, "take"}));

using LongChannel = ShakenChannel;
TEST_P(LongChannel, ToleratesStalls) { expect_tolerated(); }
INSTANTIATE_TEST_SUITE_P(LongNames, LongChannel,
                         testing::Values(Channel{Sphere, "root"}, Channel{Sphere, "divider"},
                                         Channel{Sphere, "word"}, Channel{Block, "job"},
                                         Channel{Block, "core_word"}, Channel{Block, "word"},
                                         Channel{Block, "take"}));

// A restart after an overflow of the interval stack walks towards an entry that is not there any
// more, as the chip does; if it has to wait, for a FIFO without room or a stall, so does the walk,
// and ray directions are others. With 16 entries none of the frames here has a restart.
constexpr const char *HeldBack = "clocks_per_pixel=8", *Deep = "interval_stack_depth=16";

// 100 seeds x 12 frames: none has the lock effect.
class LongFrame : public testing::TestWithParam<int> {};
TEST_P(LongFrame, KeepsEveryColourUnderAHundredSeeds) {
  const racebeam::Run run = run_of(Beam, {HeldBack, Deep});
  ShakeRun shaken(run, plan_of(run, "1"));
  ASSERT_EQ(shaken.objection(GetParam()), "");
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const ShakenPicture got = shaken.shake(seed, GetParam());
    ASSERT_EQ(got.pixels, 0u) << "seed " << seed << ", (" << got.x << ", " << got.y << ")";
    ASSERT_EQ(got.starved, 0u) << "seed " << seed;
    ASSERT_GT(got.stalled, 1'000'000u);
  }
}
INSTANTIATE_TEST_SUITE_P(LongFrames, LongFrame,
                         testing::Values(0, 900, 1800, 4300, 5000, 5900, 6800, 7223, 8600, 9800,
                                         11000, 12500));

TEST(ShakeRun, EveryChannelThatMayStallIsInTheTestsAbove) {
  std::size_t count = 0;
  for (const engine* one : engines())
    for (const ChannelRow& row : channels_of(*one)) count += row.may_stall();
  EXPECT_EQ(count, 3u + 3u + 7u + 1u) << "take of the sphere tracer is that of the others";
}

TEST(ShakeRun, StallsAreAFunctionOfSeedAndFrame) {
  const racebeam::Run run = run_of(Beam, {"clocks_per_pixel=1"});
  ShakeRun shaken(run, plan_of(run, "1"));
  const ShakenPicture first = shaken.shake(3, Tunnel), other = shaken.shake(4, Tunnel),
                      again = shaken.shake(3, Tunnel);
  EXPECT_EQ(again.stalled, first.stalled);
  EXPECT_EQ(again.pixels, first.pixels);
  EXPECT_NE(other.stalled, first.stalled);
}

// The comparison can fail: a beam that does not wait shows what it has.
TEST(ShakeRun, ABeamThatIsNotHeldBackStarvesAndShowsOtherColours) {
  const racebeam::Run run = run_of(Beam, {"clocks_per_pixel=2"});
  ShakeRun shaken(run, plan_of(run, "1,0.2,0.9"));
  const ShakenPicture got = shaken.shake(1, Tunnel);
  EXPECT_GT(got.starved, 0u);
  EXPECT_GT(got.pixels, 0u);
}

// That of frame 0 with seed 7.
TEST(ShakeRun, ARestartThatWaitsMovesColours) {
  const racebeam::Run run = run_of(Beam, {HeldBack});
  const ShakenPicture got = ShakeRun(run, plan_of(run, "1")).shake(7, 0);
  EXPECT_EQ(got.starved, 0u);
  EXPECT_GT(got.pixels, 0u);
}
TEST(ShakeRun, WithoutRestartsNoColourMoves) {
  const racebeam::Run run = run_of(Beam, {HeldBack, Deep});
  EXPECT_EQ(ShakeRun(run, plan_of(run, "1")).shake(7, 0).pixels, 0u);
}

TEST(ShakeRun, AFrameWhoseColoursAreAFunctionOfTimeIsNotJudged) {
  constexpr int Locked = 2600;
  const racebeam::Run run = run_of(Beam);
  EXPECT_EQ(ShakeRun(run, plan_of(run, "1")).objection(Locked),
            "lock is 1: colours are a function of time");
}

TEST(ShakeRun, WithAProbabilityOf0NothingStalls) {
  const racebeam::Run run = run_of(Beam);
  EXPECT_EQ(ShakeRun(run, plan_of(run, "1,0,0.5")).shake(1, Tunnel).stalled, 0u);
}

}  // namespace
}  // namespace racebeam
