// RegisterHistory: the registers that model and RTL of a unit both have, clock by clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/twin/lockstep.h"

namespace racebeam {

class RegisterHistory {
 public:
  /// Those with the same name and as many bits on both sides; none if the signals inside of the RTL
  /// cannot be read. Both sides shall live as long.
  RegisterHistory(sc_core::sc_module& model, const Lockstep& lockstep);

  /// What they have in a clock, before its edge. Clocks follow on each other.
  void take(std::uint64_t clock);

  /// `difference` with the registers that differ as columns behind its own, the first to differ
  /// first. It lies in the clocks taken, but for clock 0.
  LockstepDifference beside(LockstepDifference difference) const;
  /// A line: which of them differs first, and when. Empty: the RTL cannot be read.
  std::string text(const LockstepDifference& difference) const;

 private:
  static constexpr std::size_t MostShown = 8;

  struct Pair {
    probe model, rtl;
  };
  struct Values {
    std::uint64_t model, rtl;
  };
  struct Found {
    std::size_t pair;
    std::uint64_t clock;  ///< the first in which it differs
  };
  Values values(std::uint64_t clock, std::size_t pair) const;
  std::vector<Found> differing(const LockstepDifference& difference) const;

  std::string unit_;
  bool readable_ = false;
  std::vector<Pair> pairs_;
  std::uint64_t first_ = 0;     // clock
  std::vector<Values> values_;  // by clock, and pair
};

}  // namespace racebeam
