// racebeam sweep run with files that are wrong: every fault in one list, with its place and help,
// and nothing is written.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class CliSweepFaults : public CliSweepTest {
 protected:
  /// What is said of a file that cannot be run.
  std::string refusal(const std::string& text) const {
    write(text);
    const std::string said = expect(run_words("out"), 2);
    EXPECT_FALSE(fs::exists(folder / "out"));
    return said;
  }
};

TEST_F(CliSweepFaults, AllOfThemAreToldAtOnceWithTheirPlacesAndTheNearestNames) {
  const std::string said = refusal(
      "scenes = [\"hous\"]\n"
      "nam = \"x\"\n"
      "[knobs]\n"
      "fifo_entrys = 4\n"
      "dr_bits = 99\n"
      "interval_stack_depth = { from = 8, to = 4 }\n"
      "hurry_threshold = { from = 0, to = 4, step = 0 }\n"
      "fifo_entries = []\n"
      "bisection = \"pow3\"\n"
      "[[point]]\n"
      "name = \"a\"\n"
      "[[point]]\n"
      "name = \"a\"\n"
      "[search]\n"
      "method = \"nsga3\"\n"
      "[goals]\n"
      "cells = \"min\"\n"
      "busy = \"least\"\n"
      "[measure]\n"
      "timing = \"fast\"\n"
      "reference = 4\n");
  for (const char* fault :
       {"s.toml:1:11: unknown scene 'hous'", "did you mean 'house'?",
        "s.toml:2:1: unknown key 'nam'", "did you mean 'name'?",
        "s.toml:4:1: unknown knob 'fifo_entrys'", "did you mean 'fifo_entries'?",
        "s.toml:5:11: 'dr_bits' is 99", "s.toml:6:33: 'from' is 8 and 'to' is 4",
        "s.toml:7:46: 'step' is 0", "s.toml:8:16: 'fifo_entries' has an empty list",
        "s.toml:9:13: 'bisection' is 'pow3'", "s.toml:13:8: the name 'a' is used twice",
        "s.toml:15:10: 'method' is 'nsga3'", "s.toml:17:1: goal 'cells' is not measured",
        "s.toml:18:8: 'busy' is 'least'", "s.toml:20:10: 'timing' is 'fast'",
        "s.toml:21:13: ", "14 faults in s.toml"})
    EXPECT_THAT(said, HasSubstr(fault));
}

TEST_F(CliSweepFaults, ASearchWithoutPointsOrWithTooManyIsNamed) {
  EXPECT_THAT(refusal("[knobs]\nfifo_entries = [4, 6]\nwhere = \"fifo_entries > 20\"\n"),
              HasSubstr("s.toml:3:9: 'where' leaves no point"));
  const std::string said = refusal(
      "[knobs]\nhurry_threshold = { from = 0, to = 639 }\nfifo_entries = { from = 3, to = 64 }\n"
      "dr_bits = [8, 9, 10]\n");
  EXPECT_THAT(said, HasSubstr("the grid has 119040 points"));
  EXPECT_THAT(said, HasSubstr("method = \"sobol\""));
}

TEST_F(CliSweepFaults, MeasuresThatThereAreNotYetAreUnknownValues) {
  EXPECT_THAT(refusal("[measure]\nsilicon = \"osu018\"\n"),
              HasSubstr("s.toml:2:11: 'silicon' is 'osu018'"));
}

// Each is good or bad by itself, whatever the others are.
TEST_F(CliSweepFaults, OfEveryMethodSceneAndGoalAreInOneList) {
  struct Choice {
    const char* text;
    const char* fault;  ///< "": none
  };
  const Choice methods[] = {
      {"grid", ""}, {"one-by-one", ""}, {"sobol", ""}, {"nsga3", "'method' is 'nsga3'"}};
  const Choice scenes[] = {{"demo", ""}, {"my.toml", ""}, {"no.toml", "unknown scene 'no.toml'"}};
  const Choice goals[] = {{"busy = \"min\"", ""},
                          {"picture_error = { most = \"1 %\" }", ""},
                          {"cells = \"min\"", "goal 'cells' is not measured"},
                          {"bussy = \"min\"", "unknown figure 'bussy'"}};
  expect({"scene", "new", "my.toml"}, 0);
  for (const Choice& method : methods)
    for (const Choice& scene : scenes)
      for (const Choice& goal : goals) {
        write(std::string("scenes = [\"") + scene.text +
              "\"]\nframes.sample = 1\nframes.guard = 0\n" +
              "knobs.fifo_entries = [6, 8]\n[search]\nmethod = \"" + method.text + "\"\n[goals]\n" +
              goal.text + "\n");
        int faults = 0;
        for (const Choice* one : {&method, &scene, &goal}) faults += *one->fault != '\0';
        if (faults == 0 && &method != methods) continue;  // grid is run, for all
        const std::string said = expect(run_words("out", {"--dry-run"}), faults > 0 ? 2 : 0);
        for (const Choice* one : {&method, &scene, &goal}) EXPECT_THAT(said, HasSubstr(one->fault));
        if (faults == 0) continue;
        EXPECT_THAT(said, HasSubstr(std::to_string(faults) + (faults > 1 ? " faults" : " fault") +
                                    " in s.toml"));
      }
  EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace
}  // namespace racebeam
