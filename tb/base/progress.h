// A progress bar on stderr, only on a terminal, and not where CI says that nobody watches.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace racebeam {

class Progress {
 public:
  /// `total` things are to be done. Draws nothing unless stderr is a terminal that can move its
  /// cursor, and the environment has no CI.
  explicit Progress(std::int64_t total, const char* things = "frames");
  /// Removes the bar.
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Draws the bar, ten times a second at most: things done, clocks a second on average if there
  /// were any, time to finish, and a note.
  void draw(std::int64_t done, std::uint64_t clocks, const std::string& note = {});
  /// Removes the bar, so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  const std::int64_t total_;
  const char* const things_;
  const bool enabled_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
  bool drawn_ = false;
};

}  // namespace racebeam
