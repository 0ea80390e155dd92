// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/pin_probe.h"

#include <stdexcept>

namespace racebeam {

CableProbe::CableProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& start,
                       const sc_core::sc_time& period, VgaMonitor* vga, SoundMonitor* sound)
    : sc_module(name), vga_(vga), sound_(sound), start_(start), period_(period) {
  if (period == sc_core::SC_ZERO_TIME) throw std::invalid_argument("PinProbe: period is 0");
}

std::uint64_t CableProbe::clock() const {
  const sc_core::sc_time& now = sc_core::sc_time_stamp();
  return now < start_ ? 0 : (now - start_).value() / period_.value();
}

void CableProbe::advance() {
  if (failure_) std::rethrow_exception(failure_);
  if (vga_) vga_->advance(clock());
  if (sound_) sound_->advance(clock());
}

PinProbe::PinProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& start,
                   const sc_core::sc_time& period, VgaMonitor* vga, SoundMonitor* sound)
    : CableProbe(name, start, period, vga, sound) {
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

void PinProbe::vga_changed() {
  guarded([this] { vga_->change(clock(), static_cast<std::uint8_t>(uo_i.value())); });
}

void PinProbe::sound_changed() {
  guarded([this] { sound_->change(clock(), pwm_i.value() != 0); });
}

DacProbe::DacProbe(const sc_core::sc_module_name& name, const sc_core::sc_time& start,
                   const sc_core::sc_time& period, VgaMonitor* vga)
    : CableProbe(name, start, period, vga, nullptr) {
  SC_HAS_PROCESS(DacProbe);
  if (!vga_) return;
  SC_METHOD(changed);
  sensitive << hsync_ni << vsync_ni << red_i << green_i << blue_i;
}

void DacProbe::changed() {
  constexpr VgaPinout pins = converter_pinout(Bits);
  const auto bit = [](bool level, int pin) { return static_cast<std::uint32_t>(level) << pin; };
  guarded([&] {
    vga_->change(clock(), bit(hsync_ni.value(), pins.hsync) | bit(vsync_ni.value(), pins.vsync) |
                              static_cast<std::uint32_t>(red_i.value() << 2 * Bits |
                                                         green_i.value() << Bits | blue_i.value()));
  });
}

}  // namespace racebeam
