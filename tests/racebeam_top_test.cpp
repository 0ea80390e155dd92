// Promises of rtl/racebeam_top.sv and rtl/tt_um_racebeam.sv: all RTL units together are the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sc/chip_core.h"
#include "tb/unit_bench.h"
#include "tests/own_rtl.h"

namespace racebeam {
namespace {

constexpr int LineClocks = 1600;

/// The pins of chip.
struct racebeam_top {
  static constexpr const char* unit_name = "racebeam_top";
  class pins : public sc_core::sc_module {
   public:
    in_port<1> clk_i{"clk_i"};
    in_port<1> rst_ni{"rst_ni"};
    in_port<3> speed_i{"speed_i"};
    in_port<1> no_interlace_i{"no_interlace_i"};
    out_port<8> uo_o{"uo_o"};
    out_port<1> pwm_o{"pwm_o"};

    explicit pins(const sc_core::sc_module_name& name) : sc_module(name) {}
  };
};

/// The pins of a Tiny Tapeout tile. The bench drives the clock as any pin.
struct tt_um_racebeam {
  static constexpr const char* unit_name = "tt_um_racebeam";
  class pins : public sc_core::sc_module {
   public:
    in_port<8> ui_in{"ui_in"};
    out_port<8> uo_out{"uo_out"};
    in_port<8> uio_in{"uio_in"};
    out_port<8> uio_out{"uio_out"};
    out_port<8> uio_oe{"uio_oe"};
    in_port<1> ena{"ena"};
    in_port<1> clk{"clk"};
    in_port<1> rst_n{"rst_n"};

    explicit pins(const sc_core::sc_module_name& name) : sc_module(name) {}
  };
};

// Every clock of both pins against the cores, from reset on.
void expect_pins_of_the_chip(const knobs& k, int clocks) {
  own_rtl<racebeam_top> top("dut");
  UnitBench bench(top);
  chip_core chip;
  bench["speed_i"].drive(k.speed);
  bench["no_interlace_i"].drive(!k.interlace);
  bench.clock(2);
  chip.clock(false, k);
  bench["rst_ni"].drive(1);
  auto& uo = bench["uo_o"];
  auto& pwm = bench["pwm_o"];
  bench.settle();
  for (int n = 0; n < clocks; ++n) {
    const auto pins = chip.clock(true, k);
    ASSERT_EQ(uo.value(), pins.uo) << "clock " << n;
    ASSERT_EQ(pwm.value(), pins.pwm) << "clock " << n;
    bench.clock();
  }
}

TEST(RacebeamTop, PinsAreTheChipsForThreeFrames) {
  expect_pins_of_the_chip({}, 3 * 525 * LineClocks);
}

// Two seconds of the demo; minutes.
TEST(RacebeamTop, DISABLED_PinsAreTheChipsForTwoSeconds) {
  expect_pins_of_the_chip({}, 120 * 525 * LineClocks);
}

TEST(RacebeamTop, PinsAreTheChipsAtFullSpeedWithoutInterlace) {
  knobs k;
  k.speed = 7;
  k.interlace = 0;
  expect_pins_of_the_chip(k, 525 * LineClocks);
}

// Contract 4: ui[2:0] speed, ui[3] no_interlace, uio[7] sound; nothing else has an effect.
TEST(TinyTapeoutTop, PinsAreTheChips) {
  knobs k;
  k.speed = 5;
  own_rtl<tt_um_racebeam> tile("dut");
  UnitBench bench(tile);
  chip_core chip;
  int n = 0;
  const auto clock = [&] {
    bench["ui_in"].drive((n * 37 & 0xf0) | k.speed);
    bench["uio_in"].drive(n * 61);
    bench["ena"].drive(n >> 3);
    for (const int level : {1, 0}) {
      bench["clk"].drive(level);
      bench.settle();
    }
    ++n;
  };
  clock();
  chip.clock(false, k);
  bench["rst_n"].drive(1);
  bench.settle();
  while (n < 330 * LineClocks) {
    const auto pins = chip.clock(true, k);
    ASSERT_EQ(bench["uo_out"].value(), pins.uo) << "clock " << n;
    ASSERT_EQ(bench["uio_out"].value(), pins.pwm << 7) << "clock " << n;
    ASSERT_EQ(bench["uio_oe"].value(), 0x80) << "clock " << n;
    clock();
  }
}

}  // namespace
}  // namespace racebeam
