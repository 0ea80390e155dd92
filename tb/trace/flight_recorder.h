// FlightRecorder: the clocks before an event, written although nobody knew that it would come.
//
// Nothing is recorded. The run leaves copies of itself behind by fork(), at most two; a copy sleeps
// until the event, and then simulates again, up to the event and with all signals on. That costs
// the run a fork() every so many clocks. A copy is used once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace racebeam {

/// What happened in a clock, and the clocks to be written.
struct FlightEvent {
  enum Kind { Condition, Mismatch, Interrupt, Crash };
  Kind kind;
  std::int64_t clock, from, to;  ///< ordinals
  int detail;    ///< Mismatch: the number of the unit in lockstep; Crash: the signal
  int port = 0;  ///< Mismatch: the number of its output
};

class FlightRecorder {
 public:
  /// Half a second of simulation between two copies.
  static constexpr std::int64_t ShortestStep = 1'000'000;

  /// Events may ask for `keep` clocks before them; a copy stands before those, not in the first.
  /// `replay` runs in a copy, which stands in the clock it was made in, and returns the exit code.
  /// From copy to copy it is `shortest_step` clocks or `keep`, whichever is more.
  FlightRecorder(std::int64_t keep, std::function<int(const FlightEvent&)> replay,
                 std::int64_t shortest_step = ShortestStep);
  /// Dismisses the copies.
  ~FlightRecorder();
  FlightRecorder(const FlightRecorder&) = delete;
  FlightRecorder& operator=(const FlightRecorder&) = delete;

  /// The run stands in `clock`; the first call, and each after some time, leaves a copy there. If
  /// the machine has no process left the older copies stay. Throws MissingTool if there is none.
  void pass(std::int64_t clock);
  /// The oldest clock that can be asked for.
  std::int64_t oldest() const { return copies_.front().clock; }
  /// Lets a copy replay, and waits for it. Returns the exit code. Throws MissingTool if it was
  /// killed.
  int replay(const FlightEvent& event);
  /// Until the end of this object a crash replays the `keep` clocks before it, and then kills the
  /// program as it would have. `clock_now`: the last clock that was whole; it is called by a
  /// signal handler.
  void catch_crashes(std::function<std::int64_t()> clock_now);

 private:
  struct Copy {
    pid_t process;
    int order;  // pipe to it
    std::int64_t clock;
  };

  static void crashed(int signal);
  [[noreturn]] void wait_for_event(int orders);
  bool copy(std::int64_t clock);
  int status_of(const FlightEvent& event);
  void dismiss(const Copy& copy);

  const std::int64_t keep_, step_;
  const std::function<int(const FlightEvent&)> replay_;
  std::function<std::int64_t()> clock_now_;
  std::vector<Copy> copies_;                              // oldest first
  std::vector<std::pair<int, struct sigaction>> before_;  // signals, and who had them
};

}  // namespace racebeam
