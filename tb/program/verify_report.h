// What `racebeam verify` found, as a table and as JSON.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tb/program/verify_unit.h"

namespace racebeam {

/// Unit, traffic, clocks compared, compares masked, differences, speed, and what ended the RTL;
/// with a head.
std::string verdict_table(const std::vector<UnitVerdict>& verdicts);

/// Prints the table, or JSON, then what was found on stderr. The exit code: ExitInterrupted,
/// ExitUsage if RTL has ended before its comparison, ExitDifference if one differs.
int tell_verdicts(const std::vector<UnitVerdict>& verdicts, long long seed, bool json);

nlohmann::ordered_json to_json(const UnitVerdict& verdict);
UnitVerdict verdict_of(const nlohmann::ordered_json& json);

}  // namespace racebeam
