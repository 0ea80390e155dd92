// The cells against functions that are written here once more, all verilated together.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/sky130_cells.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/verilate/rtl_plugin.h"
#include "tests/support/scratch_folder.h"
#include "tests/tt/sky130_functions.h"

namespace racebeam {
namespace {

using namespace sky130;

using Words = std::vector<std::string>;
/// A plug-in of RTL, with the cells at hand.
class WithCells {
 public:
  explicit WithCells(const std::string& text) {
    std::ofstream(folder_ / "top.v") << text;
    std::ofstream(folder_ / "cells.v") << sky130_library();
    RtlSources sources;
    sources.top = "top";
    sources.files = {folder_ / "top.v"};
    sources.libraries = {folder_ / "cells.v"};
    library_ = std::make_unique<rtl_library>(rtl_plugin(sources));
  }
  std::uint64_t get(const std::string& port) const {
    const rtl_port& at = rtl_port_of(library_->model(), port.c_str());
    std::uint64_t value = 0;
    std::memcpy(&value, at.data, at.bytes);
    return value;
  }
  void set(const std::string& port, std::uint64_t value) {
    const rtl_port& at = rtl_port_of(library_->model(), port.c_str());
    std::memcpy(at.data, &value, at.bytes);
  }
  void eval() { library_->model().eval(library_->model().top); }
  void rise() { library_->model().rise(library_->model().top); }

 private:
  ScratchFolder folder_;
  std::unique_ptr<rtl_library> library_;
};

TEST(Sky130Cells, EachDoesWhatItsNameSays) {
  const std::vector<Sky130Cell>& cells = sky130_cells();
  std::string ports, instances;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    const Sky130Cell& cell = cells[n];
    Words pins;
    for (std::size_t pin = 0; pin < cell.outputs.size(); ++pin)
      pins.push_back(fmt::format(".{}(out_{}[{}])", cell.outputs[pin], n, pin));
    for (std::size_t pin = 0; pin < cell.inputs.size(); ++pin)
      pins.push_back(fmt::format(".{}(in[{}])", cell.inputs[pin], pin));
    if (n % 2 == 0)  // others leave the supplies open
      for (const char* supply : {".VPWR(1'b1)", ".VGND(1'b0)", ".VPB(1'b1)", ".VNB(1'b0)"})
        pins.emplace_back(supply);
    if (!cell.outputs.empty())
      ports += fmt::format(", output [{}:0] out_{}", cell.outputs.size() - 1, n);
    const int strengths[] = {1, 2, 4, 8, 16};
    instances += fmt::format("{} u_{} ({});\n", sky130_module_name(cell.name, strengths[n % 5]), n,
                             fmt::join(pins, ", "));
  }
  WithCells rtl("module top (input [5:0] in" + ports + ");\n" + instances + "endmodule\n");

  std::vector<char> states(cells.size(), 0);
  std::mt19937 random(1);
  unsigned now = 0x3f, before = 0x3f;
  bool known = false;  // registers have seen their clock, reset or set
  for (int step = 0; step < 5'000; ++step) {
    rtl.set("in", now);
    rtl.eval();
    for (std::size_t n = 0; n < cells.size(); ++n) {
      if (cells[n].outputs.empty()) continue;
      bool q = states[n];
      const unsigned right = expected(cells[n], now, before, q);
      states[n] = q;
      const std::uint64_t seen = rtl.get(fmt::format("out_{}", n));
      if (!known && !family(cells[n].name).empty()) states[n] = seen & 1;
      else ASSERT_EQ(seen, right) << cells[n].name << ", inputs " << now << ", step " << step;
    }
    known = step >= 100;
    before = now;
    now ^= 1u << random() % 6;  // one at a time: no races
  }
}

TEST(Sky130Cells, HavePinsInTheLibrarysOrder) {
  for (const Sky130Cell& cell : sky130_cells())
    if (const auto at = functions().find(cell.name); at != functions().end()) {
      Words pins = cell.outputs;
      pins.insert(pins.end(), cell.inputs.begin(), cell.inputs.end());
      EXPECT_EQ(fmt::format("{}", fmt::join(pins, " ")), at->second.first) << cell.name;
    }
}

TEST(Sky130Cells, GatedClockTakesWhatWasThereBeforeTheEdge) {
  WithCells rtl(
      "module top (input clk, input enable, output reg [7:0] free, output [7:0] gated);\n"
      "wire gclk;\n"
      "always @(posedge clk) free <= free + 1;\n"
      "sky130_fd_sc_hd__dlclkp_4 gate (gclk, enable, clk);\n"
      "sky130_fd_sc_hd__dfxtp_2 bits[7:0] (.Q(gated), .CLK(gclk), .D(free));\n"
      "endmodule\n");
  std::mt19937 random(2);
  std::uint64_t gated = 0;
  for (int clock = 0; clock < 1000; ++clock) {
    const bool enable = random() % 2;
    rtl.set("enable", enable);
    rtl.eval();
    if (enable) gated = rtl.get("free");
    rtl.rise();
    ASSERT_EQ(rtl.get("free"), (clock + 1) % 256u);
    if (clock == 0 && !enable) gated = rtl.get("gated");
    ASSERT_EQ(rtl.get("gated"), gated) << clock;
  }
}

TEST(Sky130Cells, ProjectsOwnCellComesFirst) {
  WithCells rtl(
      "module top (input a, output y); sky130_fd_sc_hd__inv_1 u (.A(a), .Y(y)); endmodule\n"
      "module sky130_fd_sc_hd__inv_1 (output Y, input A); assign Y = A; endmodule\n");
  rtl.set("a", 1);
  rtl.eval();
  EXPECT_EQ(rtl.get("y"), 1u);
}

}  // namespace
}  // namespace racebeam
