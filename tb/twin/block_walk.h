// BlockWalk: block_core through whole blocks of a world of small numbers.
// DealWalk: block_scheduler through whole pictures.
//
// Random traffic is seldom as long as a block with spheres, up to 25,000 clocks, and its numbers of
// 32 bits have no rays that hit. Nor does it see the last block of many pictures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "sc/base/knob_values.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class BlockWalk {
 public:
  static constexpr std::uint64_t Clocks = 1'000'000;

  /// For block_core on `bench`; the same seed makes the same traffic.
  BlockWalk(UnitBench& bench, const knob_values& k, unsigned seed);

  /// New values for the next clock.
  void next();

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  void choose_world();
  std::uint64_t number();
  void drive(const char* port, std::uint64_t value);

  UnitBench& bench_;
  const LegalInputs legal_;
  std::mt19937 random_;
  bool begun_ = false;
  int scale_ = 0;       // bits that most numbers of a world do without
  bool alike_ = false;  // all do
};

class DealWalk {
 public:
  static constexpr std::uint64_t Clocks = 20'000;  ///< of the smaller pictures ten

  /// For block_scheduler on `bench`; the same seed makes the same traffic.
  DealWalk(UnitBench& bench, const knob_values& k, unsigned seed);

  /// New values for the next clock.
  void next();

 private:
  UnitBench& bench_;
  const LegalInputs legal_;
  std::mt19937_64 random_;
  bool begun_ = false;
};

}  // namespace racebeam
