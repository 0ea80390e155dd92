// Recorded port traffic goes into RTL without SystemC: what the model said is what the RTL says,
// and another value is found at its clock and port.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/port_traffic.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "sc/base/engine.h"
#include "tb/twin/bare_rtl.h"
#include "tb/twin/random_traffic.h"
#include "tb/twin/twins.h"

namespace racebeam {
namespace {

constexpr std::uint64_t Clocks = 3000;

class PortTrafficOfTheFifo : public testing::Test {
 protected:
  PortTrafficOfTheFifo() {
    RandomTraffic random(bench_, row_.inputs(k_, nullptr, "interval_fifo"), 1);
    for (std::uint64_t clock = 0; clock < Clocks; ++clock) {
      random.next();
      bench_.settle();
      traffic_.append(bench_);
      bench_.clock();
    }
  }
  BareRtl rtl() const { return {row_.plugins(k_, nullptr, false).own("interval_fifo"), traffic_}; }
  /// The number of a port.
  std::size_t port(const std::string& name) const {
    for (std::size_t n = 0; n < traffic_.ports.size(); ++n)
      if (traffic_.ports[n].name == name) return n;
    throw std::out_of_range(name);
  }

  const Twins& row_ = twins().front();
  const knob_values k_ = row_.engine.standard(nullptr);
  std::unique_ptr<sc_core::sc_module> model_ =
      row_.engine.unit("interval_fifo")->make("model", k_, nullptr);
  UnitBench bench_{*model_};
  PortTraffic traffic_ = traffic_of("interval_fifo", bench_);
};

TEST_F(PortTrafficOfTheFifo, RtlSaysWhatTheModelSaid) {
  ASSERT_EQ(traffic_.clocks(), Clocks);
  EXPECT_FALSE(rtl().run(traffic_, 0, Clocks));
}

TEST_F(PortTrafficOfTheFifo, RunsGoOnWhereTheLastOneEnded) {
  BareRtl one = rtl();
  EXPECT_FALSE(one.run(traffic_, 0, 1000));
  EXPECT_FALSE(one.run(traffic_, 1000, Clocks));
}

TEST_F(PortTrafficOfTheFifo, AnotherValueIsFoundAtItsClockAndPort) {
  const std::size_t output = port("display_o");
  std::uint64_t& value = traffic_.values[1234 * traffic_.ports.size() + output];
  value ^= 4;
  const auto found = rtl().run(traffic_, 0, Clocks);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->clock, 1234u);
  EXPECT_EQ(found->port, output);
  EXPECT_EQ(found->expected, value);
  EXPECT_EQ(found->got, value ^ 4);
}

TEST_F(PortTrafficOfTheFifo, OptionalPortsThatTheRtlLacksAreLeftOut) {
  PortTraffic::Port& half = traffic_.ports[port("display_half_o")];
  EXPECT_TRUE(half.optional);
  half.name = "no_such_port_o";
  EXPECT_FALSE(rtl().run(traffic_, 0, Clocks));
  half.optional = false;
  EXPECT_THROW(rtl(), RtlError);
}

TEST_F(PortTrafficOfTheFifo, PortsThatDoNotFitAreRefused) {
  ++traffic_.ports.front().bits;
  EXPECT_THROW(rtl(), RtlError);
  traffic_.ports.front().name = "no_such_port_i";
  EXPECT_THROW(rtl(), RtlError);
}

}  // namespace
}  // namespace racebeam
