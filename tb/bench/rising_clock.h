// rising_clock: the clock of a bench whose chip looks at rising edges only.
//
// The kernel's sc_clock writes a signal twice a period and lets the whole kernel settle after each;
// nothing in a chip waits for the falling edge, and waveforms draw it by themselves. Here one event
// a period is all.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <systemc>

namespace racebeam {

class rising_clock : public sc_core::sc_module, public sc_core::sc_signal_in_if<bool> {
 public:
  /// The first edge comes at `period`, too.
  rising_clock(const sc_core::sc_module_name& name, const sc_core::sc_time& period)
      : sc_module(name), period_(period) {
    SC_HAS_PROCESS(rising_clock);
    SC_METHOD(next);
    sensitive << rises_;
  }

  const sc_core::sc_event& posedge_event() const override { return rises_; }
  const sc_core::sc_event& value_changed_event() const override { return rises_; }
  const sc_core::sc_event& default_event() const override { return rises_; }
  /// Never notified.
  const sc_core::sc_event& negedge_event() const override { return never_; }
  /// What it has at an edge.
  const bool& read() const override { return value_; }
  const bool& get_data_ref() const override { return value_; }
  bool event() const override { return rises_.triggered(); }
  bool posedge() const override { return rises_.triggered(); }
  bool negedge() const override { return false; }

 private:
  void next() { rises_.notify(period_); }

  const sc_core::sc_time period_;
  sc_core::sc_event rises_{"rises"}, never_{"never"};
  const bool value_ = true;
};

}  // namespace racebeam
