// Numbers on the command line: what is none, or is out of range, is refused with the range.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/program/command_options.h"

namespace racebeam {

/// Throws UsageError unless `option` is followed by a whole number; the message ends with `range`.
/// The range itself is judged where it is known.
CheckWord is_number(const std::string& option, const std::string& range);

/// The same, and the number must be within low..high.
CheckWord is_number_in(const std::string& option, long long low, long long high);

}  // namespace racebeam
