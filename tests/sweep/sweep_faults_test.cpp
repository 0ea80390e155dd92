// Every fault of a sweep file, with its line, its column and what to do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "tb/base/errors.h"
#include "tests/sweep/sweep_text.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const BadSweep BadSweeps[] = {
    {"NotToml", "name = \n", "1:8: not TOML", "toml.io"},
    {"UnknownTopKey", "[knob]\n", "1:2: unknown key 'knob' in the file", "'knobs'?"},
    {"NameIsNumber", "name = 3\n", "1:8: 'name' is a whole number", "a text in quotes"},
    {"EmptyName", "name = \"\"\n", "1:8: 'name' is empty", "write a name"},
    {"TableWanted", "frames = 3\n", "1:10: 'frames' is a whole number", "a table"},

    {"ScenesIsText", "scenes = \"demo\"\n", "1:10: 'scenes' is a string", "[\"demo\"]"},
    {"NoScenes", "scenes = []\n", "1:10: 'scenes' is an array", "a list of names"},
    {"SceneIsNumber", "scenes = [\"demo\", 3]\n", "1:19: 'scenes' is a whole number", "names"},
    {"UnknownScene", "scenes = [\"demo\",\n  \"hose\"]\n", "2:3: unknown scene 'hose'", "'house'?"},
    {"SceneTwice", "scenes = [\"demo\", \"demo\"]\n", "1:19: scene 'demo' is there twice", "leave"},

    {"UnknownFramesKey", "[frames]\n  sampel = 3\n", "2:3: unknown key 'sampel' in 'frames'",
     "'sample'?"},
    {"SampleOfNone", "frames.sample = 0\n", "1:17: 'sample' is 0", "1..16383"},
    {"SampleOfMoreThanTheCounter", "frames.sample = 16384\n", "1:17: 'sample' is 16384",
     "1..16383: frames of each point, or \"all\""},
    {"SampleIsWord", "frames.sample = \"most\"\n", "1:17: 'sample' is 'most'", "one of all"},
    {"SkipIsText", "frames.skip = \"*\"\n", "1:15: 'skip' is a string", "a list of patterns"},
    {"SkipOfNumbers", "frames.skip = [\"a\", 3]\n", "1:21: 'skip' is a whole number", "a text"},
    {"GuardBelowNone", "frames.guard = -1\n", "1:16: 'guard' is -1", "0..16383"},
    {"MostBelowSample", "frames = { sample = 64, most = 32 }\n",
     "1:32: 'most' is 32 and 'sample' is 64", "at least 'sample'"},
    {"MostBelowUsualSample", "[frames]\nmost = 32\n", "2:8: 'most' is 32 and 'sample' is 256",
     "at least 'sample'"},
    {"UntilIsText", "frames.until = \"5 %\"\n", "1:16: 'until' is a string", "a table of figures"},
    {"UntilUnknownFigure", "frames.until = { bussy = \"5 %\" }\n", "1:18: unknown figure 'bussy'",
     "'busy'?"},
    {"UntilExactFigure", "frames.until = { cells = \"5 %\" }\n", "1:18: 'cells' has no interval",
     "leave it out"},
    {"UntilLargest", "frames.until = { \"busy.max\" = \"5 %\" }\n",
     "1:18: 'busy.max' has no interval", "leave it out"},
    {"UntilNothing", "frames.until = { busy = \"0 %\" }\n", "1:25: 'busy' is not in 0..100 %",
     "in % of it"},
    {"UntilWide", "frames.until = { busy = 101 }\n", "1:25: 'busy' is not in 0..100 %", "\"5 %\""},
    {"UntilInClocks", "frames.until = { busy = \"5 clocks\" }\n", "1:25: 'busy' is '5 clocks'",
     "a number and its unit, \"0.5 %\""},

    {"UnknownMethod", "search.method = \"nsga3\"\n", "1:17: 'method' is 'nsga3'",
     "it must be one of grid, one-by-one, sobol, nsga2"},
    {"MethodIsNumber", "search.method = 1\n", "1:17: 'method' is a whole number", "a text"},
    {"NoPoints", "search.points = 0\n", "1:17: 'points' is 0", "1..100000"},
    {"TooManyPoints", "search.points = 100001\n", "1:17: 'points' is 100001", "1..100000"},
    {"SeedBelowZero", "search.seed = -1\n", "1:15: 'seed' is -1", "0..2147483647"},
    {"RaceIsText", "search.race = \"on\"\n", "1:15: 'race' is a string", "true or false"},
    {"UnknownSearchKey", "search.zzz = 3\n", "1:8: unknown key 'zzz' in 'search'",
     "there is: method, points, population, generations, seed, race"},
    {"PopulationOfFew", "search.population = 4\n", "1:21: 'population' is 4", "8..100000"},
    {"GenerationsOfNone", "search.generations = 0\n", "1:22: 'generations' is 0", "1..100000"},
    {"PopulationNotByFours", "search = { method = \"nsga2\", population = 30 }\n",
     "1:43: 'population' is 30", "a multiple of 4"},
    {"GenerationsTooMany", "[search]\nmethod = \"nsga2\"\ngenerations = 3125\n",
     "3:15: 'generations' is 3125 and 'population' is 32", "100000 points together"},
    {"PopulationTooLarge", "[search]\nmethod = \"nsga2\"\npopulation = 10000\n",
     "2:10: 'generations' is 12 and 'population' is 10000", "100000 points together"},
    {"SearchWithoutGoals", "search.method = \"nsga2\"\n", "1:17: nsga2 has 0 goals", "two or more"},
    {"SearchWithOneGoal",
     "search.method = \"nsga2\"\n[goals]\nbusy = \"min\"\nstarved = { most = 1 }\n",
     "1:17: nsga2 has 1 goal", "two or more"},
    {"SearchOfFewPoints",
     "search = { method = \"nsga2\", population = 8 }\n"
     "goals = { busy = \"min\", picture_error = \"min\" }\n[knobs]\ndr_bits = [8, 9, 10]\n",
     "3:1: the knobs make 3 points, and a generation has 8", "method = \"grid\""},
    {"SearchWithoutKnobs",
     "search = { method = \"nsga2\", population = 8 }\n"
     "goals = { busy = \"min\", picture_error = \"min\" }\n",
     "1:21: the knobs make 1 point, and a generation has 8", "method = \"grid\""},
    {"WhereLeavesFewToASearch",
     "search = { method = \"nsga2\", population = 8 }\n"
     "goals = { busy = \"min\", picture_error = \"min\" }\n[knobs]\n"
     "fifo_entries = { from = 3, to = 64 }\nwhere = \"fifo_entries < 8\"\n",
     "5:9: 'where' leaves 5 points, and a generation has 8", "method = \"grid\""},
    {"GridTooLarge",
     "[knobs]\nhurry_threshold = { from = 0, to = 638 }\nfifo_entries = { from = 3, to = 64 }\n"
     "dr_bits = [8, 9, 10]\n",
     "1:1: the grid has 118854 points", "it may have 100000; [search] method = \"sobol\""},

    {"GoalsIsList", "goals = [\"cells\"]\n", "1:9: 'goals' is an array", "a table of figures"},
    {"UnknownGoal", "[goals]\npicture_eror = \"min\"\n", "2:1: unknown figure 'picture_eror'",
     "'picture_error'?"},
    {"UnknownGoalWord", "[goals]\nstarved = \"least\"\n", "2:11: 'starved' is 'least'", "min, max"},
    {"GoalIsNumber", "[goals]\nstarved = 3\n", "2:11: 'starved' is a whole number",
     "\"min\", \"max\" or { most = 1 }"},
    {"GoalWithoutLimit", "[goals]\nstarved = {}\n", "2:11: 'starved' has no limit", "most = 1"},
    {"UnknownLimit", "[goals]\nstarved = { mst = 1 }\n", "2:13: unknown key 'mst' in 'goal'",
     "'most'?"},
    {"LimitIsBoolean", "[goals]\nstarved = { most = true }\n", "2:20: 'most' is true or false",
     "a number, or one with its unit, \"0.5 %\""},
    {"LimitIsWord", "[goals]\nstarved = { most = \"few\" }\n", "2:20: 'most' is 'few'",
     "\"0.5 %\""},
    {"LimitInWrongUnit", "[goals]\nstarved = { most = \"3 clocks\" }\n",
     "2:20: 'most' is '3 clocks'", "\"0.5 %\""},
    {"LimitOfHalfAWord", "[goals]\nbusy = { most = \"3 clock\" }\n", "2:17: 'most' is '3 clock'",
     "\"0.5 clocks a line\""},
    {"LimitInfinite", "[goals]\nstarved = { least = -inf }\n",
     "2:21: 'least' is not a finite number", "\"0.5 %\""},
    {"LimitNotANumber", "[goals]\nstarved = { least = \"nan %\" }\n",
     "2:21: 'least' is not a finite number", "\"0.5 %\""},
    {"LimitTooHuge", "[goals]\nstarved = { least = \"1e999 %\" }\n", "2:21: 'least' is '1e999 %'",
     "a number and its unit"},
    {"LimitsCrossed", "[goals]\nstarved = { least = 3, most = 2 }\n",
     "2:21: 'least' is more than 'most'", "exchange them"},
    {"CellsWithoutSilicon", "[goals]\ncells = \"min\"\n", "2:1: goal 'cells' is not measured",
     "[measure] silicon = \"generic\""},
    {"CellsWithSiliconOff", "measure.silicon = \"off\"\n[goals]\nflip_flops = { most = 500 }\n",
     "3:1: goal 'flip_flops' is not measured", "[measure] silicon = \"generic\""},
    {"CauseWithoutCauses", "[goals]\n\"error.give_up\" = \"min\"\n",
     "2:1: goal 'error.give_up' is not measured", "[measure] causes = true"},

    {"CausesIsNumber", "measure.causes = 1\n", "1:18: 'causes' is a whole number", "true or false"},
    {"SiliconOfLibrary", "measure.silicon = \"osu018\"\n", "1:19: 'silicon' is 'osu018'",
     "it must be one of off, generic"},
    {"TimingOfFast", "measure.timing = \"fast\"\n", "1:18: 'timing' is 'fast'",
     "it must be one of off, front, all"},
    {"UnknownReference", "measure.reference = \"trace3\"\n", "1:21: 'reference' is 'trace3'",
     "geometry, trace4, base"},
    {"PicturesIsNumber", "measure.pictures = 3\n", "1:20: 'pictures' is a whole number",
     "a list of frames"},
    {"PictureBeyondTheCounter", "measure.pictures = [3, 16383]\n", "1:24: 'pictures' is 16383",
     "0..16382: a frame, or \"worst\""},
    {"PictureIsWord", "measure.pictures = [\"best\"]\n", "1:21: 'pictures' is 'best'",
     "one of worst"},
    {"UnknownMeasureKey", "measure.power = true\n", "1:9: unknown key 'power' in 'measure'",
     "there is: causes, silicon"},
};

