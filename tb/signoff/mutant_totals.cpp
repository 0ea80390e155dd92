// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_totals.h"

#include <fmt/format.h>

#include <algorithm>

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t Bounds[] = {3, 10, 100, 1'000, 10'000, 100'000};

/// Rounded down: 98.99 is not 99.
double tenths_of_percent(std::int64_t part, std::int64_t whole) {
  return static_cast<double>(1000 * part / std::max<std::int64_t>(whole, 1)) / 10;
}

}  // namespace

Json found_within(const std::vector<std::uint64_t>& clocks) {
  Json counts = Json::object();
  for (const std::uint64_t bound : Bounds)
    counts[std::to_string(bound)] =
        std::count_if(clocks.begin(), clocks.end(), [&](std::uint64_t n) { return n <= bound; });
  return counts;
}

Json mutant_totals(const std::vector<CheckResult>& results) {
  Json totals = {{"units", 0},         {"mutants", 0},   {"found", 0},  {"equal", 0},
                 {"not_found", 0},     {"undecided", 0}, {"waived", 0}, {"by_walk", 0},
                 {"random", 0},        {"within", {}},   {"shrunk", 0}, {"shrunk_clocks", {}},
                 {"shrunk_moving", {}}};
  const auto add = [](Json& to, const Json& count) {
    to = (to.is_null() ? 0 : to.get<std::int64_t>()) + count.get<std::int64_t>();
  };
  for (const CheckResult& result : results) {
    if (result.check != "mutants" || !result.detail.contains("found_within")) continue;
    add(totals["units"], 1);
    for (const char* name :
         {"mutants", "found", "equal", "not_found", "undecided", "waived", "by_walk"})
      add(totals[name], result.detail.at(name));
    add(totals["random"],
        result.detail.at("found").get<int>() - result.detail.at("by_walk").get<int>());
    const auto add_all = [&](const char* to, const Json& counts) {
      for (const auto& [bound, count] : counts.items()) add(totals[to][bound], count);
    };
    add_all("within", result.detail.at("found_within"));
    if (!result.detail.contains("shrunk")) continue;
    const Json& shrunk = result.detail.at("shrunk");
    add(totals["shrunk"], shrunk.at("mutants"));
    add_all("shrunk_clocks", shrunk.at("clocks_within"));
    add_all("shrunk_moving", shrunk.at("moving_within"));
  }
  return totals["units"] < 2 ? Json() : totals;
}

std::string totals_text(const Json& totals) {
  if (totals.is_null()) return "";
  const auto count = [&](const char* name) { return totals.at(name).get<std::int64_t>(); };
  std::string text = fmt::format("{} of {} found, {} proved equal", count("found"),
                                 count("mutants"), count("equal"));
  if (count("not_found") > 0) text += fmt::format(", {} not found", count("not_found"));
  if (count("undecided") > 0) text += fmt::format(", {} undecided", count("undecided"));
  if (count("waived") > 0) text += fmt::format(", {} of them waived", count("waived"));
  const auto share = [&](const char* of, const char* bound, const char* all) {
    return tenths_of_percent(totals.at(of).at(bound), count(all));
  };
  text += fmt::format("; by random traffic {}, {:.1f} % within 100 clocks, {:.1f} % within 10000",
                      count("random"), share("within", "100", "random"),
                      share("within", "10000", "random"));
  if (count("shrunk") == 0) return text;
  return text +
         fmt::format("; shrunk, {:.1f} % have at most 10 clocks, {:.1f} % at most 3 moving inputs",
                     share("shrunk_clocks", "10", "shrunk"), share("shrunk_moving", "3", "shrunk"));
}

}  // namespace racebeam
