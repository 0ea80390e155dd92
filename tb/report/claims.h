// Measures claims: what the article says, from the chip's functions, its frames and its silicon.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tb/report/claim_scene.h"
#include "tb/report/claim_verdict.h"

namespace racebeam {

/// Those of `chosen`, which are among `all`. Nothing: it was interrupted, and the same goes on.
/// Throws what a run of a sweep throws.
std::optional<std::vector<ClaimFinding>> measure_claims(const std::vector<Claim>& chosen,
                                                        const std::vector<Claim>& all,
                                                        const ClaimSetting& setting,
                                                        const ClaimWorkers& workers);

}  // namespace racebeam
