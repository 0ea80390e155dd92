// What a sweep file without faults says, and what holds where it says nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "sc/beam/engine.h"
#include "tb/base/errors.h"
#include "tb/sweep/starter_sweep.h"
#include "tb/sweep/sweep_keys.h"
#include "tests/sweep/sweep_text.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

std::vector<int> values_of(const std::string& values) {
  const SweepFile file = sweep("[knobs]\nfifo_entries = " + values + "\n");
  return file.knobs.at(0).values;
}

std::string warnings_of(const std::string& text) {
  return read_sweep(text, "f", test_names()).faults.warnings("f");
}

TEST(SweepFileTest, AnEmptyFileIsTheChipOnTheDemo) {
  const SweepFile file = sweep("");
  EXPECT_EQ(file.name, "f");
  EXPECT_THAT(file.scenes, ElementsAre("demo"));
  EXPECT_EQ(file.frames.sample, 256);
  EXPECT_EQ(file.frames.guard, 64);
  EXPECT_EQ(file.frames.most, 2048);
  EXPECT_EQ(file.search.method, SearchMethod::Grid);
  EXPECT_EQ(file.search.seed, 1u);
  EXPECT_TRUE(file.search.race);
  EXPECT_THAT(file.goals, IsEmpty());
  EXPECT_FALSE(file.measure.causes || file.measure.silicon || file.measure.worst_picture);
  EXPECT_EQ(file.measure.reference, SweepReference::Geometry);
  EXPECT_EQ(file.base, (SweepPoint{"chip", knobs()}));
  EXPECT_THAT(told(sweep_points(file)), ElementsAre("chip"));
}

TEST(SweepFileTest, ValuesAreListsRangesAndSingleOnes) {
  EXPECT_THAT(values_of("[8, 4, 6]"), ElementsAre(8, 4, 6));
  EXPECT_THAT(values_of("7"), ElementsAre(7));
  EXPECT_THAT(values_of("{ from = 4, to = 9, step = 2 }"), ElementsAre(4, 6, 8));
  EXPECT_THAT(values_of("{ from = 4, to = 6 }"), ElementsAre(4, 5, 6));
  EXPECT_THAT(values_of("{ from = 64, to = 64, step = 61 }"), ElementsAre(64));
  EXPECT_THAT(sweep("knobs.bisection = [\"midpoint\", \"pow2\"]\n").knobs.at(0).values,
              ElementsAre(1, 0));
  EXPECT_THAT(sweep("knobs.hurry_threshold = [-1, 639]\n").knobs.at(0).values,
              ElementsAre(-1, 639));
}

TEST(SweepFileTest, AValueGivenTwiceCountsOnceAndIsWarnedOf) {
  EXPECT_THAT(values_of("[4, 5, 4]"), ElementsAre(4, 5));
  EXPECT_THAT(warnings_of("[knobs]\nfifo_entries = [4, 5, 4]\n"),
              HasSubstr("f:2:23: warning: 'fifo_entries' has 4 twice"));
}

TEST(SweepFileTest, EveryKnobOfTheTableCanBeSwept) {
  for (const std::string& name : swept_knobs(beam_engine())) {
    const knob_row& row = *swept_knob(beam_engine(), name);
    const std::string quote = row.names.empty() ? "" : "\"";
    const auto text = [&](int value) { return quote + row.text(value) + quote; };
    const SweepFile file =
        sweep("[knobs]\n" + name + " = [" + text(row.min) + ", " + text(row.max) + "]\n");
    EXPECT_THAT(file.knobs.at(0).values, ElementsAre(row.min, row.max)) << name;
    EXPECT_EQ(file.knobs.at(0).row, &row);
  }
}

TEST(SweepFileTest, FramesAreASampleOrAll) {
  const SweepFrames some = sweep(
                               "frames = { sample = 4096, guard = 0, until = { picture_error = \"5 "
                               "%\", busy = 1.5 } }\n")
                               .frames;
  EXPECT_EQ(some.sample, 4096);
  EXPECT_EQ(some.most, 4096) << "no less than the sample";
  EXPECT_EQ(some.guard, 0);
  EXPECT_THAT(some.until, ElementsAre(Pair("picture_error", 5), Pair("busy", 1.5)));
  EXPECT_EQ(sweep("frames.sample = \"all\"\n").frames.sample, 0);
  EXPECT_THAT(warnings_of("frames = { sample = \"all\", until = { busy = 1 } }\n"),
              HasSubstr("f:1:36: warning: 'until' has no effect"));
}

