// What yosys says of units, and what becomes of a yosys that says nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <csignal>
#include <sstream>

#include "sc/beam/engine.h"
#include "sc/beam/knobs.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/sweep/silicon_plan.h"
#include "tb/sweep/store.h"
#include "tests/support/fake_yosys.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// One unit of a chip.
UnitParameters unit_of(const knobs& k, const std::string& name) {
  for (const UnitParameters& unit : Silicon(beam_engine()).units_of(k))
    if (unit.unit == name) return unit;
  throw std::out_of_range(name);
}

/// What becomes of one.
UnitOutcome outcome_of(const UnitParameters& unit, const SynthesisPlan& plan = {}) {
  UnitOutcome outcome;
  synthesise({unit}, plan, [&](const UnitParameters&, const UnitOutcome& end) { outcome = end; });
  return outcome;
}

std::string fault_of(const std::string& unit, const SynthesisPlan& plan = {}) {
  const UnitOutcome outcome = outcome_of(unit_of(knobs(), unit), plan);
  EXPECT_FALSE(outcome.silicon);
  return outcome.fault;
}

/// Flip-flops and cells of the row of docs/chip.md that begins so.
std::pair<std::int64_t, std::int64_t> row_of_page(const std::string& begin) {
  std::istringstream page(whole_file(RACEBEAM_SOURCE_DIR "/docs/chip.md"));
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| " + begin, 0) != 0) continue;
    const auto last = line.rfind('|', line.size() - 2), before = line.rfind('|', last - 1);
    return {std::stoll(line.substr(before + 1)), std::stoll(line.substr(last + 1))};
  }
  throw std::out_of_range(begin);
}

// scripts/area --check holds that page to the same RTL.
TEST(SiliconSynthesis, TheChipHasTheFiguresOfScriptsArea) {
  const Silicon silicon(beam_engine());
  SiliconPlan plan(silicon, [](const std::string&) { return std::nullopt; });
  plan.want(knobs());
  synthesise(plan.missing(), {2}, [&plan](const UnitParameters& unit, const UnitOutcome& outcome) {
    EXPECT_EQ(outcome.fault, "");
    plan.put(unit, outcome);
  });
  const auto all = row_of_page("**all**"), sound = row_of_page("[pwm_sound]");
  const PointSilicon chip = plan.of(knobs());
  EXPECT_EQ(chip.fault, "");
  EXPECT_EQ(chip.flip_flops, all.first - sound.first);
  EXPECT_EQ(chip.cells, all.second - sound.second);
}

TEST(SiliconSynthesis, StoredEqualsFresh) {
  const QuickFolder folder;
  knobs k;
  k.interval_stack_depth = 2;
  const UnitParameters unit = unit_of(k, "stacks");
  const UnitOutcome first = outcome_of(unit), again = outcome_of(unit);
  ASSERT_TRUE(first.silicon) << first.fault;
  { OpenStore(folder / "sweep.sqlite").units.put(*first.silicon); }
  OpenStore store(folder / "sweep.sqlite", Access::Read);
  const auto stored = store.units.find(unit.hash);
  ASSERT_TRUE(stored);
  ASSERT_TRUE(again.silicon);
  EXPECT_EQ(stored->parameters, "IntervalStackDepth=2 FaceStackDepth=9 PortalsPerFace=1");
  EXPECT_EQ(stored->recipe, "generic");
  EXPECT_EQ(stored->flip_flops, again.silicon->flip_flops);
  EXPECT_EQ(stored->cells, again.silicon->cells);
  // 17 bits an entry; the chip has four
  EXPECT_EQ(stored->flip_flops,
            outcome_of(unit_of(knobs(), "stacks")).silicon->flip_flops - 2 * 17);
}

TEST(SiliconSynthesis, TakesNegativeParameters) {
  knobs k;
  k.hurry_threshold = -1;
  const UnitOutcome outcome = outcome_of(unit_of(k, "subdivider"));
  ASSERT_TRUE(outcome.silicon) << outcome.fault;
  EXPECT_GT(outcome.silicon->cells, 500);
}

TEST(SiliconSynthesis, ParameterThatTheRtlRefusesIsAFault) {
  UnitParameters unit = unit_of(knobs(), "stacks");
  unit.settings = {"Nothing=1"};
  const UnitOutcome outcome = outcome_of(unit);
  EXPECT_FALSE(outcome.silicon);
  EXPECT_THAT(outcome.fault, StartsWith("stacks with Nothing=1: "));
  EXPECT_THAT(outcome.fault, HasSubstr("ERROR: Can't find object for defparam `Nothing`"));
}

