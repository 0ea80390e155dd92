// TlmPictures are those of the cores, with any knobs; without its residues the interlace is the
// golden tracer's.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/tlm_pictures.h"

#include <gtest/gtest.h>

#include "tb/show/open_show.h"
#include "tests/support/core_picture.h"
#include "tests/support/unlimited.h"

namespace racebeam {
namespace {

TEST(TlmPictures, AreThoseOfTheCores) {
  const Show demo;
  for (const int frame : {0, 3900, 7223, 12798}) {
    const TlmPictures tlm(demo, frame, {});
    for (const knobs& k : {knobs{}, unlimited()})
      EXPECT_EQ(golden_difference(tlm.picture(k), core_picture(frame, k)), 0) << frame;
  }
}

TEST(TlmPictures, AreThoseOfTheCoresInAScene) {
  const Show show = open_show("museum");
  const knobs k = show.standard_knobs();
  const int frame = show.frames() / 2;
  const TlmPictures tlm(show, frame, k);
  EXPECT_EQ(golden_difference(tlm.picture(k), core_picture(frame, k, show.program())), 0);
}

// Whatever else the frame shows: one with a pattern, one whose scene has no interlace.
TEST(TlmPictures, WithoutResidueAreTrace4WithInterlace) {
  knobs k = unlimited();
  k.interlace = 1;
  const Show demo;
  int residue = 0;
  for (const int frame : {200, 1023, 3900, 5119, 6800, 9535, 11263}) {
    const TlmPictures tlm(demo, frame, k);
    const GoldenPicture ideal = golden_picture(GoldenTracer::Trace4, demo.golden_world(frame, k),
                                               demo.golden_camera(frame, k));
    EXPECT_EQ(golden_difference(tlm.without_residue(k), ideal), 0) << frame;
    residue += golden_difference(tlm.picture(k), ideal);
  }
  EXPECT_GT(residue, 0);
}

TEST(TlmPictures, WithoutInterlaceThereIsNoResidue) {
  const knobs k = unlimited();
  const Show demo;
  const TlmPictures tlm(demo, 1023, k);
  EXPECT_EQ(golden_difference(tlm.without_residue(k), tlm.picture(k)), 0);
}

/// The lines that are traced for a picture that follows another.
int traced_after(const TlmPictures& tlm, const knobs& before, const knobs& k, bool residue = true) {
  const TlmPictures::Run first = tlm.run(before, true), second = tlm.run(k, residue, &first);
  EXPECT_EQ(golden_difference(second.picture, tlm.run(k, residue).picture), 0);
  return second.traced;
}

// Lines that come out the same are not traced again; those of the chip's four entries often do not.
TEST(TlmPictures, TakeLinesFromPicturesByChipsWithLowerLimits) {
  knobs far = unlimited();
  far.interlace = 1;
  knobs stack = far, rooms = far;
  stack.interval_stack_depth = 4;
  rooms.max_room_depth = 5;
  const Show demo;
  for (const int frame : {1537, 5119, 7223, 9500, 11000}) {
    const TlmPictures tlm(demo, frame, {});
    EXPECT_LT(traced_after(tlm, stack, far), VisibleRows) << frame;
    EXPECT_LT(traced_after(tlm, rooms, far), VisibleRows) << frame;
    EXPECT_EQ(traced_after(tlm, far, far), 0) << frame;
    EXPECT_LE(traced_after(tlm, far, far, false), VisibleRows / 2) << frame;
  }
}

TEST(TlmPictures, TakeNoLineWhereAnotherKnobDiffersOrTheStackMayShowLinesBefore) {
  knobs cut = unlimited(), stack = unlimited();
  cut.partial_products_cut = 5;
  stack.interval_stack_depth = 4;
  const Show demo;
  const TlmPictures tlm(demo, 1537, {});
  EXPECT_EQ(traced_after(tlm, cut, unlimited()), VisibleRows);
  EXPECT_EQ(traced_after(tlm, unlimited(), stack), VisibleRows);
  const TlmPictures pattern(demo, 2500, {});
  EXPECT_EQ(traced_after(pattern, stack, unlimited()), VisibleRows) << "a ray pattern";
}

}  // namespace
}  // namespace racebeam
