// The pulses of one pin: how long they last and how far they are apart.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tb/monitor/pin_change.h"

namespace racebeam {

/// In clocks; the pulse is the shorter part of a period.
struct SyncPulse {
  std::uint64_t begin = 0, period = 0, length = 0;
  bool level = false;
};

/// The last whole period of a pin of uo_out. What was before the clock `from` does not count: a
/// register that has no reset may change then.
std::optional<SyncPulse> last_pulse(const std::vector<PinChange>& changes, int pin,
                                    std::uint64_t from);

/// The last of the pulses that have the most common period; if that is of most of them.
std::optional<SyncPulse> usual_pulse(const std::vector<PinChange>& changes, int pin);

}  // namespace racebeam
