// libFuzzer target: no text makes the reader of the table of claims crash or hang; bounds of a
// table without faults are the right way round.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <string>

#include "tb/base/project_folder.h"
#include "tb/report/claim_figures.h"
#include "tb/report/claim_table.h"
#include "tb/show/open_show.h"
#include "tests/fuzz/stand_in_engines.h"

// A few names stand for all.
std::vector<std::string> racebeam::scene_names() { return {"demo", "grid", "house"}; }
std::string racebeam::project_folder() { std::abort(); }
std::vector<std::string> racebeam::claim_figure_names() {
  return {"starved", "busy", "slack.p50", "flip_flops.stacks"};
}
std::optional<racebeam::ClaimSource> racebeam::claim_source(const std::string& figure) {
  for (const std::string& known : claim_figure_names())
    if (figure == known) return ClaimSource::Frames;
  return {};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace racebeam;
  const ClaimsResult result = read_claims(text_of(data, size));
  (void)result.faults.text("fuzz");
  (void)result.faults.warnings("fuzz");
  if (!result.faults.none()) return 0;
  for (const Claim& claim : result.claims) {
    check(!claim.id.empty() && !claim.says.empty());
    for (const ClaimCheck& each : claim.checks) {
      check(!each.figure.empty() && each.holds.from <= each.holds.to);
      check(!each.in_kind ||
            (each.in_kind->from <= each.holds.from && each.in_kind->to >= each.holds.to));
    }
    check(!chosen_claims(result.claims, {claim.id}).empty());
  }
  return 0;
}