TEST(SiliconSynthesis, YosysThatHangsIsEnded) {
  const FakeYosys fake(FakeYosys::Hangs);
  const auto start = [&fake] { return fault_of("stacks", {1, std::chrono::milliseconds(1500)}); };
  std::string fault = start();
  while (!fake.hangs()) fault = start();  // a busy machine had not begun in time
  EXPECT_EQ(fault, "stacks: yosys did not end within 1.5 seconds");
  EXPECT_TRUE(fake.is_gone());
}

TEST(SiliconSynthesis, OneThatFailsLeavesTheOthers) {
  const FakeYosys fake(std::string("case \"$*\" in *'top stacks'*) exit 1 ;; esac\n") +
                       FakeYosys::Counts);
  const Silicon silicon(beam_engine());
  SiliconPlan plan(silicon, [](const std::string&) { return std::nullopt; });
  plan.want(knobs());
  int good = 0;
  synthesise(plan.missing(), {3}, [&](const UnitParameters& unit, const UnitOutcome& outcome) {
    plan.put(unit, outcome);
    EXPECT_EQ(outcome.silicon.has_value(), unit.unit != "stacks") << outcome.fault;
    good += outcome.silicon && outcome.silicon->flip_flops == 2 && outcome.silicon->cells == 5;
  });
  EXPECT_EQ(good, 10);
  EXPECT_TRUE(plan.missing().empty());
  EXPECT_EQ(plan.of(knobs()).fault, "stacks: scripts/netlist: yosys cannot read stacks; see above");
}

TEST(SiliconSynthesis, InterruptEndsWhatRuns) {
  const FakeYosys fake(FakeYosys::Hangs);
  SynthesisPlan plan;
  bool sent = false;
  plan.tick = [&] {
    if (sent || !fake.hangs()) return;
    sent = true;
    std::raise(SIGINT);
    time_to_finish(600);
  };
  EXPECT_THROW(outcome_of(unit_of(knobs(), "stacks"), plan), Interrupted);
  EXPECT_TRUE(fake.is_gone());
}

TEST(SiliconSynthesis, CallerThatThrowsEndsWhatRuns) {
  const FakeYosys fake(
      std::string("case \"$*\" in *'top stacks'*) ;; *) while [ ! -e $0.id ]; do ") +
      "sleep 0.1; done; exit 1 ;; esac\n" + FakeYosys::Hangs);
  const auto full = [](const UnitParameters&, const UnitOutcome&) { throw UsageError("full"); };
  EXPECT_THROW(synthesise({unit_of(knobs(), "stacks"), unit_of(knobs(), "scene")}, {2}, full),
               UsageError);
  EXPECT_TRUE(fake.is_gone());
}

TEST(SiliconSynthesis, YosysThatFailsIsQuoted) {
  const FakeYosys fake("echo 'Warning: odd'\necho 'x.sv:7: ERROR: no such thing' >&2\nexit 1\n");
  EXPECT_EQ(fault_of("stacks"), "stacks: x.sv:7: ERROR: no such thing");
}

TEST(SiliconSynthesis, YosysThatDiesIsQuoted) {
  const FakeYosys fake("echo unwell\nkill -9 $$\n");
  EXPECT_THAT(fault_of("stacks"),
              testing::AllOf(StartsWith("stacks: unwell; "), HasSubstr("Killed")));
}

TEST(SiliconSynthesis, GarbageIsNoFigure) {
  {
    const FakeYosys fake("echo '%&/'\n");
    EXPECT_EQ(fault_of("scene"), "scene: scripts/netlist: yosys has written nothing for scene");
  }
  {
    const FakeYosys fake("printf 'so\\0much\\n%%\\n' >out\n");
    EXPECT_THAT(fault_of("scene"), HasSubstr("yosys has not counted the cells of scene"));
  }
  {
    const FakeYosys fake("echo '  Number of cells: many' >out\n");
    EXPECT_THAT(fault_of("scene"), StartsWith("scene: no figures: "));
  }
  const FakeYosys fake("echo '  Number of cells: 5 $_DFF_P_' >out\necho '  $_DFF_P_ 6' >>out\n");
  EXPECT_THAT(fault_of("scene"), StartsWith("scene: no figures: "));
}

}  // namespace
}  // namespace racebeam
