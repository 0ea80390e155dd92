// What Slurm says is read as it is meant: the newest job's word on a task counts.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/slurm.h"

#include <gmock/gmock.h>

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(SlurmTest, TasksAreNamedByRanges) {
  EXPECT_EQ(ranges_text({0, 1, 2, 5, 7, 8}), "0-2,5,7-8");
  EXPECT_EQ(ranges_text({3}), "3");
  EXPECT_EQ(ranges_text({}), "");
}

TEST(SlurmTest, NewestJobHasTheWord) {
  EXPECT_THAT(
      task_states("10 0 CANCELLED\n12 0 PENDING\n10 1 COMPLETED\n12 2 RUNNING\n"
                  "9 2 NODE_FAIL\n",
                  3),
      ElementsAre(Pair(0, TaskState::Live), Pair(1, TaskState::Ended), Pair(2, TaskState::Live)));
}

TEST(SlurmTest, WhatMayGoOnIsLive) {
  for (const char* state :
       {"PENDING", "RUNNING", "COMPLETING", "CONFIGURING", "SUSPENDED", "REQUEUED", "PREEMPTED"})
    EXPECT_THAT(task_states("1 0 " + std::string(state), 1), ElementsAre(Pair(0, TaskState::Live)));
  for (const char* state : {"FAILED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY"})
    EXPECT_THAT(task_states("1 0 " + std::string(state), 1),
                ElementsAre(Pair(0, TaskState::Ended)));
  EXPECT_THAT(task_states("1 0 CANCELLED", 1), ElementsAre(Pair(0, TaskState::Cancelled)));
}

TEST(SlurmTest, WordsOfWarningAreNoTasks) {
  EXPECT_TRUE(task_states("squeue: warning: slow\n\n1 N/A PENDING\n1 5-9 PENDING\n", 4).empty());
}

TEST(SlurmTest, WhatWasCancelledBeforeItBeganHasOneLineForAll) {
  EXPECT_THAT(task_states("1 N/A CANCELLED\n1 0 CANCELLED\n1 1 COMPLETED\n", 4),
              ElementsAre(Pair(0, TaskState::Cancelled), Pair(1, TaskState::Ended),
                          Pair(2, TaskState::Cancelled), Pair(3, TaskState::Cancelled)));
  EXPECT_THAT(task_states("1 N/A CANCELLED\n2 1 RUNNING\n2 2 PENDING\n2 3 FAILED\n", 4),
              ElementsAre(Pair(0, TaskState::Cancelled), Pair(1, TaskState::Live),
                          Pair(2, TaskState::Live), Pair(3, TaskState::Ended)))
      << "queued again";
  EXPECT_THAT(task_states("1 0 RUNNING\n1 1 FAILED\n2 N/A CANCELLED\n", 2),
              ElementsAre(Pair(0, TaskState::Live), Pair(1, TaskState::Cancelled)))
      << "the first job goes on";
}

TEST(SlurmTest, AFolderIsOneWordForAShell) {
  EXPECT_EQ(shell_quoted("out/a-b_1.2"), "out/a-b_1.2");
  EXPECT_EQ(shell_quoted("my out"), "'my out'");
  EXPECT_EQ(shell_quoted("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(shell_quoted(""), "''");
}

}  // namespace
}  // namespace racebeam
