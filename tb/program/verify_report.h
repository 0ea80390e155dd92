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

nlohmann::ordered_json to_json(const UnitVerdict& verdict);
UnitVerdict verdict_of(const nlohmann::ordered_json& json);

}  // namespace racebeam
