// Promises of sc/beam/decision_datapath.h: random walks against geometry, contract sections 11.2
// to 11.7.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/beam/decision_datapath_walk.h"

#include <gtest/gtest.h>

namespace racebeam {
namespace {

template <class Unit>
using DecisionDatapathWalkTest = DecisionDatapathTest<Unit>;
TYPED_TEST_SUITE(DecisionDatapathWalkTest, Twins);

// 11.5, 11.6: descents and climbs, all levels, faces and signs.
TYPED_TEST(DecisionDatapathWalkTest, CornerIsWhereGeometryPutsItOnRandomWalks) {
  constexpr unsigned Seed = 115;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  Walk<TypeParam> walk(this->dut, 8, Seed);
  walk.run(400);
  EXPECT_EQ(walk.deepest, 9);
}

template <class Unit>
class DecisionDatapathWalkKnobs : public testing::Test {};
TYPED_TEST_SUITE(DecisionDatapathWalkKnobs, Twins);

template <class Unit>
void expect_wall_at(int depth, const knobs& k) {
  Dut<Unit> d(k);
  Walk<Unit> walk(d, depth, 200 + depth);
  walk.run(100);
  EXPECT_EQ(walk.deepest, depth + 1);
}

TYPED_TEST(DecisionDatapathWalkKnobs, MaxRoomDepth2ForcesTheWallAtDepth2) {
  knobs k;
  k.max_room_depth = 2;
  expect_wall_at<TypeParam>(2, k);
}

TYPED_TEST(DecisionDatapathWalkKnobs, MaxRoomDepthIsBoundByTheFaceStack) {
  knobs k;
  k.max_room_depth = 14;
  k.face_stack_depth = 4;
  expect_wall_at<TypeParam>(3, k);
}

}  // namespace
}  // namespace racebeam
