// Guard frames: the worst ones of the base.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/guard_frames.h"

#include <gmock/gmock.h>

namespace racebeam {
namespace {

using testing::ElementsAre;

const std::vector<ScannedFrame> Frames = {{3, 900, 0},  {5, 1500, 1},  {7, 1600, 0},
                                          {9, 900, 80}, {11, 200, 70}, {13, 1500, 80}};

TEST(GuardFrames, HalfOfThemAreTheLongestAndHalfTheMostStarved) {
  EXPECT_THAT(worst_frames(Frames, 2), ElementsAre(7, 9));
  EXPECT_THAT(worst_frames(Frames, 4), ElementsAre(5, 7, 9, 13));
  EXPECT_THAT(worst_frames(Frames, 3), ElementsAre(5, 7, 9)) << "the odd one is of the longest";
}

TEST(GuardFrames, FewFramesAreAllOfThem) {
  EXPECT_THAT(worst_frames(Frames, 64), ElementsAre(3, 5, 7, 9, 11, 13));
  EXPECT_THAT(worst_frames({}, 64), ElementsAre());
  EXPECT_THAT(worst_frames(Frames, 0), ElementsAre());
}

}  // namespace
}  // namespace racebeam
