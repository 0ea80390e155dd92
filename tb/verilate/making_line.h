// The line that says what takes the time: RTL is being verilated, or made into gates.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace racebeam {

/// On a terminal a line with the time that it takes, which goes with the object; otherwise one
/// line, said once, on stderr.
class MakingLine {
 public:
  explicit MakingLine(const std::string& text);
  ~MakingLine();
  MakingLine(const MakingLine&) = delete;
  MakingLine& operator=(const MakingLine&) = delete;

  /// Draws the line anew when called.
  std::function<void()> tick() const;

 private:
  std::string text_;
  const bool moves_;  // the cursor
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace racebeam
