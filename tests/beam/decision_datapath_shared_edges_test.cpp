// Promises of sc/beam/decision_datapath.h: knob skip_shared_edges.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "tests/beam/decision_datapath_bench.h"

namespace racebeam {
namespace {

/// A unit with a value of the knob.
template <class Unit, int Rule>
struct Skipping {
  using unit = Unit;
  static constexpr int rule = Rule;
};

using Twin = own_rtl<decision_datapath>;
template <class Case>
class DecisionDatapathSharedEdges : public testing::Test {};
using Cases =
    testing::Types<Skipping<decision_datapath, SharedEdgesOn>, Skipping<Twin, SharedEdgesOn>,
                   Skipping<decision_datapath, SharedEdgesTable>, Skipping<Twin, SharedEdgesTable>>;
TYPED_TEST_SUITE(DecisionDatapathSharedEdges, Cases);

constexpr int Back = 2;  // the portal that leads back

/// Edges of `room`'s x faces on or beyond those of the room before it, as a scene tells them:
/// towards +z, +y, -z, -y.
int edges_of(const Box& room, const Box& before) {
  const auto reaches = [&](int axis, int side) {
    return side * room.centre[axis] + room.half[axis] >=
           side * before.centre[axis] + before.half[axis];
  };
  return reaches(2, 1) | reaches(1, 1) << 1 | reaches(2, -1) << 2 | reaches(1, -1) << 3;
}

vec3 mirrored(vec3 v, int signs) {
  for (int a = 0; a < 3; ++a)
    if (bit_of(signs, a)) v[a] = -v[a];
  return v;
}

// A portal edge on the edge of the face needs no decision; the same seen by rays towards any side.
template <class Case>
void expect_levels(const vec3& half, const vec3& centre, const std::vector<int>& levels) {
  knobs k;
  k.skip_shared_edges = Case::rule;
  k.portals_per_face = MaxPortals;
  Dut<typename Case::unit> d(k);
  for (int signs = 0; signs < 8; ++signs) {
    SCOPED_TRACE(signs);
    const Box before{{0, 0, 0}, {128, 256, 128}}, room{mirrored(centre, signs), half};
    d.scene = [&](int number) { return number == 4 ? before : room; };
    // Wrong unless the room before is looked at through the portal back.
    d.edges = [&] {
      const bool asked = d.get("room_o") == 5 && d.get("look_axis_o") == 0 &&
                         bit_of(d.get("look_signs_o"), 0) == !bit_of(signs, 0) &&
                         d.get("look_portal_o") == Back && d.get("look_way_o") == LookThrough;
      return asked ? edges_of(room, before) : ~edges_of(room, before) & 15;
    };
    d.start(mirrored({10, -20, 30}, signs), 4);
    d.descend(signs, false);
    d.descend(signs, false);
    d.descend(signs, true, 5, Back);  // through the x face
    d.clock();
    Place p;
    p.camera = mirrored({-10, 20, -30}, signs);
    p.signs = signs;
    p.rooms = {4, 5}, p.faces = {0, 0}, p.doms = {0, 0};
    for (const int level : levels) {
      p.level = level;
      EXPECT_EQ(d.place(), (At{1, level, 0}));
      EXPECT_EQ(d.corner(), p.corner(d.scene)) << "1." << level;
      d.descend(signs, false);
    }
    EXPECT_EQ(d.place(), (At{1, 7, 0}));
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
      p.level = *level;
      d.climb(tag_of(1, *level), signs);
      EXPECT_EQ(d.place(), (At{1, *level, 0}));
      EXPECT_EQ(d.corner(), p.corner(d.scene)) << "back at 1." << *level;
    }
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
