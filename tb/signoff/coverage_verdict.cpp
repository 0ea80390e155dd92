// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "tb/base/errors.h"
#include "tb/signoff/coverage.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

/// The points that the waivers stand for, and what is wrong with these.
std::vector<bool> waived_points(const std::string& unit, const UnitCoverage& coverage,
                                const std::vector<CoverageWaiver>& waivers,
                                std::vector<std::string>& faults) {
  std::vector<bool> waived(coverage.points.size());
  for (const CoverageWaiver& waiver : waivers) {
    if (std::find(waiver.units.begin(), waiver.units.end(), unit) == waiver.units.end()) continue;
    const std::string where = fmt::format(
        "waiver of {}line {}", waiver.file.empty() ? "" : waiver.file + ", ", waiver.place.line);
    const auto fault = [&](const std::string& what, const std::string& help) {
      faults.push_back(fmt::format("{}: {}; {}", where, what, help));
    };
    if (waiver.reason.empty()) fault("it has no reason", "say why its points cannot be hit");
    try {
      if (!holds_with(coverage.parameters, waiver.when, where)) continue;
    } catch (const UsageError& error) {
      fault(error.what(), "correct its condition");
      continue;
    }
    for (const std::string& wanted : waiver.points) {
      bool found = false;
      int number = 0;
      for (std::size_t n = 0; n < coverage.points.size(); ++n) {
        const CoveragePoint& point = coverage.points[n];
        if (point.kind != waiver.kind || point.module != waiver.module ||
            !names_point(wanted, point, number))
          continue;
        found = true;
        waived[n] = true;
        const std::string name = point.module + " " + point.title() + " (" + point.place() + ")";
        if (point.hit()) fault(name + " is hit", "take it out");
        else if (coverage.constant[n]) fault(name + " is constant, as yosys shows", "take it out");
      }
      if (!found)
        fault(fmt::format("{} has no {} '{}'", waiver.module, CoveragePoint::Kinds[waiver.kind],
                          wanted),
              "correct it, or take it out");
    }
  }
  return waived;
}

struct Tally {
  std::size_t hit = 0, all = 0, constant = 0, waived = 0;

  bool full() const { return hit + constant + waived == all; }
};

Json point_json(const CoveragePoint& point) {
  return {{"kind", CoveragePoint::Kinds[point.kind]},
          {"module", point.module},
          {"place", point.place()},
          {"point", point.title()},
          {"text", point.text}};
}

}  // namespace

CheckResult judge_coverage(const std::string& unit, const UnitCoverage& coverage,
                           const std::vector<FunctionalCross>& crosses,
                           const std::vector<CoverageWaiver>& waivers) {
  CheckResult result;
  result.unit = unit;
  result.check = "coverage";
  const std::vector<bool> waived = waived_points(unit, coverage, waivers, result.faults);
  Tally tallies[3];
  Json missing = Json::array();
  for (std::size_t n = 0; n < coverage.points.size(); ++n) {
    const CoveragePoint& point = coverage.points[n];
    Tally& tally = tallies[point.kind];
    ++tally.all;
    if (point.hit()) ++tally.hit;
    else if (coverage.constant[n]) ++tally.constant;
    else if (waived[n]) ++tally.waived;
    else {
      missing.push_back(point_json(point));
      result.faults.push_back(fmt::format("{}: {} of {} is not hit: {}", point.place(),
                                          CoveragePoint::Kinds[point.kind], point.module,
                                          point.title()));
    }
    if (point.kind == CoveragePoint::Toggle && coverage.constant[n] && point.hit())
      result.faults.push_back(fmt::format(
          "{}: yosys says that {} is constant, and it has moved: one of the tools is wrong",
          point.place(), point.name));
  }
  if (coverage.points.empty())
    result.faults.push_back("the RTL of " + unit + " has no line and no bit that counts");
  for (int kind = 0; kind < 3; ++kind) {
    const Tally& tally = tallies[kind];
    result.summary += fmt::format("{}{} {}/{}", kind == 0 ? "" : ", ", CoveragePoint::Kinds[kind],
                                  tally.hit, tally.all - tally.constant - tally.waived);
    result.detail[CoveragePoint::Kinds[kind]] = {{"hit", tally.hit},
                                                 {"all", tally.all},
                                                 {"constant", tally.constant},
                                                 {"waived", tally.waived}};
  }
  result.detail["missing"] = missing;
  std::size_t hit = 0, possible = 0;
  Json rows = Json::array();
  for (std::size_t n = 0; n < crosses.size(); ++n) {
    CrossVerdict verdict;
    try {
      verdict = judge_cross(crosses[n], coverage.crosses.at(n), coverage.parameters);
    } catch (const UsageError& error) {  // RTL of other parameters
      result.faults.emplace_back(error.what());
      continue;
    }
    hit += verdict.hit;
    possible += verdict.possible;
    for (const std::string& name : verdict.missing) result.faults.push_back(name + " was not seen");
    result.faults.insert(result.faults.end(), verdict.faults.begin(), verdict.faults.end());
    rows.push_back({{"cross", crosses[n].name},
                    {"hit", verdict.hit},
                    {"possible", verdict.possible},
                    {"all", crosses[n].points()},
                    {"missing", verdict.missing}});
  }
  if (!crosses.empty()) result.summary += fmt::format(", crosses {}/{}", hit, possible);
  result.detail["crosses"] = rows;
  result.detail["clocks"] = coverage.clocks;
  result.verdict = result.faults.empty() ? CheckResult::Good : CheckResult::Bad;
  return result;
}

}  // namespace racebeam
