// Plug-ins: registers power up as asked, and assertions are looked at when inputs have settled.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_power_up.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <set>
#include <string>

#include "sc/swap/rtl_library.h"
#include "tests/support/rtl_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

class RtlPowerUpTest : public RtlBench {
 protected:
  static std::uint32_t powered(const std::string& plugin, rtl_power_up start) {
    const RtlPowerUp now(start);
    rtl_library rtl(plugin);
    return out(rtl);
  }
};

TEST_F(RtlPowerUpTest, RegistersPowerUpAsAsked) {
  const std::string rtl =
      plugin("logic [31:0] q; always_ff @(posedge clk_i) q <= q + 32'(a_i); assign out_o = q;");
  EXPECT_EQ(powered(rtl, {RtlZeros, 0}), 0u);
  EXPECT_EQ(powered(rtl, {RtlOnes, 0}), 0xffffffffu);
  std::set<std::uint32_t> values;
  for (int seed = 1; seed <= 20; ++seed) {
    values.insert(powered(rtl, {RtlRandom, seed}));
    EXPECT_EQ(powered(rtl, {RtlRandom, seed}), powered(rtl, {RtlRandom, seed})) << seed;
  }
  EXPECT_EQ(values.size(), 20u);
  rtl_library usual(rtl);
  EXPECT_EQ(out(usual), 0u) << "only while an RtlPowerUp lives";
}

TEST_F(RtlPowerUpTest, WhatAnInitialBlockWritesIsNotRandom) {
  const std::string rtl = plugin(
      "logic [31:0] q = 32'd1234; always_ff @(posedge clk_i) q <= q + 32'(a_i); assign out_o = q;");
  for (const rtl_power_up start : {rtl_power_up{RtlOnes, 0}, rtl_power_up{RtlRandom, 5}})
    EXPECT_EQ(powered(rtl, start), 1234u);
}

TEST_F(RtlPowerUpTest, TheClockCountsFromAnyPowerUp) {
  const std::string rtl =
      plugin("logic [31:0] q; always_ff @(posedge clk_i) q <= q + 32'(a_i); assign out_o = q;");
  for (int seed = 1; seed <= 10; ++seed) {
    const RtlPowerUp now({RtlRandom, seed});
    rtl_library mine(rtl);
    const std::uint32_t begin = out(mine);
    put(mine, "a_i", 3);
    mine.eval();
    for (int clock = 1; clock <= 4; ++clock) {
      mine.rise();
      EXPECT_EQ(out(mine), begin + 3 * static_cast<std::uint32_t>(clock)) << seed;
    }
  }
}

constexpr const char* Equal =
    "always_comb begin out_o = 0; assert (a_i == b_i) else $error(\"they differ\"); end\n"
    "logic seen; always_ff @(posedge clk_i) seen <= a_i[0];";

TEST_F(RtlPowerUpTest, InputsOnTheirWayFailNoAssertion) {
  rtl_library mine(plugin(Equal));
  for (int clock = 0; clock < 4; ++clock) {
    put(mine, "a_i", static_cast<std::uint8_t>(clock));
    EXPECT_NO_THROW(mine.eval());
    put(mine, "b_i", static_cast<std::uint8_t>(clock));
    mine.eval();
    EXPECT_NO_THROW(mine.rise());
  }
}

TEST_F(RtlPowerUpTest, SettledInputsFailTheAssertionAtTheEdge) {
  rtl_library mine(plugin(Equal));
  mine.eval();
  mine.rise();
  put(mine, "a_i", 1);
  mine.eval();
  try {
    mine.rise();
    FAIL() << "it has to be told";
  } catch (const RtlFault& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("in clock 1: "));
    EXPECT_THAT(fault.what(), HasSubstr("mine.sv:4: error: they differ"));
  }
}

TEST_F(RtlPowerUpTest, AssertionsWithoutAClockAreToldAtTheEndOfAClock) {
  rtl_library mine(plugin("always_comb begin out_o = 0; assert (a_i == b_i); end"));
  mine.eval();
  EXPECT_NO_THROW(mine.rise());
  put(mine, "a_i", 1);
  EXPECT_NO_THROW(mine.eval());
  EXPECT_THROW(mine.rise(), RtlFault);
}

TEST_F(RtlPowerUpTest, PropertiesAreChecked) {
  rtl_library mine(
      plugin("assign out_o = 0; assert property (@(posedge clk_i) a_i < 8'd3) else "
             "$error(\"three\");"));
  for (const std::uint8_t value : {0, 1, 2}) {
    put(mine, "a_i", value);
    mine.eval();
    EXPECT_NO_THROW(mine.rise());
  }
  put(mine, "a_i", 3);
  mine.eval();
  EXPECT_THROW(mine.rise(), RtlFault);
}

}  // namespace
}  // namespace racebeam
