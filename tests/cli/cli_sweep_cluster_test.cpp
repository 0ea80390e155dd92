// racebeam sweep run --on: what workers elsewhere answer is stored once and is what workers here
// answer; a queue that loses, cancels or refuses tasks loses no result.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class CliSweepClusterTest : public CliSweepTest {
 protected:
  static Words on(const std::string& place, const Words& more = {}) {
    Words words = {"sweep", "run", "s.toml", "-o", "out", "--on", place, "--tasks", "4"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  static Words work(int block) {
    return {"sweep", "work", "out", "--rung", "1", "--block", std::to_string(block)};
  }
  /// All is there once, as a run on this machine has it.
  void expect_whole() const {
    expect_run("local");
    EXPECT_TRUE(frames_of("out") == frames_of("local")) << "out.csv is not local.csv";
  }

  /// A queue that does what this script says; its words are in the file "asked".
  Program::Setting queue(const std::string& sbatch, const std::string& squeue = "true") const {
    const std::string bin = folder / "bin";
    fs::create_directories(bin);
    const auto script = [&](const std::string& name, const std::string& text) {
      std::ofstream(bin + "/" + name)
          << "#!/bin/bash\ncd " << folder.path() << "\necho " << name << " \"$@\" >>asked\n"
          << text << "\n";
      fs::permissions(bin + "/" + name, fs::perms::owner_all);
    };
    script("sbatch",
           "for word; do case $word in --array=*) array=${word#*=} ;; "
           "--wrap=*) wrap=${word#*=} ;; --output=*) log=${word#*=} ;; esac; done\n"
           "tasks=$(tr , '\\n' <<<$array | sed 's/\\(.*\\)-\\(.*\\)/seq \\1 \\2/;t;s/^/echo /' "
           "| bash)\nrun() { SLURM_ARRAY_TASK_ID=$1 bash -c \"$wrap\" >>${log/\\%a/$1} 2>&1; }\n" +
               sbatch);
    script("squeue", squeue);
    script("scontrol", "echo 'MaxArraySize            = 3'");
    Program::Setting setting;
    setting.environment = "PATH=" + bin + ":" + std::getenv("PATH");
    return setting;
  }
  std::string asked() const { return read_file(folder / "asked"); }
  std::string cell(const std::string& sql) const { return query(store("out"), sql).at(0); }
};

// What the fake queue does with all tasks.
constexpr const char* RunAll = "for task in $tasks; do run $task; done; echo 7";

TEST_F(CliSweepClusterTest, WorkersByHandAnswerAsWorkersHere) {
  write(SmallSweep);
  EXPECT_THAT(expect(on("hand"), 0),
              AllOf(HasSubstr("out/plan/1.json: 4 blocks"), HasSubstr("0 of 4 blocks done"),
                    HasSubstr("racebeam sweep work out --rung 1 --block N")));
  EXPECT_THAT(expect({"sweep", "status", "out"}, 0), HasSubstr("small: submitted"));
  for (const int block : {2, 0, 3}) expect(work(block), 0);
  EXPECT_THAT(expect(on("hand"), 0),
              AllOf(HasSubstr("3 of 4 blocks done"), HasSubstr("the others are 1;")));
  expect(work(1), 0);
  const std::string said = expect(on("hand"), 0);
  EXPECT_THAT(said, HasSubstr("0 failed"));
  expect_whole();
}

TEST_F(CliSweepClusterTest, ABlockThatIsDoneIsNotDoneAgain) {
  write(SmallSweep);
  expect(on("hand"), 0);
  expect(work(2), 0);
  EXPECT_THAT(expect(work(2), 0), HasSubstr("block 2 is done already"));
  EXPECT_FALSE(fs::exists(folder / "out/results/1.2.1.jsonl"));
}

TEST_F(CliSweepClusterTest, AnotherWorkerGoesOnAfterATornLine) {
  write(SmallSweep);
  expect(on("hand"), 0);
  expect(work(0), 0);
  const std::string file = folder / "out/results/1.0.0.jsonl";
  const std::string text = read_file(file);
  const std::size_t second = text.find('\n', text.find('\n') + 1) + 1;
  fs::resize_file(file, second + 30);
  expect(work(0), 0);
  const std::string rest = read_file(folder / "out/results/1.0.1.jsonl");
  const auto lines = [](const std::string& some) {
    return std::count(some.begin(), some.end(), '\n');
  };
  EXPECT_EQ(lines(rest), lines(text) - 2) << "the two whole lines are not done again";
  for (const int block : {1, 2, 3}) expect(work(block), 0);
  expect(on("hand"), 0);
  expect_whole();
}

TEST_F(CliSweepClusterTest, LinesThatAreThereTwiceAreStoredOnce) {
  write(SmallSweep);
  expect(on("hand"), 0);
  for (const int block : {0, 1, 2, 3}) expect(work(block), 0);
  fs::copy_file(folder / "out/results/1.1.0.jsonl", folder / "out/results/1.1.5.jsonl");
  expect(on("hand"), 0);
  EXPECT_EQ(cell("SELECT count(*) FROM frame"), "64");
  expect_whole();
}

TEST_F(CliSweepClusterTest, ResultsOfAnotherSweepAreRefusedAndCounted) {
  write(SmallSweep);
  expect(on("hand"), 0);
  for (const int block : {0, 1, 3}) expect(work(block), 0);
  std::string foreign = read_file(folder / "out/results/1.1.0.jsonl");
  const std::size_t lines = std::size_t(std::count(foreign.begin(), foreign.end(), '\n'));
  for (std::size_t at = 0; (at = foreign.find("{\"of\":\"", at)) != std::string::npos; ++at)
    foreign.replace(at + 7, 4, "feed");
  std::ofstream(folder / "out/results/1.2.0.jsonl") << foreign;
  EXPECT_THAT(expect(on("hand"), 0),
              AllOf(HasSubstr("results/1.2.0.jsonl: " + std::to_string(lines) +
                              " lines refused: of another model or sweep, feed"),
                    HasSubstr("3 of 4 blocks done")));
  expect(work(2), 0);
  expect(on("hand"), 0);
  expect_whole();
}

TEST_F(CliSweepClusterTest, AProgramOfAnotherModelDoesNotWork) {
  write(SmallSweep);
  expect(on("hand"), 0);
  const std::string file = folder / "out/plan/1.json";
  std::string plan = read_file(file);
  plan.replace(plan.find("\"model\":\"") + 9, 4, "feed");
  std::ofstream(file) << plan;
  EXPECT_THAT(expect(work(0), 2), AllOf(HasSubstr("plan/1.json is for the model feed"),
                                        HasSubstr("all machines need the same one")));
}

TEST_F(CliSweepClusterTest, ASweepThatHasChangedTakesWhatWasDone) {
  write(SmallSweep);
  expect(on("hand"), 0);
  for (const int block : {0, 1, 2}) expect(work(block), 0);
  std::string more = SmallSweep;
  more.replace(more.find("[2, 4]"), 6, "[2, 4, 6]");
  write(more);
  EXPECT_THAT(expect(on("hand"), 0), HasSubstr("plan/2.json: 4 blocks"));
  EXPECT_EQ(cell("SELECT count(*) FROM frame"), "48") << "three blocks of four, of 64 frames";
  for (const int block : {0, 1, 2, 3})
    expect({"sweep", "work", "out", "--rung", "2", "--block", std::to_string(block)}, 0);
  expect(on("hand"), 0);
  expect_whole();
}

TEST_F(CliSweepClusterTest, WordsThatDoNotGoTogetherAreRefused) {
  write(SmallSweep);
  expect(on("hand"), 0);
  EXPECT_THAT(expect(work(4), 2), HasSubstr("plan/1.json has no block 4: there is 0..3"));
  EXPECT_THAT(expect({"sweep", "work", "out", "--rung", "9", "--block", "0"}, 2),
              HasSubstr("plan/9.json is not there"));
  EXPECT_THAT(expect(on("moon"), 2), HasSubstr("is local, slurm or hand"));
  EXPECT_THAT(expect(on("hand", {"--no-wait"}), 2), HasSubstr("for --on slurm"));
  EXPECT_THAT(expect(on("local"), 2), HasSubstr("--jobs"));
}

TEST_F(CliSweepClusterTest, WithoutSbatchSaysWhatWorksWithoutIt) {
  write(SmallSweep);
  Program::Setting setting;
  setting.environment = "PATH=" + folder.path();
  EXPECT_THAT(expect(on("slurm"), 3, setting),
              HasSubstr("sbatch is not installed; without it: racebeam sweep run ... --jobs N"));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(CliSweepClusterTest, AnArrayIsNoLargerThanSlurmAllows) {
  write(SmallSweep);
  const std::string said =
      expect(on("slurm", {"--slurm", "--partition=night --nice=9"}), 0, queue(RunAll));
  EXPECT_THAT(said, AllOf(HasSubstr("out/plan/1.json: 3 blocks"),
                          HasSubstr("3 blocks queued, Slurm job 7: 0-2")));
  EXPECT_THAT(asked(), AllOf(HasSubstr("--partition=night --nice=9"), HasSubstr("--array=0-2 "),
                             HasSubstr("--time=10 "), HasSubstr("--requeue")));
  expect_whole();
}

TEST_F(CliSweepClusterTest, RacingQueuesAnArrayARung) {
  std::string text = SmallSweep;
  text.replace(text.find("sample = 16"), 11, "sample = 32");
  write(text + "[goals]\npicture_error = \"min\"\n");
  expect(on("slurm"), 0, queue(RunAll));
  EXPECT_TRUE(fs::exists(folder / "out/plan/3.json")) << "of 16, 24 and 32 frames";
  EXPECT_FALSE(fs::exists(folder / "out/plan/4.json"));
  expect_whole();
}

TEST_F(CliSweepClusterTest, ABlockThatIsLostIsQueuedAgain) {
  write(SmallSweep);
  const auto setting = queue(
      "for task in $tasks; do [ $task != 1 ] || [ -e lost ] || { touch lost; continue; }; run "
      "$task; "
      "done; echo 7");
  const std::string said = expect(on("slurm"), 0, setting);
  EXPECT_THAT(said, HasSubstr("1 block queued, Slurm job 7: 1"));
  expect_whole();
}

TEST_F(CliSweepClusterTest, ABlockThatIsLostThreeTimesFailsItsPoints) {
  write(SmallSweep);
  const auto setting = queue(
      "for task in $tasks; do if [ $task = 1 ]; then echo no such node >>${log/\\%a/1}; "
      "else run $task; fi; done; echo 7");
  for (int time = 0; time < 3; ++time) expect(on("slurm", {"--no-wait"}), 0, setting);
  const std::string said = expect(on("slurm", {"--no-wait"}), 1, setting);
  EXPECT_THAT(said, HasSubstr("block 1 was queued 3 times and did not come back; see log/1.1.txt"));
  const std::string words =
      read_file(folder / "out/failed/chip.txt") + read_file(folder / "out/failed/p1.txt");
  EXPECT_THAT(words, HasSubstr("no such node\nno such node\nno such node"));
  EXPECT_EQ(cell("SELECT count(*) > 0 FROM failure"), "1");
  expect(on("slurm", {"--fresh"}), 0, queue(RunAll));
  expect_whole();
}

TEST_F(CliSweepClusterTest, WhatWasCancelledWaitsForTheSameCommand) {
  write(SmallSweep);
  const auto setting =
      queue("run 0; echo 7", "[ ! -e out/log ] || { echo 7 1 CANCELLED; echo 7 N/A CANCELLED; }");
  EXPECT_THAT(expect(on("slurm"), 130, setting),
              HasSubstr("2 blocks cancelled: 1-2; the same command queues them again"));
  expect(on("slurm"), 0, queue(RunAll, "echo 7 1 CANCELLED; echo 7 2 CANCELLED"));
  expect_whole();
}

TEST_F(CliSweepClusterTest, WhatSbatchRefusesIsToldAndLeavesThePlan) {
  write(SmallSweep);
  EXPECT_THAT(expect(on("slurm"), 2, queue("echo invalid partition specified: night >&2; exit 1")),
              HasSubstr("sbatch: invalid partition specified: night"));
  EXPECT_THAT(expect(on("slurm"), 3, queue(RunAll, "echo no controller; exit 1")),
              AllOf(HasSubstr("Slurm does not answer"), HasSubstr("no controller")));
  expect(on("slurm"), 0, queue(RunAll));
  expect_whole();
}

TEST_F(CliSweepClusterTest, AControllerThatIsAwayIsWaitedFor) {
  write(SmallSweep);
  const auto setting =
      queue("(sleep 4; for task in $tasks; do run $task; done) >/dev/null 2>&1 & echo 7",
            "[ ! -e away ] || { echo away; exit 1; }; touch away");
  const std::string said = expect(on("slurm"), 0, setting);
  expect_whole();
}

}  // namespace
}  // namespace racebeam
