// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/pin_probe.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "sc/video/vga_timing.h"

namespace racebeam {
namespace {

const sc_core::sc_time Period(19841, sc_core::SC_PS);

/// The raster on its pins, without pictures; from one clock on with hsync stuck at 1.
class SyncSource : public sc_core::sc_module {
 public:
  in_port<1> clk_i{"clk_i"};
  out_port<8> uo_o{"uo_o"};

  SyncSource(const sc_core::sc_module_name& name, long stuck_from)
      : sc_module(name), stuck_from_(stuck_from) {
    SC_HAS_PROCESS(SyncSource);
    SC_METHOD(seq);
    sensitive << clk_i.pos();
    dont_initialize();
  }

 private:
  void seq() {
    constexpr int clocks_per_pixel = 2;
    if (++clock_ > 0) raster_.clock({true, 0}, clocks_per_pixel);
    const auto o = raster_.comb({true, 0}, clocks_per_pixel);
    uo_o.drive((o.hsync_n || clock_ >= stuck_from_) << 7 | o.vsync_n << 3);
  }

  const long stuck_from_;
  long clock_ = -1;
  vga_timing_core raster_;
};

class PinProbeTest : public testing::Test {
 protected:
  void build(long stuck_from) {
    source_ = std::make_unique<SyncSource>("source", stuck_from);
    source_->clk_i(clk_);
    source_->uo_o(uo_);
    probe_.uo_i(uo_);
    probe_.pwm_i(pwm_);
  }
  void run_frames(int frames) { sc_core::sc_start(frames * 840000 * Period); }

  sc_core::sc_clock clk_{"clk", Period};
  wire<8> uo_{"uo"};
  wire<1> pwm_{"pwm"};
  VgaMonitor monitor_{Raster(), [](const VgaFrame&) {}};
  PinProbe probe_{"probe", sc_core::SC_ZERO_TIME, Period, &monitor_};
  std::unique_ptr<SyncSource> source_;
};

TEST_F(PinProbeTest, GoodFramesReachTheMonitor) {
  build(1L << 40);
  run_frames(2);
  probe_.advance();
  EXPECT_EQ(monitor_.frames(), 2u);
}

TEST_F(PinProbeTest, MonitorsErrorComesOutOfAdvanceWithThePlace) {
  build(840000 + 2 * 1600);
  run_frames(2);
  try {
    probe_.advance();
    FAIL() << "the fault was not seen";
  } catch (const SyncError& error) {
    EXPECT_NE(std::string(error.what()).find("frame 1, line -271"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace racebeam
