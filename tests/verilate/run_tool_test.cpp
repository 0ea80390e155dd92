// A tool that works for longer than it may is ended, and on a busy machine no sooner.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/run_tool.h"

#include <gtest/gtest.h>

#include "tb/base/work_clock.h"

namespace racebeam {
namespace {

constexpr std::chrono::seconds Second{1};

ToolRun shell(const std::string& commands) { return {{"sh", "-c", commands}, "", {}, {}, Second}; }

TEST(RunToolTest, WhatWorksTooLongIsEndedAndItsWorkCounts) {
  const auto start = WorkClock::now();
  const ToolResult end = run_tool(shell("echo begun; while :; do :; done"));
  EXPECT_FALSE(end.good);
  EXPECT_EQ(end.said.rfind("begun\n", 0), 0u) << end.said;
  EXPECT_NE(end.said.find("sh was ended by signal"), std::string::npos) << end.said;
  EXPECT_GE(WorkClock::now() - start, 9 * Second / 10);
}

TEST(RunToolTest, ToWaitIsNoWork) {
  const auto start = WorkClock::now();
  EXPECT_TRUE(run_tool(shell("sleep 1.5")).good);
  EXPECT_LT(WorkClock::now() - start, Second);
}

}  // namespace
}  // namespace racebeam
