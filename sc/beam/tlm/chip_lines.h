// chip_lines: the chip a scan line at a time, with what a line leaves behind.
//
// Runs the registers of chip_core, so it is the chip in every clock: same pixels, counters, clocks
// and pins. Between lines the registers stand at the first clock of the next line. Time is counted
// by the caller: a line always takes line_clocks(). The sound is simulated only if asked for.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "sc/beam/chip_core.h"
#include "sc/beam/frame_stats.h"
#include "sc/beam/stats_collector.h"
#include "sc/beam/tlm/chip_observer.h"
#include "sc/beam/tlm/line_beam.h"
#include "sc/beam/tlm/line_raster.h"
#include "sc/beam/tlm/line_setting.h"
#include "sc/beam/tlm/sound_line.h"

namespace racebeam {

class chip_lines {
 public:
  struct options {
    knobs k{};
    /// Instead of the built-in demo; must outlive the chip and fit the knobs.
    const scene_program* program = nullptr;
    bool pins = false;   ///< the pins of every clock are wanted
    bool sound = false;  ///< the PWM pin is wanted
    chip_observer* observer = nullptr;
    bool apart = false;  ///< no line is to leave anything on the stacks for later ones: without a
                         ///< pattern the tracer stops when it is done
  };

  /// After one clock in reset, before line -273 of frame 0.
  explicit chip_lines(const options& o);

  /// Simulates the next line.
  void run_line();
  /// One clock in reset: before line -273 of frame 0.
  void reset();
  /// Puts the demo to the start of a frame; to be called before line -273.
  void deposit(int frame);

  /// y of the next line, -273..251, and the frame that it belongs to.
  int next_line() const { return chip_.vga_timing.v_pos_q; }
  int next_frame() const;
  int line_clocks() const { return raster_.size(); }
  /// Clock of a line in which a monitor samples a visible column, 0..639.
  int column_clock(int column) const { return raster_.column_clock[column]; }

  // The line just run.
  int y() const { return y_; }
  int frame() const { return frame_; }
  bool visible() const { return visible_; }
  /// The pixels of a visible line, r * 16 + g * 4 + b, as a monitor samples them.
  const std::array<std::uint8_t, VisibleColumns>& pixels() const { return pixels_; }
  /// uo in each clock, if wanted.
  const std::vector<std::uint8_t>& pins() const { return pins_; }
  /// Changes of the PWM pin, if wanted; the last may be one clock after the line.
  const std::vector<pwm_change>& sound() const { return sound_changes_; }

  /// The counters since the last call.
  frame_stats take_stats() { return collector_.take(); }
  /// All registers; pwm_sound's only if the sound is wanted.
  const chip_core& registers() const { return chip_; }
  /// The same, to clock them one by one or to write them; the next run_line() must find them at the
  /// first clock of a line.
  chip_core& registers() { return chip_; }

 private:
  // All units in every clock: what is rare.
  void run_slowly();
  void step(int clock);
  void observe(const chip_core& before, const chip_view& view, int clock);
  // The tracer in its own loop, the beam behind it.
  void run_fast(const line_setting& line);
  int run_camera(int clock);
  subdivider_core::outputs camera_clock(const int (&angles)[3]);
  line_counts trace(const line_setting& line, int clock);
  void last_clock();
  void count(const line_counts& counts);
  void show_pins(const vga_timing_core& begin, const line_setting& line);
  line_setting setting();
  const std::vector<room_row>& rooms(int flags);
  int angle(int src) const;

  const options options_;
  const knobs knobs_;
  const line_raster raster_;
  // Knobs of the taped-out chip; for a scene file; but for its limits.
  const bool standard_, scene_standard_, only_limits_;
  chip_core chip_;
  line_beam beam_{knobs_, raster_, chip_.interval_fifo};
  std::map<int, std::vector<room_row>> rooms_;  // by scene flags
  int y_ = FirstLine, frame_ = 0;
  bool visible_ = false;
  std::array<std::uint8_t, VisibleColumns> pixels_{};
  std::vector<std::uint8_t> pins_;
  std::vector<pwm_change> sound_changes_;
  stats_collector collector_;
  frame_stats unseen_;                 // where histograms go that nobody asks for
  int column_ = 0;                     // next column to be shown
  int decisions_ = 0;                  // of this line
  bool given_up_ = false;              // what is on offer has no wall
  bool behind_ = false;                // and the room is one behind an opening
  bool started_ = false;               // the tracer, on this line
  room_teller rooms_told_;             // of this line
  std::vector<std::uint8_t> indices_;  // display index per clock, if the pins are wanted
};

}  // namespace racebeam
