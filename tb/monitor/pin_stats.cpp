// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/pin_stats.h"

#include <utility>

namespace racebeam {

namespace {

unsigned outputs(const PinChange& pins) { return pins.uo | pins.uio << 8; }
unsigned enables(const PinChange& pins) { return 0xff | pins.oe << 8; }

}  // namespace

PinStats& PinStats::operator+=(const PinStats& more) {
  clocks += more.clocks;
  for (int pin = 0; pin < Pins; ++pin) {
    toggles[pin] += more.toggles[pin];
    high[pin] += more.high[pin];
    enabled[pin] += more.enabled[pin];
  }
  colours |= more.colours;
  return *this;
}

void PinCounter::count_until(std::uint64_t clock) {
  const std::uint64_t clocks = clock - last_.clock;
  stats_.clocks += clocks;
  for (int pin = 0; pin < PinStats::Pins; ++pin) {
    stats_.high[pin] += clocks * (outputs(last_) >> pin & 1);
    stats_.enabled[pin] += clocks * (enables(last_) >> pin & 1);
  }
  last_.clock = clock;
}

void PinCounter::change(const PinChange& now) {
  if (!std::exchange(started_, true)) last_ = now;
  count_until(now.clock);
  const unsigned changed = outputs(last_) ^ outputs(now);
  for (int pin = 0; pin < PinStats::Pins; ++pin) stats_.toggles[pin] += changed >> pin & 1;
  last_ = now;
}

PinStats PinCounter::take(std::uint64_t clock) {
  count_until(clock);
  return std::exchange(stats_, {});
}

}  // namespace racebeam
