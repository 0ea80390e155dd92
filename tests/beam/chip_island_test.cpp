// Promises of islands: units in RTL that touch each other are one model behind their pins, and the
// chip's pins and counters stay those of its cores.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <set>
#include <string>

#include "sc/beam/engine.h"
#include "sc/swap/rtl_library.h"
#include "tb/bench/core_bench.h"
#include "tb/bench/signal_bench.h"
#include "tb/twin/use_option.h"
#include "tests/support/expect_stats.h"

namespace racebeam {
namespace {

constexpr int Crowded = 7223;  // heights of the open grid
constexpr int Flight = 3900;   // through portals, with an effect

unit_choices joined(const std::string& text, const knobs& k = {}) {
  unit_choices choices;
  const UseOption use(beam_engine(), k, nullptr);
  use.use(choices, text);
  use.join(choices);
  return choices;
}

/// The plug-ins of its islands, and how many units are in none.
std::pair<std::set<std::string>, int> islands_in(const unit_choices& choices) {
  std::set<std::string> plugins;
  int alone = 0;
  for (const auto& [unit, choice] : choices.by_unit) {
    if (!choice.island.empty()) plugins.insert(choice.island);
    else ++alone;
  }
  return {plugins, alone};
}

void expect_the_chip(const std::string& text, int frame, const knobs& k = {}) {
  SCOPED_TRACE("frame " + std::to_string(frame) + ", " + text);
  SignalBench bench({k, true, true, false, nullptr, joined(text, k)});
  bench.seek(frame);
  const auto got = bench.render();
  const auto expected = CoreBench(k, frame).render();
  EXPECT_EQ(got.picture.pins_crc, expected.pins_crc);
  expect_equal(*got.stats, expected.stats);
}

TEST(ChipIsland, AllUnitsAreOne) {
  const auto [islands, alone] = islands_in(joined("all=rtl"));
  EXPECT_EQ(islands.size(), 1u);
  EXPECT_EQ(alone, 0);
}

TEST(ChipIsland, UnitsThatDoNotTouchStayAlone) {
  const auto [islands, alone] = islands_in(joined("pwm_sound=rtl,stacks=rtl"));
  EXPECT_EQ(islands.size(), 0u);
  EXPECT_EQ(alone, 2);
}

TEST(ChipIsland, OfAllUnitsGivesThePinsAndCountersOfTheCores) {
  expect_the_chip("all=rtl", Crowded);
}

TEST(ChipIsland, OfAllUnitsInFlightGivesThePinsAndCountersOfTheCores) {
  expect_the_chip("all=rtl", Flight);
}

TEST(ChipIsland, OfTheTracerGivesThePinsAndCountersOfTheCores) {
  expect_the_chip("subdivider=rtl,decision_datapath=rtl,stacks=rtl", Crowded);
}

TEST(ChipIsland, WithAModelInTheMiddleGivesThePinsAndCountersOfTheCores) {
  expect_the_chip("all=rtl,decision_datapath=model", Crowded);
}

TEST(ChipIsland, WithBackDoorsGivesThePinsAndCountersOfTheCores) {
  expect_the_chip("sequencer=rtl,navigator=rtl,vga_timing=rtl", Flight);
}

TEST(ChipIsland, HasTheChipsKnobs) {
  knobs k;
  k.interval_stack_depth = 2;
  k.fifo_entries = 6;
  expect_the_chip("all=rtl", Crowded, k);
}

TEST(ChipIsland, OfOtherUnitsIsRefused) {
  unit_choices choices = joined("subdivider=rtl,stacks=rtl");
  const std::string plugin = choices.by_unit["stacks"].island;
  choices.by_unit["pwm_sound"] = {unit_choice::Rtl, false, "", plugin};
  choices.by_unit.erase("stacks");
  EXPECT_THROW(SignalBench({{}, false, false, false, nullptr, choices}), RtlError);
}

}  // namespace
}  // namespace racebeam
