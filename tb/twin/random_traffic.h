// Stimulus that the chip never makes: random values on all inputs of a unit, in short episodes.
//
// Most inputs behave anew in each episode: held, random, small, at the boundaries of their width,
// one of a few values that all inputs share, beside the last one, as an output of the unit was, or
// counting, all that in each clock or seldom; an input of one bit is on from never to always. Some
// episodes are quiet, so that what takes many clocks is not disturbed, and some have resets. Half
// of the episodes are the shortest and each next length has half as many, so that all lengths have
// the same share of the clocks, up to what only a line or a flight without reset reaches. About
// half of the clocks are in longer episodes of plain noise, which moves all bits soonest: inputs
// are held, random, at a boundary or counting, and one bit is on in half of the clocks.
//
// What no noise reaches soon can be given as known episodes: they come first, and later some
// episodes go on from where one of them has led.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "tb/twin/legal_inputs.h"
#include "tb/twin/port_stream.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class RandomTraffic {
 public:
  /// For the inputs of the unit on `bench`, with values that are `legal`; the same seed makes the
  /// same traffic.
  RandomTraffic(UnitBench& bench, LegalInputs legal, unsigned seed);

  /// To be called before the first clock; the inputs of each are those of the unit, in order.
  void begin_with(std::vector<PortStream> known) { known_ = std::move(known); }
  /// Calls `begin` with a random number when an episode begins, before its first values.
  void at_episodes(std::function<void(unsigned)> begin) { at_episodes_ = std::move(begin); }
  /// New values for the next clock.
  void next();

 private:
  using Raw = std::uint64_t;
  /// Where a new value comes from.
  enum Source { Any, Small, Boundary, Shared, Neighbour, Echo, Sources, Mixed = Sources, Counting };
  struct Input {
    UnitBench::Pin* pin;
    std::vector<const UnitBench::Pin*> outputs;  ///< that are as wide
    int reset = -1;                              ///< value that resets, -1: not a reset
    Source source = Any;
    int pace = 1;   ///< clocks between new values, on average; 0: held
    int on = 32;    ///< how often one bit is 1, of 64
    Raw step = 1;   ///< of what counts
    Raw value = 0;  ///< before it is made legal
  };

  void begin_episode();
  bool begin_known();
  void play_known();
  void begin(Input& input, bool quiet);
  void begin_noise(Input& input);
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  bool one_of(int count) { return below(count) == 0; }
  Raw fresh(const Input& input);
  Raw from(Source source, const Input& input);
  Raw boundary(int bits);
  Raw any_value();

  const LegalInputs legal_;
  std::mt19937 random_;
  std::vector<Input> inputs_;
  std::function<void(unsigned)> at_episodes_;
  std::vector<PortStream> known_;
  std::size_t introduced_ = 0;           // of them, that have been played
  const PortStream* played_ = nullptr;   // one of them
  std::uint64_t clock_ = 0, until_ = 0;  // of it
  Raw shared_[4]{};
  int kinds_ = 1;        // of them, that are in use
  int left_ = 0;         // clocks of the episode
  int reset_every_ = 0;  // clocks between resets, on average; 0: none
};

}  // namespace racebeam
