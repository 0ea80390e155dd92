// Promises of sc/beam/subdivider.h: one portal in a face, and several.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/subdivider_bench.h"

namespace racebeam {
namespace {

// leave_o tells of a ray that leaves the room by its face (level 7) and, where a face may have
// several portals, of one that passes the edge of a portal (levels 0 to 3, decision 1).
template <class Unit>
void expect_leave(Dut<Unit>& d, bool several) {
  for (const int portal : {0, 3})
    for (int depth = 0; depth < 10; depth += 3)
      for (int level = 0; level < 8; ++level)
        for (const int bit : {0, 1})
          for (const int signs : {0, 10}) {
            const bool edge = several && level < 4 && bit;
            const int leave = level == 7 || edge ? 2 | bit : 0;
            SCOPED_TRACE(testing::Message() << depth << '.' << level << ", bit " << bit);
            d.start(0, 0);
            d.set("tag_i", portal << TagBits | tag_of(depth, level));
            d.see("dec_i", signs | bit);
            EXPECT_TRUE(d.get("descend_o"));
            EXPECT_EQ(d.get("leave_o"), leave) << "one pixel, in LEFT";
            d.see("second_i", 1);
            EXPECT_EQ(d.get("leave_o"), 0) << "half way";
            d.start(9, 9);
            d.set("tag_i", portal << TagBits | tag_of(depth, level));
            d.see("dec_i", signs | bit);
            EXPECT_EQ(d.get("leave_o"), 0) << "not decided yet";
            d.clock();
            EXPECT_EQ(d.get("leave_o"), leave) << "the ends agree, in RIGHT";
            d.see("dec_i", signs | !bit);
            EXPECT_EQ(d.get("leave_o"), 0) << "they do not";
          }
}

template <class Unit>
using SubdividerOnePortalTest = SubdividerTest<Unit>;
TYPED_TEST_SUITE(SubdividerOnePortalTest, Twins);

TYPED_TEST(SubdividerOnePortalTest, LeaveTellsOfFacesOnly) { expect_leave(this->dut, false); }

template <class Unit>
class SubdividerPortalsTest : public testing::Test {
 protected:
  static knobs several() {
    knobs k;
    k.portals_per_face = 2;
    return k;
  }
  Dut<Unit> dut{several()};
};
TYPED_TEST_SUITE(SubdividerPortalsTest, Twins);

TYPED_TEST(SubdividerPortalsTest, LeaveTellsOfPortalEdgesToo) { expect_leave(this->dut, true); }

// A return ends at the entry's own portal, not at another of the same depth and level.
TYPED_TEST(SubdividerPortalsTest, ClimbGoesOnUntilThePortalIsTheEntrys) {
  auto& d = this->dut;
  d.start(0, 0);
  d.set("top_tag_i", 1 << TagBits | tag_of(3, 2));
  d.set("wall_i", 1);
  d.see("ack_i", 1);
  for (const int portal : {3, 2, 0, 1}) {
    d.see("tag_i", portal << TagBits | tag_of(3, 2));
    EXPECT_EQ(d.get("climb_o"), portal != 1) << portal;
  }
  d.see("second_i", 1);
  EXPECT_TRUE(d.get("climb_o")) << "half way";
}

}  // namespace
}  // namespace racebeam
