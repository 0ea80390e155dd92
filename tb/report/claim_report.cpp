// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tb/sweep/interval_text.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

std::string word(ClaimVerdict verdict) {
  return claim_verdict_words()[static_cast<std::size_t>(verdict)];
}

Json bound(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json bounds_json(const ClaimBounds& bounds) { return {bound(bounds.from), bound(bounds.to)}; }

std::string number(double value) { return fmt::format("{:.10g}", value); }

Json check_json(const ClaimCheck& check, const CheckFinding& finding) {
  static const char* const as[] = {"value", "difference", "change"};
  Json json = {{"how", check.how}, {"scene", check.scene}, {"figure", check.figure}};
  if (!check.per.empty()) json["per"] = check.per;
  json["of"] = check.of;
  if (check.as != ClaimCheck::Value) json["against"] = check.against;
  json["as"] = as[check.as];
  json["times"] = check.times;
  json["unit"] = check.unit;
  json["expected"] = check.expected;
  json["holds"] = bounds_json(check.holds);
  if (check.in_kind) json["in_kind"] = bounds_json(*check.in_kind);
  if (finding.found && std::isfinite(finding.found->value)) {
    json["found"] = finding.found->value;
    if (finding.sampled) {
      json["half_width"] = bound(finding.found->half_width);
      json["frames"] = finding.found->frames;
      json["population"] = finding.found->population;
    }
  } else {
    json["found"] = nullptr;
    json["why_not"] = finding.why_not;
  }
  json["verdict"] = word(finding.verdict);
  return json;
}

/// A cell of Markdown.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

}  // namespace

std::string found_text(const ClaimCheck& check, const CheckFinding& finding) {
  if (!finding.found) return "not measured: " + finding.why_not;
  return finding.sampled ? text_of(*finding.found, check.unit)
                         : text_of(finding.found->value, check.unit);
}

std::string bounds_text(const ClaimBounds& bounds) {
  if (!std::isfinite(bounds.from)) return "at most " + number(bounds.to);
  if (!std::isfinite(bounds.to)) return "at least " + number(bounds.from);
  if (bounds.from == bounds.to) return number(bounds.from);
  return number(bounds.from) + " to " + number(bounds.to);
}

std::string claims_counts(const std::vector<ClaimFinding>& findings) {
  int counts[4] = {};
  for (const ClaimFinding& finding : findings) ++counts[static_cast<int>(finding.verdict())];
  return fmt::format("{} hold, {} hold in kind, {} do not hold, {} are not decided",
                     counts[int(ClaimVerdict::Holds)], counts[int(ClaimVerdict::HoldsInKind)],
                     counts[int(ClaimVerdict::DoesNotHold)], counts[int(ClaimVerdict::NotDecided)]);
}

std::string claims_text(const std::vector<ClaimFinding>& findings) {
  std::string text;
  for (const ClaimFinding& finding : findings) {
    text += fmt::format("{:<14} {}  {}\n", word(finding.verdict()), finding.claim.id,
                        finding.claim.says);
    for (std::size_t i = 0; i < finding.checks.size(); ++i) {
      const ClaimCheck& check = finding.claim.checks[i];
      const std::string verdict =
          finding.checks.size() > 1 ? ": " + word(finding.checks[i].verdict) : "";
      text += fmt::format("{:15}{}: {}; expected {}, holds {}{}\n", "", check.how,
                          found_text(check, finding.checks[i]), check.expected,
                          bounds_text(check.holds), verdict);
    }
    if (finding.verdict() != ClaimVerdict::Holds && !finding.claim.why.empty())
      text += fmt::format("{:15}{}\n", "", finding.claim.why);
  }
  return text + claims_counts(findings) + "\n";
}

std::string claims_json(const std::vector<ClaimFinding>& findings, int frames) {
  Json json = {{"schema", "racebeam-claims"}, {"version", 1}};
  json["frames"] = frames == 0 ? Json("all") : Json(frames);
  json["claims"] = Json::array();
  for (const ClaimFinding& finding : findings) {
    Json one = {{"id", finding.claim.id},
                {"says", finding.claim.says},
                {"verdict", word(finding.verdict())},
                {"why", finding.claim.why},
                {"checks", Json::array()}};
    for (std::size_t i = 0; i < finding.checks.size(); ++i)
      one["checks"].push_back(check_json(finding.claim.checks[i], finding.checks[i]));
    json["claims"].push_back(one);
  }
  return json.dump(2) + "\n";
}

std::string claims_markdown(const std::vector<ClaimFinding>& findings) {
  std::string text =
      "| row | claim | measured | expected | holds | found | verdict "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const ClaimFinding& finding : findings)
    for (std::size_t i = 0; i < finding.checks.size(); ++i) {
      const ClaimCheck& check = finding.claim.checks[i];
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", i ? "" : finding.claim.id,
                          i ? "" : cell(finding.claim.says), cell(check.how), cell(check.expected),
                          bounds_text(check.holds), cell(found_text(check, finding.checks[i])),
                          word(finding.checks[i].verdict));
    }
  return text;
}

}  // namespace racebeam
