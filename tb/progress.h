// A progress bar on stderr, only on a terminal.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

namespace racebeam {

class Progress {
 public:
  /// `frames` are to be done. Draws nothing unless stderr is a terminal that can move its cursor.
  explicit Progress(int frames);
  /// Removes the bar.
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Draws the bar: frames done, clocks a second on average if there were any, time to finish.
  void draw(int frames_done, std::uint64_t clocks);
  /// Removes the bar, so that something else can be printed.
  void clear();

 private:
  const int frames_;
  const bool enabled_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool drawn_ = false;
};

}  // namespace racebeam