class SweepFaultTest : public testing::TestWithParam<BadSweep> {};

TEST_P(SweepFaultTest, HasItsPlaceAndHelpAndIsTheOnlyOne) { expect_fault(GetParam()); }

INSTANTIATE_TEST_SUITE_P(All, SweepFaultTest, testing::ValuesIn(BadSweeps),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SweepFaultsTest, AllAreReportedAtOnceInTheOrderOfTheFile) {
  const std::string faults = sweep_faults(
      "scenes = [\"x\"]\n[frames]\nsample = 0\n[knobs]\nfifo_entries = []\nwhere = \"3\"\n"
      "[[point]]\nname = \"p1\"\n[search]\nmethod = \"nsga3\"\n[goals]\ncells = \"min\"\n"
      "[measure]\ntiming = \"fast\"\n");
  std::size_t at = 0;
  for (const char* place :
       {"f:1:11:", "f:3:10:", "f:5:16:", "f:6:9:", "f:8:8:", "f:10:10:", "f:12:1:", "f:14:10:"}) {
    const std::size_t found = faults.find(place, at);
    ASSERT_NE(found, std::string::npos) << place << "\n" << faults;
    at = found;
  }
}

TEST(SweepFaultsTest, NoPointIsMissedBeforeTheFileIsRight) {
  EXPECT_THAT(sweep_faults("[knobs]\nfifo_entries = [1]\nwhere = \"fifo_entries > 9\"\n"),
              AllOf(HasSubstr("f:2:17:"), Not(HasSubstr("leaves no point"))));
}