TEST(SweepFileTest, PartsAreLeftOutByPattern) {
  const SweepFrames usual;
  EXPECT_TRUE(usual.skips("tunnel, ray pattern"));
  EXPECT_FALSE(usual.skips("tunnel"));
  const SweepFrames own = sweep("frames.skip = [\"shot [0-3]\", \"end\"]\n").frames;
  EXPECT_TRUE(own.skips("shot 2") && own.skips("end"));
  EXPECT_FALSE(own.skips("shot 4") || own.skips("the end") || own.skips("tunnel, ray pattern"));
  EXPECT_FALSE(sweep("frames.skip = []\n").frames.skips("tunnel, ray pattern"));
}

// nsga2 needs two goals with min or max, and as many points as a generation has.
TEST(SweepFileTest, EveryMethodGoesWithEveryGoal) {
  const std::string few = "[knobs]\nfifo_entries = [4, 5]\n",
                    many = "[knobs]\nfifo_entries = { from = 4, to = 11 }\n";
  const std::vector<std::string> wishes = {"\"min\"", "\"max\"", "{ most = \"0.5 UNIT\" }",
                                           "{ least = 3 }", "{ least = 1.5, most = 2 }"};
  for (std::size_t method = 0; method < method_words().size(); ++method)
    for (const SweepFigure& figure : test_names().figures)
      for (const std::string& wish : wishes) {
        std::string written = wish;
        if (const auto at = written.find("UNIT"); at != std::string::npos)
          written.replace(at, 4, figure.unit);
        const bool searches = method_words()[method] == "nsga2";
        std::string goals = "\"" + figure.name + "\" = " + written + "\n";
        for (const char* other : {"busy", "picture_error", "starved"})
          if (searches && other != figure.name) goals += std::string(other) + " = \"max\"\n";
        const std::string search = "search = { population = 8, method = \"" +
                                   method_words()[method] + "\" }\n",
                          measure = "measure = { silicon = \"generic\", causes = true }\n";
        const SweepFile file =
            sweep(search + measure + "[goals]\n" + goals + (searches ? many : few));
        ASSERT_EQ(file.goals.size() == 1, !searches);
        const Goal& goal = file.goals[0];
        EXPECT_EQ(goal.figure, figure.name);
        EXPECT_EQ(static_cast<std::size_t>(file.search.method), method);
        EXPECT_EQ(goal.kind == GoalKind::Min, wish == wishes[0]);
        EXPECT_EQ(goal.kind == GoalKind::Max, wish == wishes[1]);
        EXPECT_EQ(goal.most.value_or(-1), wish == wishes[2] ? 0.5 : wish == wishes[4] ? 2 : -1);
        EXPECT_EQ(goal.least.value_or(-1), wish == wishes[3] ? 3 : wish == wishes[4] ? 1.5 : -1);
        EXPECT_EQ(sweep_points(file).points.size(), searches ? 8u : 3u);
      }
}

TEST(SweepFileTest, AUnitMayBeCutShort) {
  for (const char* limit : {"1530", "1530.0", "\"1530\"", "\"1530 clocks\"", "\"1530clocks\"",
                            "\"1530  clocks a line\""})
    EXPECT_EQ(sweep("goals.busy = { most = " + std::string(limit) + " }\n").goals.at(0).most, 1530)
        << limit;
}

TEST(SweepFileTest, SearchAndMeasureAreTaken) {
  const SweepFile file = sweep(
      "name = \"a\"\nscenes = [\"house\", \"demo\"]\n"
      "search = { method = \"sobol\", points = 100000, seed = 0, race = false }\n"
      "measure = { causes = true, silicon = \"generic\", timing = \"off\", "
      "pictures = [0, \"worst\", 16382], reference = \"base\" }\n[knobs]\ndr_bits = 9\n");
  EXPECT_EQ(file.name, "a");
  EXPECT_THAT(file.scenes, ElementsAre("house", "demo"));
  EXPECT_EQ(file.search.points, 100000);
  EXPECT_EQ(file.search.seed, 0u);
  EXPECT_FALSE(file.search.race);
  EXPECT_TRUE(file.measure.causes && file.measure.silicon && file.measure.worst_picture);
  EXPECT_THAT(file.measure.pictures, ElementsAre(0, 16382));
  EXPECT_EQ(file.measure.reference, SweepReference::Base);
}

TEST(SweepFileTest, PointsOfAGridAreNotCountedByHand) {
  EXPECT_THAT(warnings_of("[search]\npoints = 9\n"),
              HasSubstr("f:2:10: warning: 'points' counts for sobol only"));
  EXPECT_EQ(warnings_of("[search]\npoints = 9\nmethod = \"sobol\"\n"), "");
}

