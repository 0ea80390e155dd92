// What a waveform of the chip must show: registers and wires of the cores, clock by clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sc/base/probe.h"
#include "sc/beam/chip_core.h"

namespace racebeam {

/// A clock of a frame.
struct FrameClock {
  int frame, line, clock;

  std::string text() const;
  /// Clocks since the start of frame 0.
  std::int64_t ordinal(int line_clocks) const;
};

/// The cores in some clock, and what a waveform is to show of it.
class TracedChip {
 public:
  /// Stands in the first clock of a frame, as a trace that begins there.
  TracedChip(const knobs& k, int frame, const scene_program* program = nullptr);
  TracedChip(const TracedChip&) = delete;
  TracedChip& operator=(const TracedChip&) = delete;

  int line_clocks() const { return line_clocks_; }
  int period() const { return clock_period_ps(knobs_.clocks_per_pixel); }
  void skip(std::int64_t clocks);
  /// Looks at the clock it stands in; then registers() and wires() can be read.
  void look();
  /// To the next clock, after look().
  void step() { now_ = next_; }

  /// All registers, by their paths in the chip.
  std::vector<probe> registers() const;
  /// The wires that follow from the registers by one call of a core, and the pins.
  std::vector<probe> wires() const;

 private:
  using Read = std::function<int()>;
  using Add = std::function<void(const std::string& name, int bits, const Read& read)>;
  using ReadAxes = std::function<vec3()>;
  using AddAxes = std::function<void(const std::string& name, int bits, const ReadAxes& read)>;
  void add_seen(const Add& add) const;  // chip_view
  void add_timing_and_choice(const Add& add, const AddAxes& add_axes) const;
  void add_tracer(const Add& add, const AddAxes& add_axes) const;

  const knobs knobs_;
  chip_core now_, next_;
  int line_clocks_ = 0;
  chip_core::pins pins_{};
  chip_view view_{};
  vga_timing_core::outputs timing_{};
  sequencer_outputs choice_{};
};

}  // namespace racebeam
