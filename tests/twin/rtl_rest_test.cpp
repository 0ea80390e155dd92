// Clocks that are left out of verilated RTL: only such that change nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_rest.h"

#include <gtest/gtest.h>

#include "sc/swap/rtl_run.h"
#include "tests/support/rtl_bench.h"

namespace racebeam {
namespace {

class RtlRestTest : public RtlBench {
 protected:
  /// Clocks with still inputs after which each further one would be left out; 0: none in 1,000.
  static int clocks_to_rest(rtl_library& rtl) {
    rtl_rest rest;
    for (int clock = 1; clock <= 1000; ++clock) {
      rtl.rise();
      rest.look(rtl.model(), false);
      if (rest.now()) return clock;
    }
    return 0;
  }
  int clocks_to_rest(const std::string& body) {
    rtl_library rtl(plugin(body));
    rtl.eval();
    return clocks_to_rest(rtl);
  }
};

TEST_F(RtlRestTest, RegistersThatAClockDoesNotChangeRest) {
  EXPECT_EQ(clocks_to_rest("always_ff @(posedge clk_i) out_o <= 32'(a_i);"), 2);
}

TEST_F(RtlRestTest, NothingRestsThatStillCountsInside) {
  const int clocks = clocks_to_rest(
      "logic [6:0] n = 0; always_ff @(posedge clk_i) if (!n[6]) n <= n + 1;\n"
      "assign out_o = 32'(n[6]);");
  EXPECT_GT(clocks, 65);
  EXPECT_LT(clocks, 200);
}

TEST_F(RtlRestTest, ARegisterThatTogglesNeverRests) {
  EXPECT_EQ(clocks_to_rest("logic q = 0; always_ff @(posedge clk_i) q <= !q;\n"
                           "assign out_o = 32'(q & a_i[0]);"),
            0);
}

TEST_F(RtlRestTest, NothingRestsThatSpeaks) {
  int lines = 0;
  const RtlListener listener([&lines](const std::string&) { return ++lines > 0; });
  EXPECT_EQ(clocks_to_rest("assign out_o = 0; always_ff @(posedge clk_i) $display(\"here\");"), 0);
  EXPECT_GE(lines, 1000);
}

TEST_F(RtlRestTest, NothingRestsThatHasStateElsewhere) {
  rtl_library rtl(
      plugin("logic [31:0] q; always_ff @(posedge clk_i) q <= $urandom() >> 31;\n"
             "assign out_o = q & 32'(a_i);"));
  EXPECT_EQ(rtl.model().rests, nullptr);
  EXPECT_EQ(clocks_to_rest(rtl), 0);
}

TEST_F(RtlRestTest, AMoveOfAnInputEndsIt) {
  rtl_library rtl(plugin("always_ff @(posedge clk_i) out_o <= 32'(a_i);"));
  rtl.eval();
  rtl_rest rest;
  for (int clock = 0; clock < 5; ++clock) {
    rtl.rise();
    rest.look(rtl.model(), false);
  }
  ASSERT_TRUE(rest.now());
  put(rtl, "a_i", 7);
  rest.end();
  rtl.eval();
  EXPECT_FALSE(rest.now());
  rtl.rise();
  EXPECT_EQ(out(rtl), 7u);
  rest.look(rtl.model(), true);
  EXPECT_FALSE(rest.now());
}

}  // namespace
}  // namespace racebeam
