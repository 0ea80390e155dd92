// Promises of tb/sweep/sweep_points.h and sweep_point.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_points.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include "sc/beam/engine.h"
#include "tb/show/set_knob.h"
#include "tests/sweep/sweep_text.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::Pair;

// Seven knobs, among them names and an uneven list: 6 * 7 * 3 * 2 * 3 * 2 * 4 points.
const std::string SevenKnobs =
    "[knobs]\ninterval_stack_depth = [1, 2, 3, 4, 6, 8]\n"
    "fifo_entries = { from = 4, to = 16, step = 2 }\nhurry_threshold = [-1, 32, 639]\n"
    "bisection = [\"pow2\", \"midpoint\"]\ndr_bits = [8, 10, 12]\n"
    "skip_shared_edges = [\"on\", \"off\"]\npartial_products_cut = [0, 5, 6, 7]\n";

std::string sobol(int points, int seed = 1) {
  return "[search]\nmethod = \"sobol\"\npoints = " + std::to_string(points) +
         "\nseed = " + std::to_string(seed) + "\n";
}

std::vector<std::string> points_of(const std::string& text) {
  return told(sweep_points(sweep(text)));
}

TEST(SweepPointsTest, AGridChangesItsLastKnobFirst) {
  EXPECT_THAT(points_of("[knobs]\nfifo_entries = [4, 6]\nbisection = \"midpoint\"\n"
                        "dr_bits = [9, 8]\n"),
              ElementsAre("chip", "p1 fifo_entries=4 dr_bits=9 bisection=midpoint",
                          "p2 fifo_entries=4 dr_bits=8 bisection=midpoint",
                          "p3 fifo_entries=6 dr_bits=9 bisection=midpoint",
                          "p4 fifo_entries=6 dr_bits=8 bisection=midpoint"));
}

TEST(SweepPointsTest, AGridHasEachCombinationOnce) {
  const SweepFile file = sweep(SevenKnobs);
  const SweepPoints points = sweep_points(file);
  EXPECT_EQ(grid_points(file), 6 * 7 * 3 * 2 * 3 * 2 * 4);
  EXPECT_EQ(points.of_search, grid_points(file));
  std::set<std::string> different, names;
  for (const SweepPoint& point : points.points) {
    different.insert(point_text(point.k));
    names.insert(point.name);
  }
  EXPECT_EQ(different.size(), points.points.size());
  EXPECT_EQ(names.size(), points.points.size());
  EXPECT_EQ(points.points.size(), points.of_search) << "the chip is one of them";
}

TEST(SweepPointsTest, OneByOneGoesAroundTheBase) {
  EXPECT_THAT(points_of("[base]\nknobs = { dr_bits = 9 }\n[search]\nmethod = \"one-by-one\"\n"
                        "[knobs]\nfifo_entries = [4, 10]\ndr_bits = [9, 8]\n"),
              ElementsAre("base dr_bits=9", "p1 fifo_entries=4 dr_bits=9", "p3 dr_bits=8"))
      << "p2 is the base";
}

TEST(SweepPointsTest, AllPointsStartFromTheBase) {
  EXPECT_THAT(
      points_of("[base]\nname = \"mine\"\nknobs = { dr_bits = 9 }\n"
                "[[point]]\nname = \"a\"\nknobs = { fifo_entries = 20 }\n"
                "[knobs]\nfifo_entries = 4\n"),
      ElementsAre("mine dr_bits=9", "a fifo_entries=20 dr_bits=9", "p1 fifo_entries=4 dr_bits=9"));
}

TEST(SweepPointsTest, WhereHoldsForPointsOfTheSearchOnly) {
  const SweepPoints points = sweep_points(
      sweep("[[point]]\nname = \"far\"\nknobs = { fifo_entries = 64 }\n[knobs]\n"
            "fifo_entries = [4, 8, 10, 12]\nbisection = [\"pow2\", \"midpoint\"]\n"
            "where = \"fifo_entries < 10 && bisection == midpoint || fifo_entries == 12\"\n"));
  EXPECT_THAT(told(points),
              ElementsAre("chip", "far fifo_entries=64", "p1 fifo_entries=4 bisection=midpoint",
                          "p2 fifo_entries=8 bisection=midpoint", "p3 fifo_entries=12",
                          "p4 fifo_entries=12 bisection=midpoint"));
  EXPECT_EQ(points.refused, 4);
  EXPECT_EQ(points.of_search, 4);
}

