// PinProbe, DacProbe: hand the chip's output pins to the monitors, as a cable would.
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

/// What both have: the monitors' time, and their exceptions, which the kernel cannot carry.
class CableProbe : public sc_core::sc_module {
 public:
  /// Tells the monitors the time: every clock before the current one is known. To be called after
  /// sc_start(). Throws what a monitor or its callback threw meanwhile: the probe pauses the
  /// simulation then and is deaf from then on.
  void advance();

 protected:
  /// Clock 0 begins at `start`: the first rising edge after which rst_n is seen as 1. A monitor
  /// that is nullptr is left out. Both must outlive the probe. Throws std::invalid_argument if
  /// `period` is 0.
  CableProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& start,
             const sc_core::sc_time& period, VgaMonitor* vga, SoundMonitor* sound);

  std::uint64_t clock() const;
  /// The exceptions of `action` come out of advance().
  template <class Action>
  void guarded(Action action) {
    if (failure_) return;
    try {
      action();
    } catch (...) {
      failure_ = std::current_exception();
      sc_core::sc_pause();
    }
  }

  VgaMonitor* const vga_;
  SoundMonitor* const sound_;

 private:
  const sc_core::sc_time start_, period_;
  std::exception_ptr failure_;
};

class PinProbe : public CableProbe {
 public:
  in_port<8> uo_i{"uo_i"};    // TinyVGA pins
  in_port<1> pwm_i{"pwm_i"};  // sound

  /// As CableProbe.
  PinProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& start,
           const sc_core::sc_time& period, VgaMonitor* vga, SoundMonitor* sound = nullptr);

 private:
  void vga_changed();
  void sound_changed();
};

/// Of a converter: the monitor has converter_pinout(10).
class DacProbe : public CableProbe {
 public:
  static constexpr int Bits = 10;
  in_port<1> hsync_ni{"hsync_ni"}, vsync_ni{"vsync_ni"};
  in_port<Bits> red_i{"red_i"}, green_i{"green_i"}, blue_i{"blue_i"};

  /// As CableProbe.
  DacProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& start,
           const sc_core::sc_time& period, VgaMonitor* vga);

 private:
  void changed();
};

}  // namespace racebeam
