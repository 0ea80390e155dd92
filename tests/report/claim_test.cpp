// Claims: their table, their arithmetic, their verdicts, and the page that has them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tb/base/errors.h"
#include "tb/report/claim_arithmetic.h"
#include "tb/report/claim_figures.h"
#include "tb/report/claim_report.h"
#include "tb/report/claim_table.h"
#include "tb/report/claim_verdict.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;
using testing::SizeIs;

double arithmetic(const std::string& figure, const knobs& k = {}) {
  return arithmetic_figure(figure)->value(k);
}

std::string faults_of(const std::string& check) {
  return read_claims("[[claim]]\nid = \"S0-1\"\nsays = \"x\"\n[[claim.check]]\n" + check)
      .faults.text("f");
}

constexpr const char* GoodCheck =
    "how = \"x\"\nfigure = \"starved\"\nexpected = \"x\"\nholds = [0, 1]\n";

TEST(ClaimTable, OfTheProjectIsWithoutFaults) { EXPECT_GE(load_claims().size(), 35u); }

TEST(ClaimTable, AGoodCheckHasNoFault) { EXPECT_EQ(faults_of(GoodCheck), ""); }

TEST(ClaimTable, FaultsAreNamedWithTheirPlace) {
  EXPECT_THAT(faults_of("how = \"x\"\nfigure = \"starvd\"\nexpected = \"x\"\nholds = [0, 1]\n"),
              HasSubstr("f:6:10: unknown figure 'starvd'\n  help: did you mean 'starved'?"));
  EXPECT_THAT(faults_of(std::string(GoodCheck) + "in_kind = [0.5, 2]\n"),
              HasSubstr("'in_kind' does not enclose 'holds'"));
  EXPECT_THAT(faults_of(std::string(GoodCheck) + "of = { dr_bit = 9 }\n"),
              HasSubstr("did you mean 'dr_bits'?"));
  EXPECT_THAT(faults_of(std::string(GoodCheck) + "against = {}\n"),
              HasSubstr("'against' goes with 'as' alone"));
  EXPECT_THAT(faults_of(std::string(GoodCheck) + "scene = \"gird\"\n"),
              HasSubstr("there is no scene 'gird'"));
  EXPECT_THAT(faults_of("how = \"x\"\nfigure = \"starved\"\nexpected = \"x\"\nholds = [1, 0]\n"),
              HasSubstr("begins behind its end"));
}

TEST(ClaimTable, RowsAreChosenByEachOfTheirNumbers) {
  const std::vector<Claim> all = load_claims();
  EXPECT_EQ(chosen_claims(all, {"S0-66"}).at(0).id, "S0-65, 66");
  EXPECT_EQ(chosen_claims(all, {"65"}).at(0).id, "S0-65, 66");
  EXPECT_THAT(chosen_claims(all, {"62", "63"}), SizeIs(2));
  EXPECT_THROW(chosen_claims(all, {"S0-6"}), UsageError);
}

TEST(ClaimTable, HasTheRowsThatWereAskedFor) {
  const std::vector<Claim> all = load_claims();
  for (const char* row : {"12", "22", "39", "41", "44", "55", "63", "68", "71", "74", "78", "84",
                          "85", "93", "106", "113", "115"})
    EXPECT_THAT(chosen_claims(all, {row}), SizeIs(1)) << row;
}

TEST(ClaimArithmetic, IsThatOfTheInventory) {
  EXPECT_THAT(arithmetic("probes.mean"), DoubleNear(7.9408, 5e-5));
  EXPECT_EQ(arithmetic("probes.most"), 10);
  EXPECT_THAT(arithmetic("walks.mean"), DoubleNear(3.515, 5e-4));
  EXPECT_THAT(arithmetic("factors.mean"), DoubleNear(3.44, 5e-3));
  EXPECT_EQ(arithmetic("product.least"), -129);
  EXPECT_EQ(arithmetic("product.mean"), -32.25);
  EXPECT_EQ(arithmetic("partial_products"), 114);
}

TEST(ClaimArithmetic, IsOfTheChipThatItIsAskedOf) {
  knobs k;
  k.partial_products_cut = 0;
  k.camera_cosine = CosineExact;
  k.stepping = SteppingFraction;
  k.bisection = BisectionFloor;
  EXPECT_EQ(arithmetic("product.least", k), 0);
  EXPECT_EQ(arithmetic("partial_products", k), 144);
  EXPECT_EQ(arithmetic("cosine.most", k), 0);
  EXPECT_LE(arithmetic("steps.most", k), 0) << "only the fraction is not in dr2";
  EXPECT_EQ(arithmetic("probes.most", k), 16);
}

