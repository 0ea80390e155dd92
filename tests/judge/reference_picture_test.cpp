// Reference pictures do not move with the knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/reference_picture.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/core_picture.h"

namespace racebeam {
namespace {

const Show& demo() {
  static const Show show;
  return show;
}

ReferencePicture reference(PictureReference which, const knobs& k, const knobs& base = {}) {
  return {demo(), which, k, base};
}

knobs with(int knobs::*member, int value) {
  knobs k;
  k.*member = value;
  return k;
}

constexpr PictureReference All[] = {PictureReference::Geometry, PictureReference::Trace4,
                                    PictureReference::Base};

TEST(ReferencePicture, MovesWithNoKnobButThoseOfTheLook) {
  for (const PictureReference which : All) {
    const std::string key = reference(which, {}).key();
    for (const knob_info& row : knob_table())
      for (const int value : {row.min, row.max}) {
        const knobs k = with(row.member, value);
        const bool look = row.member == &knobs::interlace || row.member == &knobs::dithering ||
                          row.member == &knobs::camera_cosine;
        EXPECT_EQ(reference(which, k).key() != key, look && k != knobs{}) << row.name;
      }
  }
}

TEST(ReferencePicture, TellsTracersAndBasesApart) {
  std::set<std::string> keys;
  for (const PictureReference which : All) keys.insert(reference(which, {}).key());
  keys.insert(reference(PictureReference::Base, {}, with(&knobs::dr_bits, 12)).key());
  EXPECT_EQ(keys.size(), 4);
  EXPECT_EQ(reference(PictureReference::Trace4, {}).key(),
            reference(PictureReference::Trace4, {}, with(&knobs::dr_bits, 12)).key())
      << "a golden tracer has no base";
}

// Golden pictures of today follow the knob: the error seems small where it is large.
TEST(ReferencePicture, SeesRoomsThatAPointDoesNotEnter) {
  constexpr int Frame = 7215;
  const knobs k = with(&knobs::max_room_depth, 2);
  const GoldenPicture chip = core_picture(Frame, k);
  const int beside_own = golden_difference(
      chip, golden_picture(GoldenTracer::Geometry, GoldenWorld(Frame, k), GoldenCamera(Frame)));
  const int beside_meant =
      golden_difference(chip, reference(PictureReference::Geometry, k).picture(Frame));
  EXPECT_EQ(beside_own, 6072) << "measured when this was found";
  EXPECT_GT(beside_meant, 40'000);
}

// Where no room is as deep as the chip looks and no corner too far, the widest limits change
// nothing.
TEST(ReferencePicture, IsTheGoldenTracersPictureWhereNoLimitCounts) {
  constexpr int Frame = 1023;
  const GoldenWorld world(Frame, {});
  const GoldenCamera camera(Frame);
  EXPECT_EQ(reference(PictureReference::Geometry, {}).picture(Frame),
            golden_picture(GoldenTracer::Geometry, world, camera));
  EXPECT_EQ(reference(PictureReference::Trace4, {}).picture(Frame),
            golden_picture(GoldenTracer::Trace4, world, camera));
}

TEST(ReferencePicture, HasTheLookOfThePoint) {
  constexpr int Frame = 5119;
  for (const knobs& k : {with(&knobs::dithering, 0), with(&knobs::camera_cosine, CosineExact)})
    EXPECT_EQ(
        reference(PictureReference::Geometry, k).picture(Frame),
        golden_picture(GoldenTracer::Geometry, GoldenWorld(Frame, k), GoldenCamera(Frame, k)));
}

TEST(ReferencePicture, OfTheBaseIsItsChips) {
  constexpr int Frame = 7223;
  const knobs base = with(&knobs::interval_stack_depth, 1);
  EXPECT_EQ(reference(PictureReference::Base, {}, base).picture(Frame), core_picture(Frame, base));
  knobs dull = base;
  dull.dithering = DitheringOff;
  EXPECT_EQ(
      reference(PictureReference::Base, with(&knobs::dithering, DitheringOff), base).picture(Frame),
      core_picture(Frame, dull))
      << "with the look of the point";
}

}  // namespace
}  // namespace racebeam
