// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/random_traffic.h"

#include <utility>

#include "tb/base/reset_value.h"

namespace racebeam {

namespace {

constexpr int ShortEpisode = 400, LongEpisode = 8000;  // at most
constexpr int ResetPace[] = {8, 64, 1000, 0};

}  // namespace

RandomTraffic::RandomTraffic(UnitBench& bench, LegalInputs legal, unsigned seed)
    : legal_(std::move(legal)), random_(seed) {
  for (UnitBench::Pin* pin : bench.pins()) {
    if (!pin->input) continue;
    inputs_.push_back({pin, reset_value(pin->name)});
    // Before a reset the registers have no value.
    if (inputs_.back().reset >= 0) pin->drive(static_cast<std::uint64_t>(inputs_.back().reset));
  }
}

void RandomTraffic::begin_episode() {
  const bool is_long = below(8) == 0;
  left_ = 1 + below(is_long ? LongEpisode : ShortEpisode);
  reset_every_ = is_long ? 0 : ResetPace[below(4)];
  for (Input& input : inputs_) input.manner = static_cast<Manner>(below(Manners));
  if (at_episodes_) at_episodes_(random_());
}

// Around 0, the largest value, the sign, and powers of two.
std::uint64_t RandomTraffic::boundary(int bits) {
  const std::uint64_t one = 1, power = one << below(bits);
  const auto some = [this](int limit) { return static_cast<std::uint64_t>(below(limit)); };
  switch (below(4)) {
    case 0: return some(3) - 1;
    case 1: return (one << (bits - 1)) - some(3) + 1;
    case 2: return power - some(2);
    default: return some(2) - power;
  }
}

std::uint64_t RandomTraffic::any_value(int bits) {
  const std::uint64_t low = random_();
  return bits > 32 ? static_cast<std::uint64_t>(random_()) << 32 | low : low;
}

void RandomTraffic::next() {
  const bool begins = left_ == 0;
  if (begins) begin_episode();
  --left_;
  for (Input& input : inputs_) {
    UnitBench::Pin& pin = *input.pin;
    if (input.reset >= 0) {
      const bool now = begins ? below(2) == 0 : reset_every_ > 0 && below(reset_every_) == 0;
      pin.drive(static_cast<std::uint64_t>(now ? input.reset : 1 - input.reset));
      continue;
    }
    if (!begins && (input.manner == Held || (input.manner == Seldom && below(16) != 0))) continue;
    if (input.manner == Boundary) input.value = boundary(pin.bits);
    else if (input.manner == Counting && !begins) input.value += below(8) == 0 ? 2 : 1;
    else input.value = any_value(pin.bits);
    pin.drive(legal_.of(pin.name, raw_bits(input.value, pin.bits)));
  }
}

}  // namespace racebeam
