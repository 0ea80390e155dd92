// TwinBench: model and RTL of a unit side by side, alone, from power-up on.
//
// Only one of them and nothing else of SystemC may exist in a process. Until its first clock it may
// be copied by fork(), as often as need be: each copy begins at power-up.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "tb/twin/lockstep.h"
#include "tb/twin/port_stream.h"
#include "tb/twin/port_traffic.h"
#include "tb/twin/register_history.h"
#include "tb/twin/unit_bench.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

class sequencer_pins;

/// What drives a unit alone: RandomTraffic, or the UnitWalk of its engine's row.
enum class Stimulus { Random, Walk };

class TwinBench {
 public:
  /// RTL that faults is left alone. Throws RtlError.
  explicit TwinBench(const UnitUnderTest& dut);

  UnitBench& bench() { return bench_; }
  Lockstep& lockstep() { return lockstep_; }

  /// A stream for this unit, without clocks.
  PortStream form() const;
  /// From now on each clock has new values; the same seed makes the same ones. A Walk only of a
  /// unit that has one.
  void stimulate(Stimulus stimulus, unsigned seed);
  /// The next `clocks` of that as a stream, of which the last `most` are kept; power-up is its
  /// first clock only if all are.
  PortStream record(std::uint64_t clocks, std::uint64_t most);
  /// All of `stream`, or as far as shortly after the first difference in it, which is the
  /// lockstep's. Its clock 0 follows on what was played before.
  void play(const PortStream& stream);
  /// From the next stream that is played on the registers of both sides are taken in each clock but
  /// the first; to be called at power-up, and read after play().
  RegisterHistory& remember_registers();
  /// What the ports of the model have in each clock of `stream`.
  PortTraffic model_traffic(const PortStream& stream);

 private:
  std::function<std::uint64_t()> frame_register() const;  // nothing: it has none
  void seek(int frame);
  void seek_rtl(int frame);
  void drive_each(std::function<void()> next);
  void drive(const PortStream& stream, std::uint64_t clock);

  const UnitUnderTest dut_;
  std::unique_ptr<sc_core::sc_module> model_;
  Lockstep lockstep_;
  UnitBench bench_;
  sequencer_pins* const counter_;  // of frames; nullptr: it counts none
  std::function<void()> next_;     // new values
  std::optional<RegisterHistory> registers_;
  std::function<void(int frame)> seeks_;  // is told
};

}  // namespace racebeam
