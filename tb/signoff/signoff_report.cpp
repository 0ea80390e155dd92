// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/signoff_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/signoff/mutant_totals.h"

namespace racebeam {

namespace {

constexpr const char* Words[] = {"good", "BAD", "undecided"};

}  // namespace

bool SignoffReport::green() const {
  return whole && std::all_of(results.begin(), results.end(), [](const CheckResult& result) {
           return result.verdict == CheckResult::Good;
         });
}

std::string SignoffReport::name(const CheckResult& result) const {
  return engine == AllEngines ? result.engine + "/" + result.unit : result.unit;
}

std::string signoff_text(const SignoffReport& report) {
  std::size_t unit = 4, check = 5;
  for (const CheckResult& result : report.results) {
    unit = std::max(unit, report.name(result).size());
    check = std::max(check, result.check.size());
  }
  std::string text = fmt::format("{:<{}}  {:<{}}  {:<9}  {:>7}  {}\n", "unit", unit, "check", check,
                                 "verdict", "s", "found");
  for (const CheckResult& result : report.results)
    text += fmt::format("{:<{}}  {:<{}}  {:<9}  {:>7.1f}  {}\n", report.name(result), unit,
                        result.check, check, Words[result.verdict], result.seconds, result.summary);
  if (const std::string all = totals_text(mutant_totals(report.results)); !all.empty())
    text += "\nmutants of all units: " + all + "\n";
  for (const CheckResult& result : report.results)
    for (const std::string& fault : result.faults)
      text += fmt::format("\n{} {}: {}\n", report.name(result), result.check, fault);
  return text;
}

std::string signoff_json(const SignoffReport& report) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const CheckResult& result : report.results) results.push_back(to_json(result));
  return nlohmann::ordered_json{{"schema", "racebeam-signoff"},
                                {"version", 1},
                                {"scene", report.scene},
                                {"engine", report.engine},
                                {"green", report.green()},
                                {"whole", report.whole},
                                {"mutants", mutant_totals(report.results)},
                                {"results", results}}
             .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

}  // namespace racebeam