TEST(SweepPointsTest, WhatCountsAsTheSameIsThereOnce) {
  const SweepPoints points =
      sweep_points(sweep("[knobs]\nface_stack_depth = 4\nmax_room_depth = [3, 4, 8, 2]\n"));
  EXPECT_THAT(told(points), ElementsAre("chip", "p1 face_stack_depth=4 max_room_depth=3",
                                        "p2 face_stack_depth=4 max_room_depth=2"));
  EXPECT_EQ(points.again, 2);
}

TEST(SweepPointsTest, ANamedPointKeepsItsNameAndTheNumbersStay) {
  const std::string knobs_text = "[knobs]\nfifo_entries = [4, 5, 6]\n",
                    named = "[[point]]\nname = \"five\"\nknobs = { fifo_entries = 5 }\n";
  EXPECT_THAT(points_of(knobs_text),
              ElementsAre("chip", "p1 fifo_entries=4", "p2 fifo_entries=5", "p3 fifo_entries=6"));
  EXPECT_THAT(points_of(knobs_text + named),
              ElementsAre("chip", "five fifo_entries=5", "p1 fifo_entries=4", "p3 fifo_entries=6"));
}

TEST(SweepPointsTest, TwoNamesForOnePointAreTold) {
  const SweepPoints points =
      sweep_points(sweep("[[point]]\nname = \"as made\"\nknobs = { fifo_entries = 10 }\n"
                         "[[point]]\nname = \"a\"\nknobs = { dr_bits = 9 }\n"
                         "[[point]]\nname = \"b\"\nknobs = { dr_bits = 9 }\n"));
  EXPECT_THAT(told(points), ElementsAre("chip", "a dr_bits=9"));
  EXPECT_THAT(points.same, ElementsAre(Pair("as made", "chip"), Pair("b", "a")));
}

TEST(SweepPointsTest, AKnobThatASceneBringsIsSetOnlyIfTheSweepDoes) {
  const SweepFile file = sweep("[knobs]\ncorner_bits = [12, 11]\n");
  knobs wide;
  wide.corner_bits = 14;
  wide.portals_per_face = 2;
  EXPECT_THAT(told(sweep_points(file)), ElementsAre("chip", "p2 corner_bits=11"));
  const SweepPoints points = sweep_points(file, {knobs{}, wide});
  EXPECT_THAT(told(points), ElementsAre("chip", "p1", "p2 corner_bits=11"));
  EXPECT_EQ(knobs(knobs_on(points.points[0], wide)), wide);
  EXPECT_EQ(knobs(knobs_on(points.points[1], wide)).corner_bits, 12);
  EXPECT_EQ(knobs(knobs_on(points.points[1], wide)).portals_per_face, 2);
}

TEST(SobolPointsTest, MorePointsGoOnWithTheSequence) {
  const std::vector<std::string> few = points_of(SevenKnobs + sobol(64)),
                                 many = points_of(SevenKnobs + sobol(128));
  ASSERT_GE(few.size(), 64u);
  ASSERT_GT(many.size(), few.size());
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_EQ(sweep_points(sweep(SevenKnobs + sobol(128))).of_search, 128);
}

TEST(SobolPointsTest, SixtyFourTakeEachValueAboutEquallyOften) {
  const SweepFile file = sweep(SevenKnobs + sobol(64));
  const SweepPoints points = sweep_points(file);
  for (const KnobValues& knob : file.knobs) {
    std::map<int, int> counts;
    for (const SweepPoint& point : points.points)
      if (point.name[0] == 'p') ++counts[point.value_of(*knob.row)];
    const int fair = 64 / static_cast<int>(knob.values.size());
    ASSERT_EQ(counts.size(), knob.values.size()) << knob.row->name;
    for (const auto& [value, count] : counts)
      EXPECT_NEAR(count, fair, 3) << knob.row->name << "=" << value;
  }
}

