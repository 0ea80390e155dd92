// PinProbe: hands the chip's output pins to the monitors, as a cable would.
//
// Sensitive to the pins only, so it costs nothing in a clock in which they keep still. Clock n is
// the time from start + n * period on. What happens before `start` counts for clock 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>

#include "sc/base/unit.h"
#include "tb/monitor/sound_monitor.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

class PinProbe : public sc_core::sc_module {
 public:
  in_port<8> uo_i{"uo_i"};    // TinyVGA pins
  in_port<1> pwm_i{"pwm_i"};  // sound

  /// Clock 0 begins at `start`: the first rising edge after which rst_n is seen as 1. A monitor
  /// that is nullptr is left out. Both must outlive the probe. Throws std::invalid_argument if
  /// `period` is 0.
  PinProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& start,
           const sc_core::sc_time& period, VgaMonitor* vga, SoundMonitor* sound = nullptr);

  /// Tells the monitors the time: every clock before the current one is known. To be called after
  /// sc_start(). Throws what a monitor or its callback threw meanwhile: the kernel cannot carry it,
  /// so the probe pauses the simulation and is deaf from then on.
  void advance();

 private:
  void vga_changed();
  void sound_changed();
  std::uint64_t clock() const;
  template <class Action>
  void guarded(Action action);

  const sc_core::sc_time start_, period_;
  VgaMonitor* const vga_;
  SoundMonitor* const sound_;
  std::exception_ptr failure_;
};

}  // namespace racebeam
