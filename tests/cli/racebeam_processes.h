// Which processes a run of the program has left: found by a mark in their environment, whoever
// their parent is by now.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace racebeam {

class MarkedProcesses {
 public:
  explicit MarkedProcesses(const std::string& mark = next()) : mark_(mark) {}

  /// For Program::Setting::environment.
  std::string mark() const { return mark_; }
  /// Those that live now; `of_program`: what the program itself has forked to do its work, neither
  /// what it has started nor who keeps that.
  int count(bool of_program = false) const {
    return static_cast<int>(of_program ? with("comm", "racebeam\n").size() : with("", "").size());
  }
  /// The same, whose file in /proc has this text; no file: all.
  std::vector<int> with(const std::string& file, const std::string& text) const {
    std::vector<int> found;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const std::string name = entry.path().filename();
      if (name.find_first_not_of("0123456789") != std::string::npos) continue;
      if (read_file(entry.path() / "environ").find(mark_) == std::string::npos) continue;
      if (!file.empty() && read_file(entry.path() / file).find(text) == std::string::npos) continue;
      found.push_back(std::stoi(name));
    }
    return found;
  }
  /// Whether the program comes to so many processes, for a tenth of a second, within a minute.
  bool work_as(int wanted) const {
    for (int n = 0, in_a_row = 0; n < 6000; ++n, usleep(10'000)) {
      in_a_row = count(true) == wanted ? in_a_row + 1 : 0;
      if (in_a_row == 10) return true;
    }
    return false;
  }
  /// Whether there are so many of all within a minute.
  bool become(int wanted) const {
    for (int n = 0; n < 6000; ++n, usleep(10'000))
      if (count() == wanted) return true;
    return false;
  }

 private:
  static std::string next() {
    static int serial = 0;
    return "RACEBEAM_TEST_MARK=" + std::to_string(getpid()) + "_" + std::to_string(++serial) + "_";
  }
  const std::string mark_;
};

}  // namespace racebeam
