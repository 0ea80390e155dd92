// wired_chip: a chip of any engine, wired with signals, as a bench sees it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/frame_counts.h"
#include "sc/base/unit.h"

namespace racebeam {

class rtl_instance;

/// Its children are its units, u_<unit>, and the wires between them; or modules with such children.
class wired_chip : public sc_core::sc_module {
 public:
  /// The screen at a chip's pins.
  struct video_pins {
    int bits = 2;   ///< of a colour; 2: the eight pins of TinyVGA, else those of a converter
    int delay = 0;  ///< clocks that its raster is behind the clock of the chip's first line
  };
  virtual video_pins video() const { return {}; }

  /// What the bench has at the chip's pins.
  struct pins {
    sc_core::sc_signal_in_if<bool>& clk;  ///< of which the rising edges count
    wire<1>& rst_n;
    wire<8>& uo;  ///< {hsync, B0, G0, R0, vsync, B1, G1, R1}
    wire<1>& pwm;
    wire<1>&hsync_n, &vsync_n;    ///< to the monitor of a converter
    wire<10>&red, &green, &blue;  ///< to the converter
  };
  /// Binds all ports. Pins that no bench drives get wires of their own, which hold 0.
  virtual void connect(const pins& bench) = 0;
  /// The reset is over: pins that hold a knob get its value.
  virtual void set_pins() {}

  /// Puts it to the start of a frame (back door; in the first clock of a frame).
  virtual void deposit(int frame) = 0;
  /// The same for RTL beside a unit, or beside the whole chip.
  virtual void deposit_beside(const std::string& unit, rtl_instance& rtl, int frame) const = 0;

  /// A clock to be counted, at its end, its wires settled.
  virtual void count() = 0;
  /// What was counted since the last call.
  virtual frame_counts take_counts() = 0;

  /// All modules in it: its units, and those that only hold others.
  std::vector<sc_core::sc_module*> modules() const;

 protected:
  using sc_core::sc_module::sc_module;
};

}  // namespace racebeam