TEST(SobolPointsTest, APowerOfTwoOfPointsIsAGridOfAnyTwoKnobs) {
  const SweepFile file =
      sweep("[knobs]\nfifo_entries = [4, 5, 6, 7]\ndr_bits = [8, 9, 11, 12]\n" + sobol(16, 3));
  const SweepPoints points = sweep_points(file);
  EXPECT_EQ(points.points.size(), 17u);
  EXPECT_EQ(points.again, 0);
}

TEST(SobolPointsTest, TheSeedShiftsThePoints) {
  EXPECT_EQ(points_of(SevenKnobs + sobol(64, 7)), points_of(SevenKnobs + sobol(64, 7)));
  EXPECT_NE(points_of(SevenKnobs + sobol(64, 7)), points_of(SevenKnobs + sobol(64, 8)));
}

TEST(SobolPointsTest, FindsEveryPointOfASmallSpaceAndEnds) {
  const SweepPoints points = sweep_points(sweep(
      "[knobs]\nfifo_entries = [4, 5, 6]\nbisection = [\"pow2\", \"midpoint\"]\n" + sobol(100000)));
  EXPECT_EQ(points.points.size(), 7u);
  EXPECT_EQ(points.of_search, 6);
  EXPECT_GE(points.again, 9000);
}

TEST(SobolPointsTest, WhereIsHeldAndThePointsAreAsManyAsWanted) {
  const SweepPoints points = sweep_points(
      sweep("[knobs]\nfifo_entries = { from = 3, to = 64 }\ndr_bits = { from = 8, to = 13 }\n"
            "where = \"fifo_entries * dr_bits < 100\"\n" +
            sobol(20)));
  EXPECT_EQ(points.of_search, 20);
  EXPECT_GT(points.refused, 20);
  for (const SweepPoint& point : points.points)
    EXPECT_TRUE(point.name == "chip" || point.k.of("fifo_entries") * point.k.of("dr_bits") < 100)
        << point.name;
}

TEST(SobolPointsTest, AllKnobsOfTheTableAreEnough) {
  std::string text = "[knobs]\n";
  for (const std::string& name : swept_knobs(beam_engine())) {
    const knob_row& row = *swept_knob(beam_engine(), name);
    if (row.names.empty())
      text += name + " = { from = " + std::to_string(row.min) +
              ", to = " + std::to_string(row.max) + " }\n";
    else text += name + " = [\"" + row.names.front() + "\", \"" + row.names.back() + "\"]\n";
  }
  const SweepPoints points = sweep_points(sweep(text + sobol(256)));
  EXPECT_EQ(points.of_search, 256);
  for (const SweepPoint& point : points.points)
    for (const knob_info& row : knob_table()) {
      EXPECT_GE(point.k.of(row.name), row.min) << row.name;
      EXPECT_LE(point.k.of(row.name), row.max) << row.name;
    }
}

TEST(SweepPointTextTest, HasEveryKnobAndReadsBack) {
  knobs k;
  for (const knob_info& row : knob_table()) k.*row.member = row.max;
  knobs back;
  std::string text = point_text(k), last;
  std::size_t lines = 0;
  for (; !text.empty(); text.erase(0, text.find('\n') + 1), ++lines) {
    const std::string line = text.substr(0, text.find('\n')), name = line.substr(0, line.find('='));
    EXPECT_LT(last, name) << "sorted";
    last = name;
    if (swept_knob(beam_engine(), name)) set_knob(back, line);
  }
  EXPECT_EQ(lines, knob_table().size());
  for (const knob_info& row : knob_table())
    EXPECT_EQ(back.*row.member, row.of_scene ? knobs{}.*row.member : row.max) << row.name;
}

TEST(SweepPointTextTest, TellsAnyTwoSettingsApart) {
  for (const knob_info& row : knob_table()) {
    knobs k;
    k.*row.member = k.*row.member == row.max ? row.min : row.max;
    EXPECT_NE(point_text(k), point_text(knobs())) << row.name;
  }
  EXPECT_THAT(point_text(knobs()), testing::StartsWith("bisection=pow2\ncamera_cosine=parabola\n"));
}

}  // namespace
}  // namespace racebeam
