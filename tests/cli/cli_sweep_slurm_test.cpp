// racebeam sweep run --on slurm with a cluster on this machine: whatever dies, all is stored once,
// and nobody is left.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/slurm_cluster.h"
#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

// Four points of 800 frames: an array of 100 has some 0.2 s a task.
constexpr const char* LargeSweep =
    "name = \"large\"\n"
    "[frames]\nsample = 800\nguard = 0\n"
    "[knobs]\ninterval_stack_depth = [2, 4]\nhurry_threshold = [32, 64]\n"
    "[measure]\nsilicon = \"off\"\n";

class CliSweepSlurmTest : public CliSweepTest {
 protected:
  void SetUp() override {
    if (const std::string why = SlurmCluster::missing(); !why.empty()) GTEST_SKIP() << why;
    cluster = std::make_unique<SlurmCluster>();
    write(LargeSweep);
  }
  void TearDown() override {
    if (!cluster) return;
    EXPECT_EQ(cluster->stop(), 0) << "processes are left";
  }

  static Words on_slurm(const Words& more = {}, const std::string& tasks = "100") {
    Words words = {"sweep", "run", "s.toml", "-o", "out", "--on", "slurm", "--tasks", tasks};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Blocks of which there is something.
  int begun() const {
    std::set<std::string> blocks;
    std::error_code ignored;
    for (const auto& file : fs::directory_iterator(folder / "out/results", ignored)) {
      const std::string name = file.path().filename();
      blocks.insert(name.substr(0, name.find('.', 2)));
    }
    return static_cast<int>(blocks.size());
  }
  void wait_for_blocks(int number) const {
    ASSERT_TRUE(SlurmCluster::within(300, [&] { return begun() >= number; })) << begun();
  }
  void expect_whole() const {
    expect_run("local");
    EXPECT_EQ(query(store("out"), "SELECT count(*) FROM frame").at(0), "3200");
    EXPECT_TRUE(frames_of("out") == frames_of("local")) << "out.csv is not local.csv";
  }

  std::unique_ptr<SlurmCluster> cluster;
};

TEST_F(CliSweepSlurmTest, NothingIsLostOrDoubledWhoeverDies) {
  Program run(folder.path(), on_slurm());
  wait_for_blocks(5);
  cluster->kill_node("n2");
  wait_for_blocks(20);
  cluster->kill_controller();
  sleep(10);
  cluster->start_controller();
  cluster->start_node("n2");
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.err(), HasSubstr("100 blocks queued"));
  EXPECT_EQ(begun(), 100);
  expect_whole();
}

TEST_F(CliSweepSlurmTest, ACommandThatDidNotWaitCollectsLater) {
  EXPECT_THAT(expect(on_slurm({"--no-wait"}), 0),
              AllOf(HasSubstr("100 blocks queued"), HasSubstr("of 100 blocks done")));
  wait_for_blocks(5);
  EXPECT_THAT(expect(on_slurm({"--no-wait"}), 0), HasSubstr("of 100 blocks done"));
  Program collector(folder.path(), on_slurm());
  wait_for_blocks(20);
  collector.signal(SIGKILL);
  EXPECT_EQ(collector.wait(), -SIGKILL);
  wait_for_blocks(100);
  const std::string said = expect(on_slurm(), 0);
  EXPECT_THAT(said, testing::Not(HasSubstr("queued"))) << "nothing was missing";
  expect_whole();
}

TEST_F(CliSweepSlurmTest, ACancelledArrayGoesOnWithTheSameCommand) {
  Program run(folder.path(), on_slurm({}, "10"));
  wait_for_blocks(2);
  SlurmCluster::run("scancel --user=$(id -un)");
  EXPECT_EQ(run.wait(), 130) << run.err();
  EXPECT_THAT(run.err(), AllOf(HasSubstr("blocks cancelled: "), HasSubstr("frames are kept")));
  EXPECT_LT(begun(), 10);
  expect(on_slurm({}, "10"), 0);
  expect_whole();
}

// Six blocks of some 60 s. What the queue costs is printed, not judged: other work on the machine
// would decide it.
TEST_F(CliSweepSlurmTest, BothQueuesStoreTheSameAndSayWhatTheyTook) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  write(
      "name = \"minutes\"\n"
      "[frames]\nsample = 1800\nguard = 0\n"
      "[knobs]\ninterval_stack_depth = [2, 3, 4]\nhurry_threshold = [32, 64]\n"
      "fifo_entries = [6, 8, 10]\n"
      "[measure]\nsilicon = \"off\"\n");
  Clock::time_point begin = Clock::now();
  expect(on_slurm({}, "6"), 0);
  const double queued = seconds_since(begin);
  begin = Clock::now();
  expect_run("local");
  const double local = seconds_since(begin);
  std::printf("32,400 frames in six blocks: Slurm %.1f s, --jobs 2 %.1f s, ratio %.3f\n", queued,
              local, queued / local);
  EXPECT_TRUE(frames_of("out") == frames_of("local")) << "out.csv is not local.csv";
}

}  // namespace
}  // namespace racebeam
