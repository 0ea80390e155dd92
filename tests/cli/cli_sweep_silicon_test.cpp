// racebeam sweep with a yosys that fails, hangs or is not there.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"
#include "tests/support/fake_mapping.h"
#include "tests/support/fake_yosys.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// Fails on stacks of two entries as long as there is a file `broken`.
class CliSweepSilicon : public CliSweepTest {
 protected:
  CliSweepSilicon() {
    write_sweep("");
    std::ofstream(folder / "broken");
  }
  void write_sweep(const std::string& goals) const {
    write(
        "name = \"s\"\n[frames]\nsample = 4\nguard = 0\n"
        "[knobs]\ninterval_stack_depth = [2, 4]\n[measure]\nsilicon = \"generic\"\n" +
        goals);
  }
  std::string work() const {
    return "echo >>" + folder.path() +
           "/runs\n"
           "case \"$*\" in *'IntervalStackDepth 2 stacks'*)\n[ -e " +
           folder.path() + "/broken ] && echo 'ERROR: no such luck' && exit 1\n;; esac\n" +
           FakeYosys::Counts;
  }
  /// How often yosys has been run.
  std::size_t runs() const { return read_file(folder / "runs").size(); }

  static constexpr const char* Fault = "stacks with IntervalStackDepth=2: ERROR: no such luck";
};

TEST_F(CliSweepSilicon, AUnitThatYosysFailsOnIsRememberedUntilItShallBeTriedAgain) {
  const FakeYosys fake(work());
  EXPECT_THAT(expect(run_words("out"), 0), HasSubstr(std::string("no silicon of p1: ") + Fault));
  const std::size_t first = runs();
  EXPECT_GT(first, 5u);
  std::ofstream(folder / "s.toml", std::ios::app) << "# again\n";
  EXPECT_THAT(expect(run_words("out"), 0),
              AllOf(HasSubstr(std::string("no silicon of p1: ") + Fault),
                    HasSubstr("1 unit that yosys has failed on: --fresh tries again")));
  EXPECT_EQ(runs(), first);
  fs::remove(folder / "broken");
  EXPECT_THAT(expect(run_words("out", {"--fresh"}), 0), Not(HasSubstr("no silicon")));
  EXPECT_EQ(runs(), first + 1) << "the others are stored";
  EXPECT_THAT(expect(run_words("out"), 0), Not(HasSubstr("no silicon")));
  EXPECT_EQ(runs(), first + 1);
}

TEST_F(CliSweepSilicon, PointsWithoutAGoalOfSiliconFail) {
  const FakeYosys fake(work());
  write_sweep("[goals]\ncells = \"min\"\n");
  for (int start = 0; start < 2; ++start)
    EXPECT_THAT(
        expect(run_words("out"), 1),
        AllOf(HasSubstr(std::string("failed: p1: no silicon: ") + Fault), HasSubstr("1 failed")));
  EXPECT_THAT(read_file(folder / "out/failed/p1.txt"), HasSubstr(Fault));
  EXPECT_EQ(read_csv(frames_of("out")).size(), 4u) << "the chip is measured";
  fs::remove(folder / "broken");
  EXPECT_THAT(expect(run_words("out", {"--fresh"}), 0), HasSubstr("0 failed"));
  EXPECT_EQ(read_csv(frames_of("out")).size(), 8u);
}

TEST_F(CliSweepSilicon, WithoutYosysThereAreNoFiguresUntilItIsThere) {
  Program::Setting setting;
  setting.environment = "PATH=" + folder.path();
  const std::string said = expect(run_words("out"), 0, setting);
  EXPECT_THAT(said, HasSubstr("no figures of silicon: "));
  EXPECT_EQ(said.find("no figures of silicon"), said.rfind("no figures of silicon")) << "once";
  EXPECT_EQ(read_csv(frames_of("out")).size(), 8u);
  const FakeYosys fake(FakeYosys::Counts);
  const std::string now = expect(run_words("out"), 0);
  EXPECT_THAT(now, AllOf(HasSubstr("8 frames are there already"), Not(HasSubstr("no figures"))));
}

TEST_F(CliSweepSilicon, WithoutYosysAGoalOfSiliconIsMissingOnTheMachine) {
  write_sweep("[goals]\nflip_flops = \"min\"\n");
  Program::Setting setting;
  setting.environment = "PATH=" + folder.path();
  EXPECT_THAT(expect(run_words("out"), 3, setting), HasSubstr("yosys"));
}

TEST_F(CliSweepSilicon, AYosysThatHangsEndsWithTheProgram) {
  const FakeYosys fake(FakeYosys::Hangs);
  MarkedProcesses own;
  Program::Setting setting;
  setting.environment = own.mark();
  Program run(folder.path(), run_words("out"), setting);
  while (run.runs() && !fake.hangs()) usleep(1000);
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 130) << run.err();
  EXPECT_TRUE(fake.is_gone());
  EXPECT_TRUE(own.become(0)) << own.count() << " processes are left";
}