TEST(ClaimVerdict, IsTheStrongestThatTheWholeIntervalSupports) {
  ClaimCheck check;
  check.holds = {1, 2};
  check.in_kind = ClaimBounds{0, 10};
  const auto verdict = [&](double value, double half) {
    return verdict_of(check, {value, half, 10, 100});
  };
  EXPECT_EQ(verdict(1.5, 0.5), ClaimVerdict::Holds);
  EXPECT_EQ(verdict(1.5, 0.6), ClaimVerdict::HoldsInKind);
  EXPECT_EQ(verdict(1.5, 1.6), ClaimVerdict::NotDecided);
  EXPECT_EQ(verdict(11, 0.5), ClaimVerdict::DoesNotHold);
  EXPECT_EQ(verdict(11, 1.5), ClaimVerdict::NotDecided);
  EXPECT_EQ(verdict(std::nan(""), 0), ClaimVerdict::NotDecided);
}

TEST(ClaimVerdict, OfAClaimIsTheWorstOfItsChecks) {
  ClaimFinding finding;
  finding.checks.resize(2);
  finding.checks[0].verdict = ClaimVerdict::Holds;
  finding.checks[1].verdict = ClaimVerdict::HoldsInKind;
  EXPECT_EQ(finding.verdict(), ClaimVerdict::HoldsInKind);
  finding.checks[0].verdict = ClaimVerdict::DoesNotHold;
  EXPECT_EQ(finding.verdict(), ClaimVerdict::DoesNotHold);
}

// --- docs/claims.md ------------------------------------------------------------------------------

/// "1.32 % +/- 0.05": as it was printed.
Estimate printed(std::string found) {
  found.erase(std::remove(found.begin(), found.end(), ','), found.end());
  const std::size_t more = found.find("+/- ");
  const double half = more == std::string::npos ? 0 : std::atof(found.c_str() + more + 4);
  return {std::atof(found.c_str()), half, 1, 1};
}

std::vector<std::vector<std::string>> page_rows() {
  return table_rows(page("docs/claims.md"), "## All of them");
}

TEST(ClaimPage, HasTheTableOfTheProgramRowByRow) {
  const std::vector<std::vector<std::string>> rows = page_rows();
  std::size_t row = 0;
  for (const Claim& claim : load_claims())
    for (std::size_t i = 0; i < claim.checks.size(); ++i, ++row) {
      ASSERT_LT(row, rows.size());
      const ClaimCheck& check = claim.checks[i];
      const std::vector<std::string>& cells = rows[row];
      ASSERT_THAT(cells, SizeIs(7));
      EXPECT_EQ(cells[0], i ? "" : claim.id);
      EXPECT_EQ(cells[1], i ? "" : claim.says);
      EXPECT_EQ(cells[2], check.how);
      EXPECT_EQ(cells[3], check.expected);
      EXPECT_EQ(cells[4], bounds_text(check.holds));
    }
  EXPECT_EQ(row, rows.size());
}

TEST(ClaimPage, ArithmeticIsWhatTheChipComputesToday) {
  const std::vector<std::vector<std::string>> rows = page_rows();
  std::size_t row = 0;
  for (const Claim& claim : load_claims())
    for (const ClaimCheck& check : claim.checks) {
      const std::vector<std::string>& cells = rows.at(row++);
      if (claim_source(check.figure) != ClaimSource::Arithmetic || !check.of.empty()) continue;
      CheckFinding finding;
      finding.found = Estimate{arithmetic(check.figure) * check.times, 0, 1, 1};
      EXPECT_EQ(cells[5], found_text(check, finding)) << check.how;
    }
}

/// Digits that were rounded away may decide next to a bound: both neighbours are asked.
TEST(ClaimPage, VerdictsFollowFromWhatWasFound) {
  const std::vector<std::vector<std::string>> rows = page_rows();
  std::size_t row = 0;
  for (const Claim& claim : load_claims())
    for (const ClaimCheck& check : claim.checks) {
      const std::vector<std::string>& cells = rows.at(row++);
      if (claim_source(check.figure) == ClaimSource::Arithmetic) continue;
      const Estimate found = printed(cells[5]);
      std::vector<std::string> may;
      for (const double rounding : {0.0, -1.0, 1.0}) {
        Estimate one = found;
        one.half_width = std::max(0.0, one.half_width * (1 + 0.1 * rounding));
        may.push_back(claim_verdict_words()[std::size_t(verdict_of(check, one))]);
      }
      EXPECT_THAT(may, testing::Contains(cells[6])) << claim.id << ": " << check.how;
    }
}

}  // namespace
}  // namespace racebeam
