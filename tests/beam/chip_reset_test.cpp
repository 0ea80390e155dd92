// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "sc/beam/chip.h"
#include "tb/bench/core_bench.h"
#include "tb/monitor/pin_probe.h"

namespace racebeam {
namespace {

const sc_core::sc_time Period(19841, sc_core::SC_PS);

/// The chip with its reset pin in the test's hand; clock 0 is the first after the second reset.
struct ChipReset : testing::TestWithParam<int> {
  static constexpr int ResetClocks = 3;
  const int first_run = GetParam();

  sc_core::sc_clock clk{"clk", Period};
  wire<1> rst_n{"rst_n"}, no_interlace{"no_interlace"}, pwm{"pwm"};
  wire<3> speed{"speed"};
  wire<8> uo{"uo"};
  chip dut{"chip", knobs{}};
  std::vector<VgaFrame> frames;
  VgaMonitor monitor{Raster(), [this](const VgaFrame& f) { frames.push_back(f); }, {true, true}};
  PinProbe probe{"probe", (first_run + ResetClocks) * Period, Period, &monitor};

  ChipReset() {
    dut.clk_i(clk);
    dut.rst_ni(rst_n);
    dut.speed_i(speed);
    dut.no_interlace_i(no_interlace);
    dut.uo_o(uo);
    dut.pwm_o(pwm);
    probe.uo_i(uo);
    probe.pwm_i(pwm);
  }
  /// Stands in the first quarter of a clock before and after.
  void run(int clocks) { sc_core::sc_start(clocks * Period); }
};

// In the middle of the camera's work, of tracing, of a stall, of the navigator's flight.
INSTANTIATE_TEST_SUITE_P(Clocks, ChipReset,
                         testing::Values(17, 1600 * 300 + 60, 1600 * 300 + 400, 1600 * 301 + 1590,
                                         840000 - 1600 + 322, 840000 + 1600 * 200 + 777));

TEST_P(ChipReset, ResetInTheMiddleStartsTheDemoAnew) {
  sc_core::sc_start(Period / 4);
  rst_n.write(true);
  run(first_run);
  rst_n.write(false);
  run(ResetClocks);
  rst_n.write(true);
  run(2 * 840000 + 1);
  probe.advance();
  ASSERT_EQ(frames.size(), 2u);
  // vsync keeps its level through reset (contract 5.3), so the pins of frame 0 may differ for 224
  // clocks; its picture is that of frame 1.
  CoreBench reference({}, 1);
  EXPECT_EQ(frames[1].pins_crc, reference.render().pins_crc);
  EXPECT_EQ(frames[0].image_crc, frames[1].image_crc);
}

}  // namespace
}  // namespace racebeam
