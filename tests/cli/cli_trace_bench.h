// What the tests of `racebeam trace` share: a run whose waveform is read back.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/cli/traced_chip.h"
#include "tests/cli/wave.h"

namespace racebeam {

constexpr int Period = clock_period_ps(2);
constexpr int LineClocks = 1600;  // of the taped-out chip

/// Clocks since the start of frame 0.
inline std::uint64_t ordinal(int frame, int line, int clock = 0) {
  return static_cast<std::uint64_t>(FrameClock{frame, line, clock}.ordinal(LineClocks));
}

inline std::string place(int frame, int line) {
  return std::to_string(frame) + ":" + std::to_string(line);
}

class CliTraceBench : public testing::Test {
 protected:
  Wave trace(const std::vector<std::string>& more, const std::string& file = "t.vcd",
             const std::string& scene = "demo") {
    std::vector<std::string> arguments = {"trace", scene, "-o", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program run(folder.path(), arguments);
    EXPECT_EQ(run.wait(), 0) << run.err();
    said = run.err();
    return Wave(folder / file);
  }

  /// What fst2vcd makes of an FST in the folder; back.vcd stays there.
  Wave read_back(const std::string& fst) {
    const std::string back = "fst2vcd " + (folder / fst) + " > " + (folder / "back.vcd");
    EXPECT_EQ(std::system(back.c_str()), 0);
    return Wave(folder / "back.vcd", false);
  }

  ScratchFolder folder;
  std::string said;
};

}  // namespace racebeam
