// A unit alone, model and RTL in lockstep, on what `racebeam verify` drives it with: random traffic
// and, where its engine's row has one, its walk.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "tb/twin/lockstep.h"
#include "tb/twin/random_traffic.h"
#include "tb/twin/twins.h"
#include "tb/twin/unit_bench.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

/// Only one of them and nothing else of SystemC may exist in a process.
class UnitDrive {
 public:
  enum Stimulus { Random, Walk };

  /// Where the RTL is the plug-in `plugin`. Throws RtlError; std::logic_error if a unit without a
  /// walk is to walk.
  UnitDrive(const UnitUnderTest& dut, const std::string& plugin, Stimulus stimulus, unsigned seed);

  /// Goes on; `each` is called in every clock, when the wires have settled, before its edge.
  /// Ends early when the RTL faults. Throws Interrupted.
  void run(std::uint64_t clocks, const std::function<void()>& each = {});

  sc_core::sc_module& model() { return *model_; }
  UnitBench& bench() { return bench_; }
  Lockstep& lockstep() { return lockstep_; }

 private:
  const std::unique_ptr<sc_core::sc_module> model_;
  Lockstep lockstep_;
  UnitBench bench_;
  std::function<void()> next_;
};

}  // namespace racebeam
