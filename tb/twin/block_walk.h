// BlockWalk: block_core through whole blocks of a world of small numbers.
// DealWalk: block_scheduler through whole pictures.
//
// Random traffic is seldom as long as a block with spheres, up to 25,000 clocks, and its numbers of
// 32 bits have no rays that hit. Nor does it see the last block of many pictures. Whether a block
// is kept is asked some hundred times in a million clocks, and the last bits of numbers decide it
// never: so in between there are blocks that all spheres miss by next to nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

#include "sc/base/fixed_point.h"
#include "sc/base/knob_values.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class BlockWalk {
 public:
  static constexpr std::uint64_t Clocks = 4'000'000;

  /// For block_core on `bench`; the same seed makes the same traffic.
  BlockWalk(UnitBench& bench, const knob_values& k, unsigned seed);

  /// New values for the next clock.
  void next();

 private:
  struct Write {
    int field, index;
    std::uint64_t value, eye_k;
  };

  static constexpr int Unit = 1 << BlockFraction;

  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  int around(int units) { return below(2 * units * Unit) - units * Unit; }  // so far from 0
  void choose_world();
  void choose_block();
  void begin_misses();
  void choose_misses();
  std::uint64_t number();
  int drive(const char* port, std::uint64_t value);  // what is legal of it
  void drive(const Write& write);

  UnitBench& bench_;
  const block_knobs knobs_;
  const LegalInputs legal_;
  std::mt19937 random_;
  bool begun_ = false;
  bool waits_ = false;  // the world's job is not yet taken
  int scale_ = 0;       // bits that most numbers of a world do without
  bool alike_ = false;  // all do
  bool drawn_ = false;  // the block before was any
  int misses_ = 0;      // blocks to come that all spheres miss
  int job_x_ = 0, job_y_ = 0, ax_ = 0, ay_ = 0;
  vec3 start_{};
  std::vector<vec3> poses_;   // of the spheres that miss
  std::deque<Write> writes_;  // before the job
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
