// kill -9 a hundred times, of the program, of what it has forked, of both: the finished store is
// that of an undisturbed run, and nobody is left.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <random>

#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

enum class Victim { Program, Server, Worker, Any };

class CliSweepKillTest : public CliSweepTest, public testing::WithParamInterface<Victim> {
 protected:
  /// Whom to kill now; 0: there is nobody yet.
  int victim(const Program& run) {
    const std::vector<int> servers = run.children_ids();
    std::vector<int> all;
    if (GetParam() == Victim::Server || GetParam() == Victim::Any) all = servers;
    if (GetParam() == Victim::Worker || GetParam() == Victim::Any)
      for (const int worker : workers_of(run)) all.push_back(worker);
    if (GetParam() == Victim::Program || GetParam() == Victim::Any) all.push_back(run.id());
    return all.empty() ? 0 : all[random() % all.size()];
  }

  std::mt19937 random{1};
};

TEST_P(CliSweepKillTest, ALastStoreIsThatOfAnUndisturbedRun) {
  write(SmallSweep);
  expect_run("whole");
  const std::string whole = frames_of("whole");
  MarkedProcesses own;
  Program::Setting setting;
  setting.environment = own.mark();
  for (int kills = 0, sweep = 0; kills < 100; ++sweep) {
    const std::string out = "out" + std::to_string(sweep);
    int code = -1;
    while (code < 0) {
      Program run(folder.path(), run_words(out), setting);
      while (kills < 100 && run.runs()) {
        usleep(20'000 + random() % 300'000);
        if (const int process = victim(run)) kills += kill(process, SIGKILL) == 0;
      }
      code = run.wait();
      ASSERT_LE(code, 0) << run.err();
    }
    ASSERT_EQ(frames_of(out), whole) << "after " << kills << " kills";
  }
  EXPECT_TRUE(own.become(0)) << own.count() << " processes are left";
}

std::string name_of(const testing::TestParamInfo<Victim>& info) {
  static const char* const names[] = {"Program", "Server", "Worker", "Any"};
  return names[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Of, CliSweepKillTest,
                         testing::Values(Victim::Program, Victim::Server, Victim::Worker,
                                         Victim::Any),
                         name_of);

}  // namespace
}  // namespace racebeam
