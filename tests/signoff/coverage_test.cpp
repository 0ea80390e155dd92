// Coverage of a unit: a line that nothing reaches is told, and a waiver is red unless its points
// are there, not hit, and not constant anyhow.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/coverage.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "sc/base/engine.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/scene/engines.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CoveragePoint point(CoveragePoint::Kind kind, const std::string& name, std::uint64_t count) {
  return {kind, "stacks", "rtl/beam/stacks.sv", 7, 3, name, "if (a) b <= c;", count};
}

/// A line that is hit, a branch that is not, two bits that move and one that does not.
UnitCoverage counted() {
  UnitCoverage coverage;
  coverage.points = {
      point(CoveragePoint::Line, "block", 9), point(CoveragePoint::Branch, "else", 0),
      point(CoveragePoint::Toggle, "q[0]", 9), point(CoveragePoint::Toggle, "q[1]", 2),
      point(CoveragePoint::Toggle, "q[2]", 1)};
  coverage.constant.resize(coverage.points.size());
  coverage.parameters = {{"PortalsPerFace", 1}};
  return coverage;
}

CoverageWaiver waiver(CoveragePoint::Kind kind, const std::vector<std::string>& points) {
  return {{"stacks"}, kind, "stacks", points, "", "nobody asks for it", {12, 1}};
}

CheckResult judged(const std::vector<CoverageWaiver>& waivers, UnitCoverage coverage = counted()) {
  return judge_coverage("stacks", coverage, {}, waivers);
}

const CoverageWaiver Else = waiver(CoveragePoint::Branch, {"else: if (a) b <= c;"});
const CoverageWaiver Bit2 = waiver(CoveragePoint::Toggle, {"q[2]"});

TEST(CoverageVerdict, MissingPointsAreNamedWithTheirPlace) {
  const CheckResult result = judged({});
  EXPECT_EQ(result.verdict, CheckResult::Bad);
  EXPECT_THAT(result.faults,
              ElementsAre("rtl/beam/stacks.sv:7: branch of stacks is not hit: else: if (a) b <= c;",
                          "rtl/beam/stacks.sv:7: toggle of stacks is not hit: q[2]"));
  EXPECT_EQ(result.summary, "line 1/1, branch 0/1, toggle 2/3");
}

TEST(CoverageVerdict, WaivedPointsCountNoMore) {
  const CheckResult result = judged({Else, Bit2});
  EXPECT_EQ(result.verdict, CheckResult::Good) << result.summary;
  EXPECT_EQ(result.summary, "line 1/1, branch 0/0, toggle 2/2");
  EXPECT_EQ(result.detail["toggle"]["waived"], 1);
}

TEST(CoverageVerdict, AWaiverOfAPointThatIsHitIsAFault) {
  EXPECT_THAT(judged({Else, waiver(CoveragePoint::Toggle, {"q[2:1]"})}).faults,
              ElementsAre("waiver of line 12: stacks q[1] (rtl/beam/stacks.sv:7) is hit; take it "
                          "out"));
}

TEST(CoverageVerdict, AWaiverOfWhatIsNotThereIsAFault) {
  EXPECT_THAT(judged({Else, Bit2, waiver(CoveragePoint::Toggle, {"q[3]"})}).faults,
              ElementsAre("waiver of line 12: stacks has no toggle 'q[3]'; correct it, or take it "
                          "out"));
}

TEST(CoverageVerdict, AWaiverMayNameOneOfSeveralThatAreCalledAlike) {
  UnitCoverage coverage = counted();
  coverage.points.push_back(point(CoveragePoint::Branch, "else", 3));
  coverage.constant.resize(coverage.points.size());
  const auto branch = [](const std::string& name) {
    return waiver(CoveragePoint::Branch, {name + "else: if (a) b <= c;"});
  };
  EXPECT_THAT(judged({Bit2, branch("#1 ")}, coverage).faults, IsEmpty());
  EXPECT_THAT(judged({Bit2, branch("")}, coverage).faults, ElementsAre(HasSubstr("is hit")));
  EXPECT_THAT(judged({Bit2, branch("#2 ")}, coverage).faults, Contains(HasSubstr("is hit")));
  EXPECT_THAT(judged({Bit2, branch("#3 ")}, coverage).faults, Contains(HasSubstr("has no branch")));
}

