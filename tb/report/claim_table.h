// Claims: what the article says, row by row, with the figure that tells whether it is so.
//
// The table is claims.toml, read where the program finds its scenes. A claim has one or several
// checks: a figure, the knobs of the chip that it is read of, those that it is compared with, what
// the seed's authors or its inventory expect, and the bounds within which the claim holds. The
// file says where the bounds come from.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tb/scene/faults.h"

namespace racebeam {

/// From..to, both included.
struct ClaimBounds {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  bool has(double value) const { return from <= value && value <= to; }
};

struct ClaimCheck {
  /// What is judged: the figure itself, or how it differs from the chip of `against`.
  enum As { Value, Difference, Change };

  std::string scene = "demo";
  std::string figure;                    ///< as in claim_figures.h
  std::string per;                       ///< another figure that it is divided by, or ""
  std::vector<std::string> of, against;  ///< knobs that are not as in the base: "name=value"
  As as = Value;
  double times = 1;      ///< what the value is multiplied with: 100 makes a share %
  std::string unit;      ///< behind the number
  std::string how;       ///< what is measured, in words
  std::string expected;  ///< in words, from the seed
  ClaimBounds holds;
  std::optional<ClaimBounds> in_kind{};  ///< wider: the direction, not the size
  Place place{};
};

struct Claim {
  std::string id;    ///< "S0-62": the row of the seed's inventory; several are separated by commas
  std::string says;  ///< the claim, in a sentence
  std::string why;   ///< of "holds in kind" and the like: what is different here, or ""
  std::vector<ClaimCheck> checks;
};

struct ClaimsResult {
  std::vector<Claim> claims;  ///< usable only without faults
  Faults faults{};
};

/// Of a text.
ClaimsResult read_claims(std::string_view text);

/// Those of the project. Throws UsageError after all faults are on stderr, MissingTool if the
/// program was installed without them.
std::vector<Claim> load_claims();

/// Of all claims those whose id has one of these numbers: "S0-62", "62". All without any. Throws
/// UsageError, which names the nearest one.
std::vector<Claim> chosen_claims(const std::vector<Claim>& all,
                                 const std::vector<std::string>& ids);

}  // namespace racebeam
