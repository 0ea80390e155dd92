// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/random_traffic.h"

namespace racebeam {

namespace {

constexpr int LongestEpisode = 400;
constexpr int ResetPace[] = {8, 64, 1000};

int reset_value(const std::string& name) {
  if (name == "rst_ni") return 0;
  return name.find("reset") != std::string::npos ? 1 : -1;
}

}  // namespace

RandomTraffic::RandomTraffic(UnitBench& bench, const knobs& k, unsigned seed)
    : legal_(k), random_(seed) {
  for (UnitBench::Pin* pin : bench.pins())
    if (pin->input) inputs_.push_back({pin, Random, reset_value(pin->name)});
}

void RandomTraffic::begin_episode() {
  left_ = 1 + below(LongestEpisode);
  reset_every_ = ResetPace[below(3)];
  for (Input& input : inputs_) input.manner = static_cast<Manner>(below(4));
}

// Around 0, the largest value, the sign, and powers of two.
int RandomTraffic::boundary(int bits) {
  const int power = 1 << below(bits);
  switch (below(4)) {
    case 0: return below(3) - 1;
    case 1: return (1 << (bits - 1)) - below(3) + 1;
    case 2: return power - below(2);
    default: return -power + below(2);
  }
}

void RandomTraffic::next() {
  const bool begins = left_ == 0;
  if (begins) begin_episode();
  --left_;
  for (Input& input : inputs_) {
    UnitBench::Pin& pin = *input.pin;
    if (input.reset >= 0) {
      pin.drive(below(reset_every_) == 0 || begins ? input.reset : 1 - input.reset);
      continue;
    }
    if (!begins && (input.manner == Held || (input.manner == Seldom && below(16) != 0))) continue;
    const int value = input.manner == Boundary ? boundary(pin.bits) : static_cast<int>(random_());
    pin.drive(legal_.of(pin.name, value & low_bits(pin.bits)));
  }
}

}  // namespace racebeam
