// Promises of sc/beam/decision_datapath.h: knob skip_shared_edges.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "tests/beam/decision_datapath_bench.h"

namespace racebeam {
namespace {

template <class Unit>
class DecisionDatapathSharedEdges : public testing::Test {};
TYPED_TEST_SUITE(DecisionDatapathSharedEdges, Twins);

// A portal edge on the edge of the face needs no decision.
template <class Unit>
void expect_levels(const vec3& half, const vec3& centre, const std::vector<int>& levels) {
  knobs k;
  k.skip_shared_edges = 1;
  Dut<Unit> d(k);
  d.scene = [&](int room) {
    return room == 4 ? Box{{0, 0, 0}, {128, 256, 128}} : Box{centre, half};
  };
  d.start({10, -20, 30}, 4);
  d.descend(0, false);
  d.descend(0, false);
  d.descend(0, true, 5);  // through +x
  d.clock();
  Place p;
  p.camera = {-10, 20, -30};
  p.rooms = {4, 5}, p.faces = {0, 0}, p.doms = {0, 0};
  for (const int level : levels) {
    p.level = level;
    EXPECT_EQ(d.place(), (At{1, level, 0}));
    EXPECT_EQ(d.corner(), p.corner(d.scene)) << "1." << level;
    d.descend(0, false);
  }
  EXPECT_EQ(d.place(), (At{1, 7, 0}));
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    p.level = *level;
    d.climb(tag_of(1, *level), 0);
    EXPECT_EQ(d.place(), (At{1, *level, 0}));
    EXPECT_EQ(d.corner(), p.corner(d.scene)) << "back at 1." << *level;
  }
}

// Through an x face levels 0 and 2 test the far and near edge in z, 1 and 3 those in y (11.2).
TYPED_TEST(DecisionDatapathSharedEdges, RoomOfTheSameSectionNeedsNoPortalDecision) {
  expect_levels<TypeParam>({128, 256, 128}, {256, 0, 0}, {6});
}

TYPED_TEST(DecisionDatapathSharedEdges, RoomNarrowerInZIsTestedInZ) {
  expect_levels<TypeParam>({128, 256, 96}, {256, 0, 0}, {0, 2, 6});
}

TYPED_TEST(DecisionDatapathSharedEdges, RoomLowerInYIsTestedInY) {
  expect_levels<TypeParam>({128, 16, 128}, {256, 0, 0}, {1, 3, 6});
}

TYPED_TEST(DecisionDatapathSharedEdges, RoomOnTheNearEdgeIsTestedOnTheFarSide) {
  expect_levels<TypeParam>({128, 256, 96}, {256, 0, -32}, {0, 6});
}

TYPED_TEST(DecisionDatapathSharedEdges, RoomOnTheFarEdgeIsTestedOnTheNearSide) {
  expect_levels<TypeParam>({128, 246, 128}, {256, 10, 0}, {3, 6});
}

TYPED_TEST(DecisionDatapathSharedEdges, SmallWindowIsTestedOnAllSides) {
  expect_levels<TypeParam>({16, 96, 96}, {144, 0, 0}, {0, 1, 2, 3, 6});
}

}  // namespace
}  // namespace racebeam
