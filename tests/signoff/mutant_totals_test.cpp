// What the mutants of several units come to.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_totals.h"

#include <gtest/gtest.h>

namespace racebeam {
namespace {

using Json = nlohmann::ordered_json;

CheckResult mutants(int found, int by_walk, const std::vector<std::uint64_t>& clocks) {
  CheckResult result;
  result.check = "mutants";
  result.detail = {{"mutants", 1000},       {"found", found},
                   {"equal", 1000 - found}, {"not_found", 0},
                   {"undecided", 0},        {"waived", 0},
                   {"by_walk", by_walk},    {"found_within", found_within(clocks)}};
  return result;
}

TEST(MutantTotals, BoundsAreIncluded) {
  EXPECT_EQ(found_within({1, 10, 11, 100'000, 100'001}),
            Json({{"3", 1}, {"10", 2}, {"100", 3}, {"1000", 3}, {"10000", 3}, {"100000", 4}}));
}

TEST(MutantTotals, UnitsAreAddedUp) {
  const Json totals = mutant_totals({mutants(3, 1, {5, 200}), mutants(2, 0, {1, 20'000})});
  EXPECT_EQ(totals["units"], 2);
  EXPECT_EQ(totals["mutants"], 2000);
  EXPECT_EQ(totals["random"], 4);
  EXPECT_EQ(totals["within"]["100"], 2);
  EXPECT_EQ(totals_text(totals),
            "5 of 2000 found, 1995 proved equal; by random traffic 4, 50.0 % within 100 clocks, "
            "75.0 % within 10000");
}

TEST(MutantTotals, SharesAreRoundedDown) {
  std::vector<std::uint64_t> clocks(9999, 1);
  clocks.push_back(10'001);
  const Json totals = mutant_totals({mutants(10'000, 0, clocks), mutants(0, 0, {})});
  EXPECT_NE(totals_text(totals).find("99.9 % within 10000"), std::string::npos);
}

TEST(MutantTotals, ShrunkStreamsAreCounted) {
  CheckResult a = mutants(2, 0, {5, 200}), b = mutants(2, 0, {1, 20});
  a.detail["shrunk"] = {{"mutants", 2},
                        {"clocks_within", found_within({2, 11})},
                        {"moving_within", found_within({0, 3})}};
  b.detail["shrunk"] = {{"mutants", 2},
                        {"clocks_within", found_within({1, 10})},
                        {"moving_within", found_within({0, 4})}};
  EXPECT_NE(totals_text(mutant_totals({a, b}))
                .find("; shrunk, 75.0 % have at most 10 clocks, 75.0 % at most 3 moving inputs"),
            std::string::npos);
}

TEST(MutantTotals, OneUnitHasNone) {
  CheckResult other;
  other.check = "lint";
  CheckResult broken;
  broken.check = "mutants";  // its RTL cannot be read
  EXPECT_TRUE(mutant_totals({mutants(1, 0, {1}), other, broken}).is_null());
  EXPECT_EQ(totals_text(Json()), "");
}

}  // namespace
}  // namespace racebeam
