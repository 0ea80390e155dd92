// What is counted in a frame; the schema of stats.json follows this struct.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace racebeam {

/// Counters of one frame. Unless said otherwise they cover the 480 visible lines and the clocks
/// before line_done (contract section 19 defines each).
struct frame_counters {
  std::uint64_t clocks = 0;  ///< whole frame
  std::uint64_t left_decisions = 0, right_decisions = 0, bisection_steps = 0;
  std::uint64_t adjust_steps = 0;  ///< LEFT clocks in which dr2 still walks to i2
  std::uint64_t descents = 0, pushes = 0;
  std::uint64_t returns = 0, return_clocks = 0;
  std::uint64_t emits = 0;
  std::uint64_t restarts = 0;  ///< underflow restarts
  std::uint64_t give_ups = 0;  ///< hits accepted by the hurry rule without a wall
  std::uint64_t starved_pixels = 0;
  std::uint64_t fifo_full_stalls = 0;  ///< clocks with an interval offered and not accepted
  std::uint64_t rooms_entered = 0;
  std::uint64_t merges = 0;       ///< accepted intervals of the colour before: one FIFO entry
  std::uint64_t sign_splits = 0;  ///< RIGHT decisions in which the rays' signs differ
  std::uint64_t seen_starved_pixels = 0;        ///< those that no ray pattern hides
  std::array<std::uint64_t, 65> fifo_fill{};    ///< clocks with that many entries in use
  std::array<std::uint64_t, 65> stack_depth{};  ///< clocks with that many interval stack entries
  std::array<std::uint64_t, 65> walk_steps{};   ///< LEFT decisions after that many steps of dr2
  std::array<std::uint64_t, 65> slack{};  ///< pixels shown 32 n .. 32 n + 31 clocks after they were
                                          ///< known; the last: or more. Not those that starved

  std::uint64_t decisions() const { return left_decisions + right_decisions + bisection_steps; }
};

constexpr int SlackBin = 32;  ///< clocks

/// The bin of a histogram: its last one has what is beyond, too.
inline std::uint64_t& bin_of(std::array<std::uint64_t, 65>& histogram, int value) {
  return histogram[static_cast<std::size_t>(value < 64 ? value : 64)];
}

/// What a clock of a line is spent on.
enum line_part {
  PartCamera,  ///< before the tracer starts
  PartDecide,  ///< decisions at both ends of an interval
  PartBisect,  ///< decisions between them
  PartWalk,    ///< dr2 walks to the right end
  PartEnter,   ///< the second clock of a room change, on the way down
  PartReturn,  ///< from an accepted interval to the next one
  PartWait,    ///< an interval is offered to a FIFO without room
  PartIdle,    ///< the line is done; and the last clock, which resets all
  LineParts
};

/// The same, and of each visible line clocks from its start, and the like.
struct frame_stats : frame_counters {
  std::vector<int> camera_clocks;  ///< first clock of the tracer
  std::vector<int> first_emit;     ///< first accepted interval; -1 if none
  std::vector<int> done_clock;     ///< first clock with line_done = 1; -1 if never
  std::vector<int> busy_clocks;    ///< tracer clocks before line_done
  std::vector<int> stack_needed;   ///< entries that an endless interval stack would have held
  // Clocks by line_part: they add up to those of the line.
  std::vector<int> line_camera, line_decide, line_bisect, line_walk, line_enter, line_return,
      line_wait, line_idle;

  /// Of the next line.
  void add_line(const std::array<int, LineParts>& clocks) {
    std::vector<int>* const lines[] = {&line_camera, &line_decide, &line_bisect, &line_walk,
                                       &line_enter,  &line_return, &line_wait,   &line_idle};
    for (std::size_t part = 0; part < clocks.size(); ++part) lines[part]->push_back(clocks[part]);
  }

  frame_counters& counters() { return *this; }
  const frame_counters& counters() const { return *this; }
};

}  // namespace racebeam
