// racebeam sweep with a yosys that fails, hangs or is not there.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"
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

}  // namespace
}  // namespace racebeam
