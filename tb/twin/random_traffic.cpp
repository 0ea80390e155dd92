// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/random_traffic.h"

#include <utility>

#include "tb/base/reset_value.h"

namespace racebeam {

namespace {

constexpr int Shortest = 8, Doublings = 10;        // clocks; the longest has nearly 16,384
constexpr int LongEpisode = 512;                   // from here on without resets
constexpr int ShortNoise = 400, LongNoise = 8000;  // at most
constexpr int ResetPace[] = {8, 64, 0, 0, 0, 0}, NoiseResetPace[] = {8, 64, 1000, 0};
constexpr int KnownPace = 8;  // episodes between known ones, on average
constexpr int Pace[] = {0, 1, 1, 1, 4, 16};
constexpr int On[] = {0, 1, 8, 32, 32, 56, 63, 64};  // of 64
constexpr int OnOf = 64;

}  // namespace

RandomTraffic::RandomTraffic(UnitBench& bench, LegalInputs legal, unsigned seed)
    : legal_(std::move(legal)), random_(seed) {
  for (UnitBench::Pin* pin : bench.pins()) {
    if (!pin->input) continue;
    inputs_.push_back({pin, {}, reset_value(pin->name)});
    Input& input = inputs_.back();
    for (const UnitBench::Pin* other : bench.pins())
      if (!other->input && other->bits == pin->bits) input.outputs.push_back(other);
    // Before a reset the registers have no value.
    if (input.reset >= 0) pin->drive(static_cast<Raw>(input.reset));
  }
}

void RandomTraffic::begin_episode() {
  const bool noise = one_of(8);
  int length = Shortest;
  if (noise) {
    length = one_of(8) ? LongNoise : ShortNoise;
    left_ = 1 + below(length);
    reset_every_ = length == LongNoise ? 0 : NoiseResetPace[below(std::size(NoiseResetPace))];
  } else {
    for (int n = 0; n < Doublings && one_of(2); ++n) length *= 2;
    left_ = length + below(length);
    reset_every_ = length < LongEpisode ? ResetPace[below(std::size(ResetPace))] : 0;
  }
  kinds_ = 1 + below(std::size(shared_));
  for (Raw& value : shared_) value = any_value();
  const bool quiet = one_of(4);  // most inputs are held
  const bool anew = one_of(4);   // all inputs, otherwise some go on as they did
  for (Input& input : inputs_)
    if (noise) begin_noise(input);
    else if (anew || !one_of(3)) begin(input, quiet);
  if (at_episodes_) at_episodes_(random_());
}

void RandomTraffic::begin(Input& input, bool quiet) {
  input.source = static_cast<Source>(below(Counting + 1));
  input.pace = quiet && !one_of(4) ? 0 : Pace[below(std::size(Pace))];
  input.on = On[below(std::size(On))];
  input.step = one_of(4) ? ~Raw{0} : 1;
}

void RandomTraffic::begin_noise(Input& input) {
  struct Manner {
    Source source;
    int pace;
  };
  static constexpr Manner Manners[] = {{Any, 0}, {Any, 1}, {Any, 16}, {Boundary, 1}, {Counting, 1}};
  const Manner& manner = Manners[below(std::size(Manners))];
  input.source = manner.source;
  input.pace = manner.pace;
  input.on = OnOf / 2;
  input.step = 1;
}

// Around 0, the largest value, the sign, and powers of two.
RandomTraffic::Raw RandomTraffic::boundary(int bits) {
  const Raw one = 1, power = one << below(bits);
  const auto some = [this](int limit) { return static_cast<Raw>(below(limit)); };
  switch (below(4)) {
    case 0: return some(3) - 1;
    case 1: return (one << (bits - 1)) - some(3) + 1;
    case 2: return power - some(2);
    default: return some(2) - power;
  }
}

RandomTraffic::Raw RandomTraffic::any_value() {
  const Raw low = random_();
  return static_cast<Raw>(random_()) << 32 | low;
}

RandomTraffic::Raw RandomTraffic::from(Source source, const Input& input) {
  const int bits = input.pin->bits;
  switch (source) {
    case Small: {
      const Raw value = any_value();  // in this order, whatever compiles it
      const Raw size = value & ((Raw{1} << below(bits)) - 1);
      return one_of(2) ? size : ~size;
    }
    case Boundary: return boundary(bits);
    case Shared: return shared_[below(kinds_)];
    case Neighbour: return one_of(2) ? input.value + 1 : input.value - 1;
    case Echo:
      if (!input.outputs.empty())
        return input
            .outputs[static_cast<std::size_t>(below(static_cast<int>(input.outputs.size())))]
            ->value();
      [[fallthrough]];
    default: return any_value();
  }
}

RandomTraffic::Raw RandomTraffic::fresh(const Input& input) {
  if (input.pin->bits == 1)
    return input.source == Echo ? from(Echo, input) : static_cast<Raw>(below(OnOf) < input.on);
  if (input.source == Mixed) return from(static_cast<Source>(below(Sources)), input);
  return from(input.source, input);
}

/// Each of them whole, then one now and then, whole or its beginning.
bool RandomTraffic::begin_known() {
  if (introduced_ < known_.size()) {
    played_ = &known_[introduced_++];
    until_ = played_->clocks();
  } else if (!known_.empty() && one_of(KnownPace)) {
    played_ = &known_[static_cast<std::size_t>(below(static_cast<int>(known_.size())))];
    until_ = played_->clocks();
    if (one_of(2)) until_ = 1 + random_() % until_;
  } else {
    return false;
  }
  clock_ = 0;
  return true;
}

void RandomTraffic::play_known() {
  for (std::size_t n = 0; n < inputs_.size(); ++n) {
    Input& input = inputs_[n];
    UnitBench::Pin& pin = *input.pin;
    input.value = played_->at(clock_, n);
    pin.drive(input.reset >= 0 ? input.value
                               : raw_bits(legal_.legal(pin.name, input.value), pin.bits));
  }
  if (++clock_ == until_) played_ = nullptr;
}

void RandomTraffic::next() {
  const bool begins = left_ == 0;
  if (played_ || (begins && begin_known())) return play_known();
  if (begins) begin_episode();
  --left_;
  for (Input& input : inputs_) {
    UnitBench::Pin& pin = *input.pin;
    if (input.reset >= 0) {
      const bool now = begins ? one_of(6) : reset_every_ > 0 && one_of(reset_every_);
      pin.drive(static_cast<Raw>(now ? input.reset : 1 - input.reset));
      continue;
    }
    if (!begins && (input.pace == 0 || !one_of(input.pace))) continue;
    if (input.source == Counting && pin.bits > 1 && !begins)
      input.value += one_of(8) ? 2 * input.step : input.step;
    else input.value = fresh(input);
    pin.drive(legal_.of(pin.name, raw_bits(input.value, pin.bits)));
  }
}

}  // namespace racebeam
