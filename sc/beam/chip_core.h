// chip_core: all cores of the chip in one clocked loop, without SystemC.
//
// The wiring of chip.h as function calls, in the evaluation order of contract section 4.1. Same
// pins and registers on every clock; used where no waveform and no swap is wanted, and as the
// reference for the wiring of the SystemC chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/camera_unit.h"
#include "sc/beam/chip_view.h"
#include "sc/beam/decision_datapath.h"
#include "sc/beam/interval_fifo.h"
#include "sc/beam/navigator.h"
#include "sc/beam/pixel_output.h"
#include "sc/beam/pwm_sound.h"
#include "sc/beam/ray_stepper.h"
#include "sc/beam/scene_rom.h"
#include "sc/beam/stacks.h"
#include "sc/beam/subdivider.h"
#include "sc/beam/timeline.h"
#include "sc/video/vga_timing.h"

namespace racebeam {

struct chip_core {
  /// The chip with its own demo, or with a program, which must outlive it and fit the knobs.
  explicit chip_core(const scene_program* program = nullptr);

  const scene_program* program;
  vga_timing_core vga_timing;
  sequencer_core sequencer;
  timeline_core timeline;
  camera_unit_core camera_unit;
  ray_stepper_core ray_stepper;
  subdivider_core subdivider;
  stacks_core stacks;
  decision_datapath_core decision_datapath;
  navigator_core navigator;
  interval_fifo_core interval_fifo;
  pwm_sound_core pwm_sound;

  struct pins {
    int uo;
    bool pwm;
  };

  /// The pins before the edge, then the edge; `view` receives the wires if given.
  pins clock(bool rst_n, const knobs& k, chip_view* view = nullptr);
  /// The same of all units but pwm_sound, on which no other depends: the pins uo.
  int clock_video(bool rst_n, const knobs& k, chip_view* view = nullptr);
  /// Whether all registers that clock_video() writes are equal.
  bool same_video(const chip_core& other) const;
  /// Frame counter.
  int frame() const { return program ? timeline.frame_q : sequencer.frame_q; }
  /// Puts the demo to the start of `frame`; to be called in the first clock of a frame.
  void deposit(int frame, const knobs& k);
};

/// The navigator at the start of a frame of the demo, 0..12798, or of a program: flown there frame
/// by frame from the last restart of the flight (contract section 13), in the units' own
/// arithmetic.
navigator_core fly_to(int frame, const knobs& k, const scene_program* program = nullptr);

}  // namespace racebeam
