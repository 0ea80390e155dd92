// Promises of rtl/beam/racebeam_top.sv and rtl/beam/tt_um_racebeam.sv: all RTL units together are
// the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "sc/beam/chip_core.h"
#include "sc/beam/engine.h"
#include "sc/swap/rtl_library.h"
#include "tb/base/project_folder.h"
#include "tb/twin/unit_bench.h"
#include "tb/verilate/rtl_syntax.h"
#include "tests/support/own_rtl.h"

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

// Every clock of both pins against the cores, from reset on.
void expect_pins_of_the_chip(const knobs& k, int clocks) {
  own_rtl<racebeam_top> top("dut", k);
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

std::map<std::string, std::string> parameters_of(const std::string& module) {
  std::map<std::string, std::string> parameters;
  for (const auto& one :
       read_rtl_syntax({module, {rtl_file(module)}, {}, {}, {}, {}, RtlSources::Unit, false})
           .parameters)
    parameters[one.name] = one.value;
  return parameters;
}

// By default each is that of the chip: UnitSourcesTest holds those of the units to the knobs.
TEST(RacebeamTop, HasTheParametersOfItsUnits) {
  std::map<std::string, std::string> of_units;
  for (const std::string& unit : beam_engine().unit_names(false))
    for (const auto& [name, value] : parameters_of(unit)) {
      const auto [at, fresh] = of_units.emplace(name, value);
      EXPECT_EQ(at->second, value) << unit << " " << name;
    }
  EXPECT_EQ(parameters_of("racebeam_top"), of_units);
}

TEST(RacebeamTop, PinsAreTheChipsWithOtherKnobs) {
  knobs k;
  k.interval_stack_depth = 2;
  k.face_stack_depth = 6;
  k.max_room_depth = 4;
  k.fifo_entries = 7;
  k.fifo_short_length_bits = 5;
  k.hurry_threshold = -1;
  k.dr_bits = 9;
  k.corner_bits = 13;
  k.corner_factor_bits = 7;
  k.partial_products_cut = 3;
  k.bisection = 1;
  k.stepping = 1;
  k.dithering = DitheringCheckered;
  k.skip_shared_edges = SharedEdgesTable;
  k.head_start = 40;
  k.stepping_fraction_bits = 5;
  k.ddr_fraction_bits = 7;
  k.corner_rounding = 1;
  k.fifo_merge = 0;
  expect_pins_of_the_chip(k, 525 * LineClocks);
}

TEST(RacebeamTop, PinsAreTheChipsForThreeFrames) {
  expect_pins_of_the_chip({}, 3 * 525 * LineClocks);
}

TEST(LongRacebeamTop, PinsAreTheChipsForTwoSecondsOfTheDemo) {
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
  rtl_library tile(beam_plugins(k).own("tt_um_racebeam"));
  const auto pin = [&](const char* name) -> std::uint8_t& {
    return *static_cast<std::uint8_t*>(rtl_port_of(tile.model(), name).data);
  };
  chip_core chip;
  int n = 0;
  const auto clock = [&] {
    pin("ui_in") = static_cast<std::uint8_t>((n * 37 & 0xf0) | k.speed);
    pin("uio_in") = static_cast<std::uint8_t>(n * 61);
    pin("ena") = n >> 3 & 1;
    tile.eval();
    tile.rise();
    ++n;
  };
  clock();
  chip.clock(false, k);
  pin("rst_n") = 1;
  tile.eval();
  while (n < 330 * LineClocks) {
    const auto pins = chip.clock(true, k);
    ASSERT_EQ(pin("uo_out"), pins.uo) << "clock " << n;
    ASSERT_EQ(pin("uio_out"), pins.pwm << 7) << "clock " << n;
    ASSERT_EQ(pin("uio_oe"), 0x80) << "clock " << n;
    clock();
  }
}

}  // namespace
}  // namespace racebeam
