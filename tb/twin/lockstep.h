// lockstep: the RTL of a unit beside its model, on the same inputs, every output compared in every
// clock. The model drives.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sc/swap/rtl_instance.h"
#include "tb/twin/wiring_check.h"

namespace racebeam {

/// The first output that differed, what led there, and how it went on.
struct LockstepDifference {
  static constexpr int Before = 255;  ///< clocks of history before it, at most
  static constexpr int After = 64;    ///< and after it, if the run goes on

  enum Side { Input, Model, Rtl };
  struct Column {
    std::string port;
    Side side;
    int bits;
  };

  std::string unit, port;
  int output = 0;                       ///< number of the port among the outputs
  std::uint64_t expected = 0, got = 0;  ///< raw bits of the model and of the RTL
  std::uint64_t clock = 0;              ///< compared clocks before it
  std::vector<Column> columns;
  std::vector<std::vector<std::uint64_t>> history;  ///< by clock, and column
  std::size_t before = 0;                           ///< rows of it before that of the difference
  std::string wiring;                               ///< of racebeam_top only: what its units say

  std::uint64_t first_clock() const { return clock - before; }  ///< of the history
  /// What follows the difference is known as far as it ever will be.
  bool whole() const { return history.size() == before + 1 + After; }
};

class Lockstep : public sc_core::sc_module, public probed {
 public:
  in_port<1> clk_i{"clk_i"};

  /// Beside `model`, a module whose ports are the unit's pins; the plug-in is built with what is
  /// `wanted`. Throws RtlError.
  Lockstep(const sc_core::sc_module_name& name, const std::string& unit,
           const sc_core::sc_module& model, const std::vector<rtl_parameter>& wanted,
           const std::string& plugin);

  const std::string& unit() const { return unit_; }
  /// Name of an output.
  std::string output(int number) const {
    return rtl_.outputs().at(static_cast<std::size_t>(number)).rtl.name();
  }
  std::size_t outputs() const { return rtl_.outputs().size(); }
  /// Clocks so far. All outputs were compared in each but the first, before any edge: registers
  /// have no defined value until they are reset.
  std::uint64_t clocks() const { return clocks_; }
  /// Compares left out: those of the first clock.
  std::uint64_t masked() const { return clocks_ > 0 ? rtl_.outputs().size() : 0; }
  /// Clocks in which some output differed.
  std::uint64_t differences() const { return differences_; }
  const std::optional<LockstepDifference>& first() const { return first_; }
  /// From now on RTL that faults is left alone, instead of an RtlFault: the model goes on.
  void outlive_faults() { outlives_ = true; }
  /// What the RTL ended with, if it has.
  const std::optional<std::string>& fault() const { return fault_; }
  /// The next difference is the first one.
  void forget() { first_.reset(); }

  /// The RTL's side: first the outputs, then, where they can be read, signals inside. To be read
  /// after settle(), when the wires have settled.
  std::vector<probe> probes() const override;
  void settle();

  /// Lets `put` write to the RTL, as the back doors of the model do to that.
  template <class Put>
  void deposit(const Put& put) {
    guarded([&] { put(rtl_); });
  }
  /// Compares the wiring inside as well; for racebeam_top beside a chip. Throws RtlError.
  void check_wiring(const sc_core::sc_module& chip) { wiring_.emplace(rtl_, chip); }
  /// Test of the comparison itself: bit `bit` of an output of the RTL is taken inverted in the
  /// compared clock `clock`; the first difference so far is forgotten. Throws RtlError if there is
  /// no such output.
  void invert(const std::string& port, int bit, std::uint64_t clock);

 private:
  void clock();
  void compare();
  template <class Work>
  void guarded(const Work& work) {
    if (fault_) return;
    try {
      work();
    } catch (const RtlFault& fault) {
      if (!outlives_) throw;
      fault_ = fault.what();
    }
  }
  void remember();
  LockstepDifference difference(std::size_t output, std::uint64_t expected,
                                std::uint64_t got) const;

  struct Inversion {
    std::size_t output;
    int bit;
    std::uint64_t clock;
  };

  const std::string unit_;
  rtl_instance rtl_;
  std::optional<WiringCheck> wiring_;
  std::array<std::vector<std::uint64_t>, LockstepDifference::Before + 1> history_;
  std::uint64_t clocks_ = 0, differences_ = 0;
  std::optional<LockstepDifference> first_;
  std::optional<Inversion> inversion_;
  bool outlives_ = false;
  std::optional<std::string> fault_;
};

}  // namespace racebeam
