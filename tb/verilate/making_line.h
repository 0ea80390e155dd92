// The line that says that RTL is being verilated.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace racebeam {

/// On a terminal a line with the time that it takes, which goes with the object; otherwise one
/// line, said once, on stderr.
class MakingLine {
 public:
  MakingLine(const std::string& module, const std::vector<std::string>& files);
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
