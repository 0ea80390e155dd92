// Promises of registers in channels: of an engine that does not race the beam they move time and
// nothing else; every channel that may be delayed has its registers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/delay_run.h"

#include <gtest/gtest.h>

#include "tb/twin/channels.h"

namespace racebeam {
namespace {

constexpr const char* Voxel = RACEBEAM_SOURCE_DIR "/tests/museum/voxel.toml";
constexpr const char* Block = RACEBEAM_SOURCE_DIR "/tests/museum/block.toml";
constexpr const char* Sphere = RACEBEAM_SOURCE_DIR "/tests/museum/sphere.toml";

Run run_of(const std::string& scene, const std::vector<std::string>& assignments = {}) {
  RunOptions options;
  options.scene = scene;
  options.assignments = assignments;
  return open_run(options, true);
}

std::vector<ChannelSlack> measured(const Run& run, int number, int most) {
  std::vector<std::string> channels;
  for (const ChannelRow& row : channels_of(run.show.engine()))
    if (row.may_delay()) channels.emplace_back(row.name);
  return measure_slack(run, channels, {number}, most, 2, [](int) {});
}

class DelayedScene : public testing::TestWithParam<const char*> {
 protected:
  static void expect_colours_stay(int most) {
    const auto all = measured(run_of(GetParam()), 0, most);
    EXPECT_EQ(all.size(), 2u) << "word and take";
    for (const ChannelSlack& slack : all) EXPECT_EQ(slack.colour_slack(), most) << slack.channel;
  }
};

using DelayedPicture = DelayedScene;
TEST_P(DelayedPicture, KeepsEveryColour) { expect_colours_stay(3); }
INSTANTIATE_TEST_SUITE_P(Scenes, DelayedPicture, testing::Values(Voxel));

using LongDelayedPicture = DelayedScene;
TEST_P(LongDelayedPicture, KeepsEveryColour) { expect_colours_stay(3); }
INSTANTIATE_TEST_SUITE_P(LongScenes, LongDelayedPicture, testing::Values(Block, Sphere));

// With a beam that is held back nothing starves, and what is late is the same.
TEST(DelayedBeam, KeepsEveryColourThatWaitsForNobody) {
  for (const ChannelSlack& slack : measured(run_of("demo", {"clocks_per_pixel=8"}), 5000, 2)) {
    EXPECT_EQ(slack.by_latency[0].starved, 0u);
    EXPECT_EQ(slack.starving_slack(), 2) << slack.channel;
    EXPECT_EQ(slack.colour_slack(), 2) << slack.channel;
  }
}

TEST(ChannelSlack, EndsBeforeTheFirstLatencyThatIsWorse) {
  ChannelSlack slack{"interval", {{100, 5, 0}, {101, 5, 0}, {102, 6, 1}, {103, 4, 0}}};
  EXPECT_EQ(slack.starving_slack(), 1);
  EXPECT_EQ(slack.colour_slack(), 1);
  slack.by_latency.resize(2);
  EXPECT_EQ(slack.colour_slack(), 1);
}

}  // namespace
}  // namespace racebeam