TEST(SweepFileTest, WhatAMethodDoesNotLookAtIsWarnedOf) {
  for (const char* key : {"population", "generations"})
    EXPECT_THAT(warnings_of("[search]\n" + std::string(key) + " = 12\n"),
                HasSubstr("'" + std::string(key) + "' counts for nsga2 only"));
  const std::string search =
      "goals = { busy = \"min\", picture_error = \"min\" }\n[knobs]\n"
      "fifo_entries = { from = 4, to = 64 }\n[search]\nmethod = \"nsga2\"\n";
  EXPECT_THAT(warnings_of(search + "points = 9\n"),
              HasSubstr("'population' and 'generations' say how many"));
  EXPECT_THAT(warnings_of(search + "race = true\n"), HasSubstr("'race' has no effect"));
  EXPECT_EQ(warnings_of(search + "population = 16\ngenerations = 3\nrace = false\n"), "");
}

TEST(SweepFileTest, EveryKeyOfTheTableIsKnown) {
  const std::string date = " = 1979-05-27\n";
  const std::vector<std::pair<std::string, std::string>> tables = {
      {"", ""},
      {"frames", "[frames]\n"},
      {"knobs", "[knobs]\n"},
      {"range", "[knobs.fifo_entries]\n"},
      {"point", "[[point]]\n"},
      {"base", "[base]\n"},
      {"search", "[search]\n"},
      {"goal", "[goals.busy]\n"},
      {"measure", "[measure]\n"}};
  std::size_t found = 0;
  for (const auto& [table, head] : tables)
    for (const std::string& key : keys_of(table, sweep_keys())) {
      const std::string faults = sweep_faults(head + key + date);
      EXPECT_THAT(faults, HasSubstr("'" + key + "' is a date")) << table;
      EXPECT_EQ(faults.find("unknown"), std::string::npos) << faults;
      ++found;
    }
  EXPECT_EQ(found, sweep_keys().size()) << "or a table is missing here";
}

TEST(SweepFileTest, TheStarterHasNoFaultsAndAQuestion) {
  const SweepFile file = sweep(starter_sweep());
  EXPECT_EQ(warnings_of(starter_sweep()), "");
  const std::vector<std::string> points = told(sweep_points(file));
  EXPECT_THAT(points,
              testing::IsSupersetOf({"chip", "unlimited interval_stack_depth=64 fifo_entries=64"}));
  EXPECT_EQ(points.size(), 2u + 16 - 1)
      << "the base, the named one, and what 'where' leaves without the chip";
  EXPECT_EQ(file.goals.size(), 3u);
  std::string narrower = starter_sweep();
  narrower.replace(narrower.find("<= 200"), 6, "<= 20 ");
  EXPECT_THAT(sweep_faults(narrower), HasSubstr("'where' leaves no point")) << "it asks";
}

TEST(SweepNarrowTest, TheCommandLineReplacesTheValuesOfAKnob) {
  const std::string text =
      "knobs = { fifo_entries = [4, 5], dr_bits = [8, 9] }\n"
      "[[point]]\nname = \"a\"\nknobs.fifo_entries = 20\n";
  EXPECT_THAT(told(sweep_points(sweep(text, {"fifo_entries=5"}))),
              ElementsAre("chip", "a fifo_entries=20", "p1 fifo_entries=5 dr_bits=8",
                          "p2 fifo_entries=5 dr_bits=9"));
  EXPECT_THAT(
      told(sweep_points(sweep(text, {"fifo_entries=6", "dr_bits=9", "bisection=midpoint"}))),
      ElementsAre("chip", "a fifo_entries=20", "p1 fifo_entries=6 dr_bits=9 bisection=midpoint"));
}

TEST(SweepNarrowTest, APointOfSobolKeepsItsOtherKnobs) {
  const std::string text =
      "knobs = { fifo_entries = [4, 5, 6], dr_bits = [8, 9], hurry_threshold = [1, 2, 3, 4] }\n"
      "search = { method = \"sobol\", points = 1 }\n";
  knobs whole = sweep_points(sweep(text)).points.at(1).k;
  whole.dr_bits = 13;
  EXPECT_EQ(sweep_points(sweep(text, {"dr_bits=13"})).points.at(1).k, knob_values(whole));
}

TEST(SweepNarrowTest, MayMakeAGridSmallEnoughOrLeaveNothing) {
  const std::string large =
      "knobs = { hurry_threshold = { from = 0, to = 638 }, fifo_entries = { from = 3, to = 64 }, "
      "dr_bits = [8, 9, 10], where = \"hurry_threshold > 1\" }\n";
  EXPECT_EQ(grid_points(sweep(large, {"hurry_threshold=2"})), 62 * 3);
  EXPECT_THAT(read_sweep(large, "f", test_names(), {"hurry_threshold=1"}).faults.text("f"),
              HasSubstr("'where' leaves no point"));
}

TEST(SweepNarrowTest, RefusesWhatRenderRefuses) {
  for (const char* bad : {"fifo_entrys=3", "fifo_entries=2", "fifo_entries", "navigator_bits=3"})
    EXPECT_THROW(sweep("", {bad}), UsageError) << bad;
}

}  // namespace
}  // namespace racebeam
