// Promises of tb/trace/flight_recorder.h, held without a chip: the run is a count of clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/flight_recorder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <utility>
#include <vector>

#include "tb/base/errors.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

constexpr std::int64_t Keep = 299'999, Step = 200'000;
constexpr int Replayed = 7;  ///< exit code of a replay

class FlightRecorderTest : public testing::Test {
 protected:
  /// What a copy found: the clock it stands in, the event.
  struct Found {
    std::int64_t stands, from, to;
    int kind, detail;
  };

  FlightRecorderTest() {
    replay = [this](const FlightEvent& event) {
      std::ofstream(folder / "found") << clock << ' ' << event.from << ' ' << event.to << ' '
                                      << event.kind << ' ' << event.detail;
      return Replayed;
    };
  }
  void run_to(FlightRecorder& recorder, std::int64_t end) {
    for (; clock <= end; clock += 100'000) recorder.pass(clock);
  }
  Found found() const {
    Found f{};
    std::ifstream(folder / "found") >> f.stands >> f.from >> f.to >> f.kind >> f.detail;
    return f;
  }
  static bool has_children() { return waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD; }

  ScratchFolder folder;
  std::int64_t clock = 0;
  std::function<int(const FlightEvent&)> replay;
};

TEST_F(FlightRecorderTest, ACopyStandsBeforeWhatItIsToWrite) {
  FlightRecorder recorder(Keep, replay, Step);
  run_to(recorder, 1'250'000);
  const std::int64_t event = 1'250'000;
  EXPECT_EQ(recorder.replay({FlightEvent::Condition, event, event - Keep, event + 5, 0}), Replayed);
  EXPECT_EQ(found().stands, 900'000) << "the newest of 0, 300000, ... that is not too late";
  EXPECT_EQ(found().from, event - Keep);
  EXPECT_EQ(found().to, event + 5);
  EXPECT_EQ(found().kind, FlightEvent::Condition);
}

TEST_F(FlightRecorderTest, WhateverItsClockAnEventFindsACopyFarEnoughBack) {
  for (std::int64_t event = 0; event < 1'500'000; event += 70'000) {
    FlightRecorder recorder(Keep, replay, Step);
    clock = 0;
    run_to(recorder, event);
    recorder.replay({FlightEvent::Condition, event, event - Keep, event, 0});
    EXPECT_LE(found().stands, std::max<std::int64_t>(event - Keep, 0)) << event;
    EXPECT_LE(recorder.oldest(), std::max<std::int64_t>(event - Keep, 0));
  }
}

TEST_F(FlightRecorderTest, ForAFewClocksCopiesAreFarApart) {
  FlightRecorder recorder(10, replay);
  run_to(recorder, 1'900'000);
  EXPECT_EQ(recorder.oldest(), 0);
  recorder.replay({FlightEvent::Condition, 1'900'000, 1'899'990, 1'900'000, 0});
  EXPECT_EQ(found().stands, 1'000'000);
}

TEST_F(FlightRecorderTest, AtTheBeginningThereIsLessToKeep) {
  FlightRecorder recorder(Keep, replay, Step);
  run_to(recorder, 100'000);
  EXPECT_EQ(recorder.oldest(), 0);
  recorder.replay({FlightEvent::Interrupt, 100'000, -200'000, 100'000, 0});
  EXPECT_EQ(found().stands, 0);
}

TEST_F(FlightRecorderTest, NoMoreThanTwoCopiesAreAliveAndNoneIsLeft) {
  {
    FlightRecorder recorder(Keep, replay, Step);
    run_to(recorder, 3'000'000);
    EXPECT_EQ(recorder.oldest(), 2'700'000);
    EXPECT_TRUE(has_children());
  }
  EXPECT_FALSE(has_children());
  EXPECT_FALSE(std::ifstream(folder / "found").good()) << "dismissed copies do nothing";
}

TEST_F(FlightRecorderTest, WhatACopyThrowsIsItsExitCode) {
  for (const auto& [error, code] :
       {std::pair{std::make_exception_ptr(UsageError("no such signal")), ExitUsage},
        {std::make_exception_ptr(MissingTool("no vcd2fst")), ExitMissing}}) {
    FlightRecorder recorder(
        Keep, [error = error](const FlightEvent&) -> int { std::rethrow_exception(error); });
    recorder.pass(0);
    EXPECT_EQ(recorder.replay({FlightEvent::Condition, 1, 0, 1, 0}), code);
  }
}

TEST_F(FlightRecorderTest, ACopyThatDiesIsTold) {
  FlightRecorder recorder(Keep, [](const FlightEvent&) -> int { abort(); });
  recorder.pass(0);
  EXPECT_THROW(recorder.replay({FlightEvent::Condition, 1, 0, 1, 0}), MissingTool);
}

// A process of its own crashes; its copy writes; it dies as it would have.
TEST_F(FlightRecorderTest, ACrashWritesWhatWasBeforeIt) {
  for (const int number : {SIGSEGV, SIGABRT, SIGFPE}) {
    const pid_t crashing = fork();
    if (crashing == 0) {
      FlightRecorder recorder(Keep, replay, Step);
      recorder.catch_crashes([this] { return clock - 1; });
      run_to(recorder, 1'000'000);
      raise(number);
      _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(crashing, &status, 0), crashing);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), number);
    EXPECT_EQ(found().to, 1'099'999);
    EXPECT_EQ(found().from, 1'100'000 - Keep);
    EXPECT_EQ(found().stands, 600'000);
    EXPECT_EQ(found().kind, FlightEvent::Crash);
    EXPECT_EQ(found().detail, number);
  }
}

// The stack is full: the handler has one of its own.
TEST_F(FlightRecorderTest, AFullStackIsACrashToo) {
  const pid_t crashing = fork();
  if (crashing == 0) {
    FlightRecorder recorder(Keep, replay, Step);
    recorder.catch_crashes([] { return 5; });
    recorder.pass(0);
    volatile int depth = 0;
    std::function<int(int)> fall = [&](int n) {
      volatile char frame[4096] = {};
      depth = depth + frame[0];
      return n > 0 ? fall(n + 1) + frame[1] : 0;
    };
    _exit(fall(1));
  }
  int status = 0;
  ASSERT_EQ(waitpid(crashing, &status, 0), crashing);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGSEGV);
  EXPECT_EQ(found().to, 5);
}

}  // namespace
}  // namespace racebeam
