// What was found of claims, for a terminal, for programs, and for docs/claims.md.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/report/claim_verdict.h"

namespace racebeam {

/// "1.32 % +/- 0.05", or why there is nothing.
std::string found_text(const ClaimCheck& check, const CheckFinding& finding);
/// "0 to 3", "at most 3", "2.5".
std::string bounds_text(const ClaimBounds& bounds);

std::string claims_text(const std::vector<ClaimFinding>& findings);
/// `frames`: 0 for all.
std::string claims_json(const std::vector<ClaimFinding>& findings, int frames);
/// A table with a row for each check.
std::string claims_markdown(const std::vector<ClaimFinding>& findings);
/// "38 hold, 5 hold in kind, 1 does not hold, 0 are not decided"
std::string claims_counts(const std::vector<ClaimFinding>& findings);

}  // namespace racebeam