TEST(CoverageVerdict, ABitThatGoesUpInEachOfTwoRunsHasNotMoved) {
  std::vector<CoveragePoint> points = {point(CoveragePoint::Toggle, "q[0]", 1),
                                       point(CoveragePoint::Line, "block", 1)};
  add_coverage(points,
               {point(CoveragePoint::Toggle, "q[0]", 1), point(CoveragePoint::Line, "block", 0)});
  EXPECT_FALSE(points[0].hit());
  EXPECT_TRUE(points[1].hit());
  add_coverage(points,
               {point(CoveragePoint::Toggle, "q[0]", 2), point(CoveragePoint::Line, "block", 0)});
  EXPECT_TRUE(points[0].hit());
}

TEST(CoverageVerdict, AWaiverWithoutAReasonIsAFault) {
  CoverageWaiver mute = Bit2;
  mute.reason.clear();
  EXPECT_THAT(judged({Else, mute}).faults, Contains(HasSubstr("it has no reason")));
  EXPECT_FALSE(read_coverage_waivers("[[waiver]]\nunits = ['a']\nkind = 'line'\nmodule = 'a'\n"
                                     "points = ['b']\nreason = ' '\n")
                   .faults.none());
  EXPECT_FALSE(read_coverage_waivers("[[waiver]]\nunits = ['a']\nkind = 'line'\nmodule = 'a'\n"
                                     "points = ['b']\n")
                   .faults.none());
}

TEST(CoverageVerdict, AWaiverOfOtherParametersIsVoid) {
  CoverageWaiver other = Bit2;
  other.when = "PortalsPerFace > 1";
  EXPECT_THAT(judged({Else, other}).faults, ElementsAre(HasSubstr("toggle of stacks")));
  other.when = "PortalsPerFace == 1";
  EXPECT_THAT(judged({Else, other}).faults, IsEmpty());
  other.when = "Portals == 1";
  EXPECT_THAT(judged({Else, other}).faults, Contains(HasSubstr("no parameter Portals")));
}

TEST(CoverageVerdict, ConstantBitsCountNoMoreUnlessTheyMove) {
  UnitCoverage coverage = counted();
  coverage.constant[4] = true;
  EXPECT_THAT(judged({Else}, coverage).faults, IsEmpty());
  EXPECT_THAT(judged({Else, Bit2}, coverage).faults, ElementsAre(HasSubstr("is constant")));
  coverage.constant[3] = true;
  EXPECT_THAT(judged({Else}, coverage).faults, ElementsAre(HasSubstr("one of the tools is wrong")));
}

TEST(CoverageVerdict, RtlWithoutAnyPointIsBad) {
  EXPECT_EQ(judged({}, {}).verdict, CheckResult::Bad);
}

TEST(CoverageWaivers, TheProjectsCanBeRead) { EXPECT_NO_THROW(load_coverage_waivers("")); }

TEST(CoverageWaivers, AFileThatIsNotThereIsRefused) {
  EXPECT_THROW(load_coverage_waivers("/nowhere/waivers.toml"), UsageError);
}

/// stacks, with what no input can reach in the line of `mark`.
class CoverageOfStacks : public testing::Test {
 protected:
  CheckResult signed_off(const std::string& rtl, const std::string& waivers) {
    const engine& built = *engines().front();
    return sign_off_coverage({"stacks", "", built.standard(nullptr), nullptr, 1},
                             {2000, 1, rtl, waivers});
  }
  ScratchFolder folder_;
};

TEST_F(CoverageOfStacks, AnUnreachableLineIsTold) {
  std::string text = whole_file(rtl_file("stacks"));
  const std::string mark = "  always_ff @(posedge clk_i) begin\n";
  const std::size_t at = text.find(mark);
  ASSERT_NE(at, std::string::npos);
  text.insert(at + mark.size(), "    if (32'(sp_i) == 99) tags_q[0] <= '0;\n");
  const std::string rtl = folder_ / "stacks.sv", waivers = folder_ / "waivers.toml";
  std::ofstream(rtl) << text;
  std::ofstream(waivers) << "";
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const CheckResult result = signed_off(rtl, waivers);
  EXPECT_EQ(result.verdict, CheckResult::Bad);
  EXPECT_THAT(result.faults,
              Contains(rtl + ":" + std::to_string(line + 2) +
                       ": branch of stacks is not hit: if: if (32'(sp_i) == 99) tags_q[0] <= '0;"));
}

}  // namespace
}  // namespace racebeam
