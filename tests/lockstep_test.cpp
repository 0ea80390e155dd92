// The comparison of model and RTL tells every wrong bit, at its clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/lockstep.h"

#include <gtest/gtest.h>

#include "sc/stacks.h"
#include "tb/random_traffic.h"
#include "tb/unit_bench.h"

namespace racebeam {
namespace {

class LockstepTest : public testing::Test {
 protected:
  void run(std::uint64_t clocks) {
    bench.between_edges([this] { traffic.next(); });
    bench.clock(static_cast<int>(clocks));
  }

  stacks model{"model", knobs{}};
  Lockstep lockstep{"lockstep", "stacks", model, knobs{}, ""};
  UnitBench bench{model, &lockstep.clk_i};
  RandomTraffic traffic{bench, {}, 7};
};

TEST_F(LockstepTest, ModelAndRtlOfStacksAgreeOnRandomTraffic) {
  run(20000);
  EXPECT_EQ(lockstep.clocks(), 20000u);
  EXPECT_EQ(lockstep.differences(), 0u);
  EXPECT_FALSE(lockstep.first());
}

TEST_F(LockstepTest, TellsAnInvertedBitAndItsClock) {
  lockstep.invert("top_i2_o", 9, 1234);
  run(2000);
  EXPECT_EQ(lockstep.differences(), 1u);
  ASSERT_TRUE(lockstep.first());
  const LockstepDifference& first = *lockstep.first();
  EXPECT_EQ(first.unit, "stacks");
  EXPECT_EQ(first.port, "top_i2_o");
  EXPECT_EQ(first.clock, 1234u);
  EXPECT_EQ(first.expected ^ first.got, 1 << 9);
  EXPECT_EQ(first.history.size(), std::size_t{LockstepDifference::Window});
  EXPECT_EQ(first.history.back().size(), first.columns.size());
}

TEST_F(LockstepTest, RefusesOutputsThatTheRtlDoesNotHave) {
  EXPECT_THROW(lockstep.invert("sp_o", 0, 1), RtlError);
}

}  // namespace
}  // namespace racebeam
