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
                  "9 2 NODE_FAIL\n"),
      ElementsAre(Pair(0, TaskState::Live), Pair(1, TaskState::Ended), Pair(2, TaskState::Live)));
}

TEST(SlurmTest, WhatMayGoOnIsLive) {
  for (const char* state :
       {"PENDING", "RUNNING", "COMPLETING", "CONFIGURING", "SUSPENDED", "REQUEUED", "PREEMPTED"})
    EXPECT_THAT(task_states("1 0 " + std::string(state)), ElementsAre(Pair(0, TaskState::Live)));
  for (const char* state : {"FAILED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY"})
    EXPECT_THAT(task_states("1 0 " + std::string(state)), ElementsAre(Pair(0, TaskState::Ended)));
  EXPECT_THAT(task_states("1 0 CANCELLED"), ElementsAre(Pair(0, TaskState::Cancelled)));
}

TEST(SlurmTest, WordsOfWarningAreNoTasks) {
  EXPECT_TRUE(task_states("squeue: warning: slow\n\n1 N/A PENDING\n").empty());
}

TEST(SlurmTest, AFolderIsOneWordForAShell) {
  EXPECT_EQ(shell_quoted("out/a-b_1.2"), "out/a-b_1.2");
  EXPECT_EQ(shell_quoted("my out"), "'my out'");
  EXPECT_EQ(shell_quoted("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(shell_quoted(""), "''");
}

}  // namespace
}  // namespace racebeam
