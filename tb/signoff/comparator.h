// Self-test of the comparison: whether every bit of every output of a unit is compared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tb/signoff/check_result.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

struct ComparatorOptions {
  unsigned seed = 1;
  std::uint64_t warm_up = 100;  ///< clocks before the first inversion
};

/// An output of a unit.
struct ComparedPort {
  std::string name;
  int bits;
};

struct ComparatorAnswer {
  std::string port;  ///< empty: it found nothing
  std::uint64_t clock = 0, expected = 0, got = 0;
};

/// What is wrong with a comparison, a line for each bit: the inversion is not found, or at another
/// port, clock or bit. `invert` inverts one, lets a clock or two go by, and says what was found;
/// it throws RtlError if it has no such bit.
std::vector<std::string> comparator_faults(
    const std::vector<ComparedPort>& outputs,
    const std::function<ComparatorAnswer(const std::string& port, int bit, std::uint64_t& clock)>&
        invert);

/// Inverts every bit of every output of the model's ports, one in a clock, in both comparisons of
/// the program: that of `verify`, and that which runs recorded traffic into bare RTL. Good if each
/// is found at its port, bit and clock and nothing else is. Undecided when a tool is missing, or
/// when it was interrupted; Bad if model and RTL differ by themselves.
CheckResult sign_off_comparator(const UnitUnderTest& dut, const ComparatorOptions& options);

}  // namespace racebeam
