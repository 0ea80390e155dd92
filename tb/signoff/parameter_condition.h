// Conditions over the parameters of a unit's RTL: what is so in some chips only.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace racebeam {

/// By name, those that are numbers.
using RtlParameters = std::map<std::string, std::int64_t>;

/// Whether `when` holds, as "PortalsPerFace == 1" with no portals; "" always does. Throws
/// UsageError, which begins with `where`, if it is no condition or names what is no parameter.
bool holds_with(const RtlParameters& parameters, const std::string& when, const std::string& where);

}  // namespace racebeam
