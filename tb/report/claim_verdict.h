// What measuring says of a claim: its verdict, from an interval and the bounds that were stated.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/report/claim_table.h"
#include "tb/sweep/interval.h"

namespace racebeam {

/// From the best to the worst: a claim's is the worst of its checks.
enum class ClaimVerdict { Holds, HoldsInKind, NotDecided, DoesNotHold };

/// By ClaimVerdict: "holds", "holds in kind", "not decided", "does not hold".
const std::vector<std::string>& claim_verdict_words();

struct CheckFinding {
  std::optional<Estimate> found{};  ///< nothing: it could not be measured
  bool sampled = false;             ///< of frames: it has an interval; else it is exact
  std::string why_not{};            ///< why it could not
  ClaimVerdict verdict = ClaimVerdict::NotDecided;
};

struct ClaimFinding {
  Claim claim;
  std::vector<CheckFinding> checks{};

  ClaimVerdict verdict() const;
};

/// The strongest that the whole interval supports; that it does not hold, only if no part of the
/// interval is within the widest bounds.
ClaimVerdict verdict_of(const ClaimCheck& check, const Estimate& found);

}  // namespace racebeam