/// Two points, whose whole chips are asked for.
class CliSweepTiming : public CliSweepTest {
 protected:
  void write_sweep(const std::string& timing, const std::string& goals) const {
    write(
        "name = \"s\"\n[frames]\nsample = 4\nguard = 0\n"
        "[knobs]\ninterval_stack_depth = [2, 4]\n[measure]\ntiming = \"" +
        timing + "\"\n[goals]\n" + goals);
  }
  /// Of figures.csv, by point and figure.
  std::string value(const std::string& point, const std::string& figure) const {
    for (auto& row : read_csv(read_file(folder / "out/figures.csv")))
      if (row["point"] == point && row["figure"] == figure) return row["value"];
    return "";
  }
  std::vector<std::string> chips() const {
    return query(store("out"), "SELECT technology FROM chip ORDER BY technology");
  }
};

TEST_F(CliSweepTiming, TheFrontHasPathsAndTheBaseToo) {
  const FakeYosys yosys(MapsAChip);
  const FakeTool sta("sta", FindsAPath), nextpnr("nextpnr-ice40", Routes);
  write_sweep("front", "register_bits = \"max\"\n");  // the chip has more of them
  const std::string said = expect(run_words("out"), 0);
  EXPECT_THAT(said, AllOf(HasSubstr("2 whole chips to be mapped"),
                          HasSubstr("chip: osu018 22.50 ns, u_a.one_q[1] to u_b.two_q; about "),
                          HasSubstr("chip: ice40 12.50 MHz, u_a.one_q[1] to u_b.two_q"),
                          HasSubstr("1 on the front"), Not(HasSubstr("p1: osu018"))));
  EXPECT_EQ(value("chip", "area"), "96");
  EXPECT_EQ(value("chip", "longest_path"), "22.5");
  EXPECT_EQ(value("chip", "ice40.luts"), "3");
  EXPECT_EQ(value("chip", "ice40.clock"), "12.5");
  EXPECT_EQ(value("p1", "area"), "");
  EXPECT_EQ(chips(), (std::vector<std::string>{"ice40", "osu018"}));
  write_sweep("all", "register_bits = \"max\"\n");
  EXPECT_THAT(expect(run_words("out"), 0),
              AllOf(HasSubstr("2 whole chips to be mapped"), HasSubstr("p1: osu018 22.50 ns")));
  EXPECT_EQ(chips().size(), 4u) << "those that were there were not mapped again";
  std::ofstream(folder / "s.toml", std::ios::app) << "# again\n";
  EXPECT_THAT(expect(run_words("out"), 0), Not(HasSubstr("to be mapped")));
  EXPECT_THAT(expect({"sweep", "check", "out", "--sample", "0"}, 0), HasSubstr("sound: "));
}

TEST_F(CliSweepTiming, AChipThatFailsIsSaidUnlessItIsAGoal) {
  const FakeYosys yosys(MapsAChip);
  const FakeTool sta("sta", "[ $1 = -version ] && exit\necho Error: no\n");
  const FakeTool nextpnr("nextpnr-ice40", Routes);
  write_sweep("all", "picture_error = \"min\"\n");
  EXPECT_THAT(
      expect(run_words("out"), 0),
      AllOf(HasSubstr("no osu018 of p1: racebeam_top with IntervalStackDepth=2 in osu018: "),
            HasSubstr("p1: ice40 12.50 MHz")));
  write_sweep("all", "area = \"min\"\n");
  EXPECT_THAT(expect(run_words("out"), 1),
              AllOf(HasSubstr("no silicon: racebeam_top"), HasSubstr("--fresh tries again")));
}

TEST_F(CliSweepTiming, WithoutToolsTheModelHasFiguresStill) {
  Program::Setting setting;
  setting.environment = "PATH=" + folder.path();
  write_sweep("front", "picture_error = \"min\"\n");
  const std::string said = expect(run_words("out"), 0, setting);
  EXPECT_THAT(said, HasSubstr("no figures of osu018: yosys is not installed"));
  EXPECT_EQ(said.find("no figures of"), said.rfind("no figures of")) << "once";
  EXPECT_EQ(value("p1", "memory_bits"), "137");
  EXPECT_EQ(value("p1", "partial_products"), "114");
  EXPECT_NE(value("p1", "register_bits"), "");
  write_sweep("all", "longest_path = \"min\"\n");
  EXPECT_THAT(expect(run_words("out"), 3, setting), HasSubstr("yosys is not installed"));
}

TEST_F(CliSweepTiming, AGoalOfWholeChipsNeedsThemOfAllPoints) {
  write_sweep("front", "area = \"min\"\n");
  EXPECT_THAT(expect(run_words("out"), 2),
              AllOf(HasSubstr("goal 'area' is not measured of all points"),
                    HasSubstr("write [measure] timing = \"all\"")));
}

}  // namespace
}  // namespace racebeam
