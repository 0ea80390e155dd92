// Model and RTL of one unit alone, on traffic that the chip never makes, in lockstep.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_report.h"
#include "tb/twin/twin_bench.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

/// A difference in as few clocks as it takes, with what it takes to see it again.
struct ShrunkDifference {
  std::uint64_t clocks = 0;             ///< after the reset
  std::size_t moving = 0;               ///< inputs that move
  std::uint64_t expected = 0, got = 0;  ///< raw bits of the model and of the RTL in the last clock
  std::uint64_t plays = 0;              ///< streams that were tried
  std::string stream, repeat;           ///< the file, and the command that plays it
};

/// Where a comparison found the first difference.
struct FirstDifference {
  std::string port;
  std::uint64_t clock = 0;              ///< compared clocks before it
  std::uint64_t expected = 0, got = 0;  ///< raw bits of the model and of the RTL
  std::optional<BeamPlace> place;       ///< of the chip's traffic only
  std::string text;                     ///< explained
  std::optional<ShrunkDifference> shrunk{};
};

/// What a comparison of one unit found.
struct UnitVerdict {
  std::string unit, traffic;  ///< traffic: "chip", "random", "walk" or "stream"
  std::uint64_t clocks = 0;   ///< compared
  std::uint64_t masked = 0;   ///< compares of an output left out
  std::uint64_t differences = 0;
  double seconds = 0;
  std::optional<FirstDifference> first;
  std::string fault;  ///< what ended the RTL before the comparison was over; or empty
};

/// Compares model and RTL over `clocks` clocks of `stimulus`, up to a difference, a fault or
/// an interrupt; a difference is explained and saved in `folder`; `repeat` is the command for it.
/// `compared` is told now and then how many clocks are done. Only one such comparison and nothing
/// else of SystemC may happen in a process. Throws RtlError, OutputError.
UnitVerdict verify_unit(const UnitUnderTest& dut, Stimulus stimulus, std::uint64_t clocks,
                        unsigned seed, const std::string& folder, const std::string& repeat,
                        const std::function<void(std::uint64_t)>& compared);

}  // namespace racebeam
