// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/pin_probe.h"

#include <stdexcept>

namespace racebeam {

PinProbe::PinProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& start,
                   const sc_core::sc_time& period, VgaMonitor* vga, SoundMonitor* sound)
    : sc_module(name), start_(start), period_(period), vga_(vga), sound_(sound) {
  if (period == sc_core::SC_ZERO_TIME) throw std::invalid_argument("PinProbe: period is 0");
  SC_HAS_PROCESS(PinProbe);
  if (vga_) {
    SC_METHOD(vga_changed);
    sensitive << uo_i;
  }
  if (sound_) {
    SC_METHOD(sound_changed);
    sensitive << pwm_i;
  }
}

std::uint64_t PinProbe::clock() const {
  const sc_core::sc_time& now = sc_core::sc_time_stamp();
  return now < start_ ? 0 : (now - start_).value() / period_.value();
}

template <class Action>
void PinProbe::guarded(Action action) {
  if (failure_) return;
  try {
    action();
  } catch (...) {
    failure_ = std::current_exception();
    sc_core::sc_pause();
  }
}

void PinProbe::vga_changed() {
  guarded([this] { vga_->change(clock(), static_cast<std::uint8_t>(uo_i.value())); });
}

void PinProbe::sound_changed() {
  guarded([this] { sound_->change(clock(), pwm_i.value() != 0); });
}

void PinProbe::advance() {
  if (failure_) std::rethrow_exception(failure_);
  if (vga_) vga_->advance(clock());
  if (sound_) sound_->advance(clock());
}

}  // namespace racebeam
