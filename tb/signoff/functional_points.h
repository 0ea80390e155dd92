// Functional coverage of the stimulus: which crosses of state, answer, stall and the like a unit's
// model has seen.
//
// A cross is a row of a table: its axes with their bins, each a condition over the ports and the
// registers of the model, and what cannot be, with the reason.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "tb/base/expression.h"
#include "tb/signoff/parameter_condition.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

struct FunctionalBin {
  std::string name;
  std::string when;  ///< as tb/base/expression.h has it; "" always
};

/// Of its bins the first one that holds counts; clocks in which none does are in no cross.
struct FunctionalAxis {
  std::string name;
  std::vector<FunctionalBin> bins;
};

struct ImpossibleCross {
  std::vector<std::string> bins;  ///< for each axis "left|right", or "*"
  std::string reason;
  /// False: it need not be seen, but it may, with traffic that no chip makes.
  bool never = true;
  std::string when = {};  ///< over the RTL's parameters; "" always, else it holds only then
};

struct FunctionalCross {
  std::string unit, name;
  std::string during;  ///< clocks that count; "" all
  std::vector<FunctionalAxis> axes;
  std::vector<ImpossibleCross> impossible;

  std::size_t points() const;
  /// "state=left answer=wall stall=none": by number, the last axis counting fastest.
  std::string point_name(std::size_t number) const;
  /// Why a point cannot be in RTL with these parameters; nullptr: it can. Throws UsageError of a
  /// condition that names no parameter.
  const ImpossibleCross* impossible_at(std::size_t number, const RtlParameters& parameters) const;

 private:
  std::vector<std::size_t> bins_of(std::size_t number) const;
};

/// The crosses of a unit, of whatever engine; none of many.
std::vector<FunctionalCross> functional_crosses(const std::string& unit);
const std::vector<FunctionalCross>& all_functional_crosses();

/// An axis whose bins are the values 0.. of a signal.
FunctionalAxis axis_of_values(const std::string& name, const std::string& signal,
                              const std::vector<std::string>& values);
/// An axis with the bins "no" and "yes".
FunctionalAxis axis_of_flag(const std::string& name, const std::string& when);

/// Counts the points of one cross.
class CrossCounter {
 public:
  /// Over the pins on `bench` and the registers of `model`, both of which outlive it; the model
  /// sleeps no more. Throws UsageError if a condition does not fit them.
  CrossCounter(const FunctionalCross& cross, UnitBench& bench, sc_core::sc_module& model);
  ~CrossCounter();

  /// To be called in each clock, when the wires have settled.
  void look();
  /// Clocks in which each point was there.
  const std::vector<std::uint64_t>& counts() const { return counts_; }

 private:
  struct Signal;

  std::unique_ptr<Expression> made(const std::string& text, UnitBench& bench);

  const FunctionalCross& cross_;
  std::vector<probe> registers_;
  std::vector<std::unique_ptr<Signal>> signals_;
  std::unique_ptr<Expression> during_;
  std::vector<std::vector<std::unique_ptr<Expression>>> axes_;  // null: it always holds
  std::vector<std::uint64_t> counts_;
};

/// What a cross makes of its counts: missing points by name, and faults where a point is hit that
/// was said to be impossible.
struct CrossVerdict {
  std::size_t hit = 0, possible = 0;
  std::vector<std::string> missing, faults;
};
CrossVerdict judge_cross(const FunctionalCross& cross, const std::vector<std::uint64_t>& counts,
                         const RtlParameters& parameters);

}  // namespace racebeam