TEST(SweepFaultsTest, NothingReachesTheTerminalUnquoted) {
  const std::string faults = sweep_faults(
      "\"\\u001b[31m\" = 1\nscenes = [\"\\u001b\"]\n[knobs]\n\"\\u001b\" = 1\n"
      "[[point]]\nname = \"\\u001b\"\n[goals]\n\"\\u001b\" = 1\nbusy = { most = \"\\u001b\" }\n");
  EXPECT_EQ(faults.find('\033'), std::string::npos) << faults;
  EXPECT_THAT(faults, HasSubstr("f:9:17:"));
}

TEST(SweepFaultsTest, AFileThatCannotBeReadIsAFault) {
  EXPECT_THAT(read_sweep_file("no/such.toml", test_names()).faults.text("f"),
              AllOf(HasSubstr("f: cannot be read: No such file"), HasSubstr("racebeam sweep new")));
  EXPECT_THAT(read_sweep_file(".", test_names()).faults.text("f"),
              AllOf(HasSubstr("f: this is a folder"), HasSubstr("name a sweep file")));
}

TEST(SweepFaultsTest, ACommandIsToldOfAllAndEnds) {
  testing::internal::CaptureStderr();
  EXPECT_THROW(load_sweep("no/such.toml", test_names()), UsageError);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("no/such.toml: cannot be read"));
}

}  // namespace
}  // namespace racebeam
