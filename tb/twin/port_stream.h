// What is driven into the inputs of a unit, clock by clock from power-up on, and its text file.
//
// Clock 0 is in reset, with all else at rest, and is not in the file. A file, as small ones are:
//
//   # racebeam-stream 1
//   unit stacks
//   hold push_en_i 1        # an input that keeps its value; hexadecimal
//   clock  sp_i  tag_i      # those that move; others rest: at 0, or at what a chip has there
//   1      0     1f
//   2..4   1     1f         # several clocks alike
//   frame 9599              # of units that count frames: both sides go to that one first
//   5      1     3
//   episode                 # from the reset on again, with all inputs at rest
//   clock  push_en_i
//   1      1
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tb/twin/legal_inputs.h"
#include "tb/twin/port_traffic.h"

namespace racebeam {

struct PortStream {
  struct Input {
    std::string name;
    int bits;
    int reset;           ///< the value that resets, -1: it does not reset
    std::uint64_t rest;  ///< the value that says least
  };

  std::string unit;
  bool counts_frames = false;         ///< the unit; only then it seeks
  std::vector<Input> inputs;          ///< all but the clock
  std::vector<std::uint64_t> values;  ///< by clock, then by input: raw bits
  std::vector<int> frames;  ///< by clock: what a counter of frames had, of what was recorded
  std::map<std::uint64_t, int> seeks;  ///< by clock: the frame that a counter of frames goes to

  std::uint64_t clocks() const { return inputs.empty() ? 0 : values.size() / inputs.size(); }
  std::uint64_t& at(std::uint64_t clock, std::size_t input) {
    return values[clock * inputs.size() + input];
  }
  std::uint64_t at(std::uint64_t clock, std::size_t input) const {
    return values[clock * inputs.size() + input];
  }

  /// Whether an input changes after the reset.
  bool moves(std::size_t input) const;
  std::size_t moving() const;
  /// Only the first `clocks` are left.
  void cut(std::uint64_t clocks);
  /// Without the clocks `from` (included) to `to` (excluded), and without `frames`; a seek in them
  /// comes behind them.
  PortStream without(std::uint64_t from, std::uint64_t to) const;
  /// In clock 0 all resets are active, and all else is at rest.
  void begin_in_reset();
};

/// A stream without clocks, for a unit with these `ports`; `legal`: what its inputs may be.
PortStream stream_of(const PortTraffic& ports, const LegalInputs& legal);

/// The text of a file; `comment`: lines for its head, each without its #. The stream begins in
/// reset.
std::string stream_text(const PortStream& stream, const std::vector<std::string>& comment);

/// The same in two: a file of several is a head and their texts. `comment`: one line.
std::string stream_head(const std::string& unit, const std::vector<std::string>& comment);
std::string episode_text(const PortStream& stream, const std::string& comment);

/// The name of the unit in a file. Throws UsageError.
std::string unit_of_stream(const std::string& path);
/// Reads a file for the unit and the inputs of `form`: its episodes, each from clock 0 on. Throws
/// UsageError with file, line, what is wrong there and what to do.
std::vector<PortStream> read_episodes(const std::string& path, const PortStream& form);
/// The same as one stream, with a clock in reset before each episode.
PortStream read_stream(const std::string& path, const PortStream& form);

}  // namespace racebeam
