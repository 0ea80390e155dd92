// Waivers: mutants that nobody could decide, each looked at by somebody, with a reason.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct Waiver {
  std::string unit, mutant;  ///< mutant: Mutant::name
  std::string reason, reviewer;
  std::string date;   ///< "2026-11-23"
  std::string place;  ///< "waivers.toml:12"
  std::string fault;  ///< "has no reason"; empty: somebody has reviewed it
};

/// Of a TOML file with tables [[waiver]]. Throws UsageError with file, line and what must be there:
/// other keys, missing ones or empty texts too.
std::vector<Waiver> read_waivers(const std::string& path);

/// The path of the project's own, tb/signoff/waivers.toml.
std::string own_waivers_file();

}  // namespace racebeam
