// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/demo_parts.h"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "sc/beam/sequencer.h"

namespace racebeam {
namespace {

sequencer_core::outputs choices(int frame) {
  sequencer_core core;
  core.frame_q = frame;
  sequencer_core::inputs in{};
  in.rst_n = in.run = true;
  return core.comb(in, {});
}

TEST(DemoPartsTest, FollowEachOtherWithoutAGap) {
  int next = 0;
  for (const DemoPart& part : demo_parts()) {
    EXPECT_EQ(part.first_frame, next);
    EXPECT_LE(part.first_frame, part.last_frame);
    next = part.last_frame + 1;
  }
  EXPECT_EQ(next, DemoFrames);
}

TEST(DemoPartsTest, SayInEveryFrameWhatTheSequencerDoes) {
  for (int frame = 0; frame < DemoFrames; ++frame) {
    const DemoPart& part = demo_part(frame);
    sequencer_core core;
    core.frame_q = frame;
    const auto chosen = choices(frame);
    ASSERT_EQ(part.selector, core.scene_selector()) << frame;
    ASSERT_EQ(part.variant, core.variant()) << frame;
    ASSERT_EQ(std::strstr(part.effects, "inverse") != nullptr, chosen.inverse) << frame;
    ASSERT_EQ(std::strstr(part.effects, "pattern") != nullptr, core.lock_enabled()) << frame;
    ASSERT_EQ(std::strstr(part.effects, "full") != nullptr,
              core.lock_enabled() && !core.lock_partial())
        << frame;
    ASSERT_EQ(std::strstr(part.scene, "tunnel") != nullptr, (chosen.scene_flags & SceneTunnel) != 0)
        << frame;
    ASSERT_EQ(std::strstr(part.scene, "narrow") != nullptr || std::strstr(part.scene, "portals"),
              (chosen.scene_flags & SceneNarrow) != 0)
        << frame;
  }
}

TEST(DemoPartsTest, ThereIsNoPartOutsideTheDemo) {
  EXPECT_THROW(demo_part(-1), std::out_of_range);
  EXPECT_THROW(demo_part(DemoFrames), std::out_of_range);
}

}  // namespace
}  // namespace racebeam
