// ClockedWaves: a short waveform read whole, by its clocks and its signals.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/wave/vcd_reader.h"

namespace racebeam {

/// A picture with more cannot be read.
constexpr int MostPictureClocks = 400, MostPictureLanes = 100;

struct ClockedWaves {
  struct Clock {
    std::uint64_t time;  ///< of its rising edge, picoseconds
    std::string place;   ///< "frame 60, line 0"; empty if the waveform does not say
    std::string number;  ///< in its line, or since the beginning
  };
  struct Change {
    std::uint64_t time;
    std::string value;  ///< digits or a word
  };
  struct Lane {
    std::string scope, name;  ///< "chip.u_stacks", "tag_i"
    int bits;                 ///< 0: words
    bool is_clock;
    std::vector<Change> changes;
    std::string path() const { return scope.empty() ? name : scope + "." + name; }
  };
  std::vector<Clock> clocks;  ///< at least one
  std::uint64_t end = 0;      ///< of the last clock
  std::vector<Lane> lanes;    ///< those of a scope stand together, in the order of the file
};

/// Throws UsageError that says what to do if a picture of so many clocks cannot be read.
void check_picture_clocks(std::int64_t clocks);

/// Reads `vcd` to its end. `takes` chooses lanes by path. The clock, `clk_i`, is one lane however
/// many names it has; the frame, line and clock of `beam` are no lanes, for they are the ruler.
/// Throws UsageError: no clock, more clocks or lanes than above, no lane, a broken file.
ClockedWaves read_waves(VcdReader& vcd, const std::function<bool(const std::string&)>& takes);

}  // namespace racebeam
