// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_verdict.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

namespace {

bool within(const ClaimBounds& bounds, const Estimate& found) {
  return bounds.has(found.low()) && bounds.has(found.high());
}

}  // namespace

const std::vector<std::string>& claim_verdict_words() {
  static const std::vector<std::string> words = {"holds", "holds in kind", "not decided",
                                                 "does not hold"};
  return words;
}

ClaimVerdict verdict_of(const ClaimCheck& check, const Estimate& found) {
  if (std::isnan(found.value)) return ClaimVerdict::NotDecided;
  if (within(check.holds, found)) return ClaimVerdict::Holds;
  if (check.in_kind && within(*check.in_kind, found)) return ClaimVerdict::HoldsInKind;
  const ClaimBounds widest = check.in_kind.value_or(check.holds);
  const bool outside = found.high() < widest.from || found.low() > widest.to;
  return outside ? ClaimVerdict::DoesNotHold : ClaimVerdict::NotDecided;
}

ClaimVerdict ClaimFinding::verdict() const {
  ClaimVerdict worst = ClaimVerdict::Holds;
  for (const CheckFinding& check : checks) worst = std::max(worst, check.verdict);
  return worst;
}

}  // namespace racebeam
