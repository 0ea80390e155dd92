// Promises of tb/wave/vcd_writer.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/vcd_writer.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "tests/support/scratch_folder.h"

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
            "#0\n$dumpvars\n1!\nb100000101 \"\n$end\n"
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

TEST(VcdWriter, SignalsHaveSeveralNamesAndWords) {
  VcdWriter vcd;
  const int wire = vcd.add("chip", "i2", 10);
  vcd.alias("chip.u_subdivider", "i2_o", wire);
  const int state = vcd.add_text("chip", "state_name");
  vcd.change(0, wire, 5);
  vcd.change(0, state, "ray pattern");
  vcd.change(7, state, "ray pattern");
  EXPECT_EQ(vcd.text("", 9),
            "$comment  $end\n$timescale 1 ps $end\n$scope module chip $end\n"
            "$var wire 10 ! i2 [9:0] $end\n$var string 1 \" state_name $end\n"
            "$scope module u_subdivider $end\n$var wire 10 ! i2_o [9:0] $end\n"
            "$upscope $end\n$upscope $end\n$enddefinitions $end\n"
            "#0\n$dumpvars\nb101 !\nsray_pattern \"\n$end\n#9\n");
}

TEST(VcdWriter, NoNameOfASceneEndsTheCommentOrAWord) {
  VcdWriter vcd;
  const int part = vcd.add_text("beam", "part");
  vcd.change(0, part, "a\tb\nc d");
  EXPECT_EQ(vcd.text("a $end b\n$var", 1),
            "$comment a _end b__var $end\n$timescale 1 ps $end\n$scope module beam $end\n"
            "$var string 1 ! part $end\n$upscope $end\n$enddefinitions $end\n"
            "#0\n$dumpvars\nsa_b_c_d !\n$end\n#1\n");
}

TEST(VcdWriter, AStreamedFileIsTheText) {
  const ScratchFolder folder;
  VcdWriter whole, streamed;
  OutputFile file(folder / "s.vcd");
  streamed.stream(file, "both");
  for (VcdWriter* vcd : {&whole, &streamed}) {
    const int count = vcd->add("chip", "count", 16);
    for (unsigned n = 0; n < 20000; ++n) vcd->change(2 * n, count, n);
  }
  streamed.finish(40000);
  file.commit();
  std::ifstream in(folder / "s.vcd");
  const std::string got{std::istreambuf_iterator<char>(in), {}};
  EXPECT_GT(got.size(), 400000u);
  EXPECT_TRUE(got == whole.text("both", 40000));
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
