// Crosses of the functional coverage: points by number and name, what is missing, what cannot be.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/functional_points.h"

#include <gmock/gmock.h>

#include <set>
#include <string>

#include "sc/base/engine.h"
#include "tb/base/errors.h"
#include "tb/scene/engines.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

FunctionalCross fifo_cross() {
  return {"interval_fifo",
          "example",
          "",
          {axis_of_flag("emit", "emit_i == 1"),
           {"fill", {{"one", "fill_o == 1"}, {"more", "fill_o > 1"}}}},
          {{{"yes", "more"}, "nobody offers then"}}};
}

TEST(FunctionalCross, PointsCountTheLastAxisFastest) {
  const FunctionalCross cross = fifo_cross();
  ASSERT_EQ(cross.points(), 4u);
  EXPECT_EQ(cross.point_name(0), "emit=yes fill=one");
  EXPECT_EQ(cross.point_name(1), "emit=yes fill=more");
  EXPECT_EQ(cross.point_name(2), "emit=no fill=one");
  EXPECT_TRUE(cross.impossible_at(1, {}));
  EXPECT_FALSE(cross.impossible_at(3, {}));
}

TEST(FunctionalCross, WhatWasNotSeenIsNamed) {
  const CrossVerdict verdict = judge_cross(fifo_cross(), {3, 0, 0, 5}, {});
  EXPECT_EQ(verdict.hit, 2u);
  EXPECT_EQ(verdict.possible, 3u);
  EXPECT_THAT(verdict.missing, ElementsAre("interval_fifo example: emit=no fill=one"));
  EXPECT_TRUE(verdict.faults.empty());
}

TEST(FunctionalCross, TheImpossibleSeenIsAFault) {
  EXPECT_THAT(judge_cross(fifo_cross(), {3, 1, 1, 5}, {}).faults,
              ElementsAre(HasSubstr("emit=yes fill=more was seen")));
}

TEST(FunctionalCross, WhatNeedNotBeSeenMayBe) {
  FunctionalCross cross = fifo_cross();
  cross.impossible.front().never = false;
  EXPECT_TRUE(judge_cross(cross, {3, 1, 1, 5}, {}).faults.empty());
  EXPECT_EQ(judge_cross(cross, {3, 0, 1, 5}, {}).possible, 3u);
}

TEST(FunctionalCross, TheImpossibleOfOtherParametersCanBe) {
  FunctionalCross cross = fifo_cross();
  cross.impossible.front().when = "FifoEntries == 9";
  EXPECT_EQ(judge_cross(cross, {3, 0, 1, 5}, {{"FifoEntries", 9}}).possible, 3u);
  EXPECT_EQ(judge_cross(cross, {3, 0, 1, 5}, {{"FifoEntries", 4}}).possible, 4u);
  EXPECT_THAT(judge_cross(cross, {3, 1, 1, 5}, {{"FifoEntries", 4}}).faults, IsEmpty());
  EXPECT_THROW(judge_cross(cross, {3, 0, 1, 5}, {}), UsageError);
}

class FunctionalCounter : public testing::Test {
 protected:
  const engine& built_ = *engines().front();
  std::unique_ptr<sc_core::sc_module> model_ =
      built_.unit("interval_fifo")->make("model", built_.standard(nullptr), nullptr);
  UnitBench bench_{*model_};
};

TEST_F(FunctionalCounter, CountsClocksOfEachPoint) {
  const FunctionalCross cross = fifo_cross();
  CrossCounter counter(cross, bench_, *model_);
  bench_["tracer_reset_i"].drive(1);
  bench_.clock();
  counter.look();
  counter.look();
  bench_["emit_i"].drive(1);
  bench_.settle();
  counter.look();
  EXPECT_THAT(counter.counts(), ElementsAre(1, 0, 2, 0));
}

TEST_F(FunctionalCounter, NamesThatAreNotThereAreRefused) {
  FunctionalCross cross = fifo_cross();
  cross.during = "no_such_port_i == 1";
  EXPECT_THROW(CrossCounter(cross, bench_, *model_), UsageError);
}

/// Each cross fits its unit: each in a process of its own.
class CrossesOfUnit : public testing::TestWithParam<std::string> {};

TEST_P(CrossesOfUnit, FitTheModel) {
  for (const engine* built : engines()) {
    if (!built->unit(GetParam())) continue;
    const auto model = built->unit(GetParam())->make("model", built->standard(nullptr), nullptr);
    UnitBench bench(*model);
    for (const FunctionalCross& cross : functional_crosses(GetParam())) {
      CrossCounter counter(cross, bench, *model);
      bench.settle();
      counter.look();
      for (const ImpossibleCross& one : cross.impossible) EXPECT_NE(one.reason, "");
    }
    return;
  }
  FAIL() << "no engine has a unit " << GetParam();
}

std::set<std::string> units_with_crosses() {
  std::set<std::string> units;
  for (const FunctionalCross& cross : all_functional_crosses()) units.insert(cross.unit);
  return units;
}
INSTANTIATE_TEST_SUITE_P(Units, CrossesOfUnit, testing::ValuesIn(units_with_crosses()),
                         [](const auto& unit) { return unit.param; });

}  // namespace
}  // namespace racebeam
