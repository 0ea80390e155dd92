// Promises of tb/vcd_writer.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/vcd_writer.h"

#include <gtest/gtest.h>

#include <set>

namespace racebeam {
namespace {

TEST(VcdWriter, WritesScopesSignalsAndChanges) {
  VcdWriter vcd;
  const int clk = vcd.add("chip", "clk_i", 1);
  const int tag = vcd.add("chip.u_stacks", "tag_i", 9);
  const int rst = vcd.add("chip", "rst_ni", 1);
  const int seen = vcd.add("chip.u_scene.deep", "seen", 2);
  vcd.change(0, clk, 1);
  vcd.change(0, tag, 0x105);
  vcd.change(10, clk, 0);
  vcd.change(10, rst, 0);
  vcd.change(20, tag, 0x105);
  vcd.change(25, seen, 2);
  EXPECT_EQ(vcd.text("made by hand", 30),
            "$comment made by hand $end\n"
            "$timescale 1 ps $end\n"
            "$scope module chip $end\n"
            "$var wire 1 ! clk_i $end\n"
            "$var wire 1 # rst_ni $end\n"
            "$scope module u_scene $end\n"
            "$scope module deep $end\n"
            "$var wire 2 $ seen [1:0] $end\n"
            "$upscope $end\n"
            "$upscope $end\n"
            "$scope module u_stacks $end\n"
            "$var wire 9 \" tag_i [8:0] $end\n"
            "$upscope $end\n"
            "$upscope $end\n"
            "$enddefinitions $end\n"
            "#0\n1!\nb100000101 \"\n"
            "#10\n0!\n0#\n"
            "#25\nb10 $\n"
            "#30\n");
}

TEST(VcdWriter, ThousandsOfSignalsHaveCodesOfTheirOwn) {
  VcdWriter vcd;
  for (int n = 0; n < 10000; ++n) vcd.add("chip", "s" + std::to_string(n), 1);
  const std::string text = vcd.text("", 0);
  std::set<std::string> codes;
  for (std::size_t at = text.find("$var"); at != std::string::npos; at = text.find("$var", at + 1))
    codes.insert(text.substr(at + 12, text.find(' ', at + 12) - at - 12));
  EXPECT_EQ(codes.size(), 10000u);
}

TEST(VcdWriter, RefusesWhatNoViewerCouldShow) {
  VcdWriter vcd;
  EXPECT_THROW(vcd.add("chip", "wide", 65), std::invalid_argument);
  EXPECT_THROW(vcd.add("chip", "none", 0), std::invalid_argument);
  const int s = vcd.add("chip", "s", 64);
  vcd.change(10, s, ~std::uint64_t{0});
  EXPECT_THROW(vcd.change(9, s, 1), std::logic_error);
  EXPECT_THROW(vcd.add("chip", "late", 1), std::logic_error);
}

}  // namespace
}  // namespace racebeam
