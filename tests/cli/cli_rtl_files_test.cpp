// What users name as RTL on the command line: files, lists and folders, and what is said of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "tests/cli/cli_rtl_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(CliRtlTest, AnIncludeBesideTheFileIsFoundAndItsChangeIsSeen) {
  fs::create_directory(folder / "rtl");
  write("rtl/mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE"));
  write("rtl/one.svh", "`define ONE 1\n");
  expect(0, verify("stacks=rtl/mine.sv"));
  write("rtl/one.svh", "`define ONE 0\n");
  expect(1, verify("stacks=rtl/mine.sv"), "differs");
  write("rtl/one.svh", "`define ONE 1\n");
  expect(0, verify("stacks=rtl/mine.sv"));
}

TEST_F(CliRtlTest, AUnitMayBeSeveralFiles) {
  write("a.sv", stacks_with("one::One"));
  write("b.sv", "package one;\n  localparam int One = 1;\nendpackage\n");
  expect(0, verify("stacks=b.sv+a.sv"));
  expect(2, verify("stacks=a.sv"), "cannot be verilated");
  expect(2, verify("stacks=b.sv+none.sv"), "there is no file 'none.sv' for the unit stacks");
}

TEST_F(CliRtlTest, AModuleThatNoFileHasIsFoundBesideThem) {
  write("mine.sv", stacks_with("one"));
  std::string text = read_file(folder / "mine.sv");
  text.insert(text.rfind("endmodule"), "  wire [31:0] one;\n  the_one u_one (.one);\n");
  write("mine.sv", text);
  write("the_one.sv", "module the_one (output [31:0] one);\n  assign one = 1;\nendmodule\n");
  expect(0, verify("stacks=mine.sv"));
}

TEST_F(CliRtlTest, AListHasFilesFoldersAndDefines) {
  fs::create_directories(folder / "ip/inc");
  write("ip/mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE - `TWO"));
  write("ip/inc/one.svh", "`define ONE 3\n");
  write("ip/mine.f", "# my stacks\n+incdir+inc\n+define+TWO=2 // less\nmine.sv\n");
  expect(0, verify("stacks=ip/mine.f"));
  write("ip/mine.f", "-I inc -DTWO=3\nmine.sv\n");
  expect(1, verify("stacks=ip/mine.f"), "differs");
  write("ip/mine.f", "-I inc\n--two 3\nmine.sv\n");
  expect(2, verify("stacks=ip/mine.f"), "ip/mine.f:2: what is --two?");
}

TEST_F(CliRtlTest, ACommentInAListBeginsAWord) {
  fs::create_directory(folder / "ip");
  std::string text = stacks_with("one");
  text.insert(text.rfind("endmodule"), "  wire [31:0] one;\n  constant `SET u_one (.one);\n");
  write("ip/mine.sv", text +
                          "module constant #(parameter N = 0) (output [31:0] one);\n"
                          "  assign one = N;\nendmodule\n");
  write("ip/broken.sv", "module");
  write("mine.f", "+define+SET=#(1) # one\n#ip/none.sv\nip//mine.sv //none.sv\n// none.sv\n");
  expect(0, verify("stacks=mine.f"));
  write("mine.f", "-D # SET\n");
  expect(2, verify("stacks=mine.f"), "mine.f:1: -D of what?");
}

TEST_F(CliRtlTest, AFolderStandsForItsFiles) {
  fs::create_directory(folder / "ip");
  write("ip/a.sv", stacks_with("one_pkg::One"));
  write("ip/one_pkg.sv", "package one_pkg;\n  localparam int One = 1;\nendpackage\n");
  expect(0, verify("stacks=ip"));
}

TEST_F(CliRtlTest, AVectorThatFeedsItselfBitByBitIsAWarning) {
  std::string text = changed("stacks", "fread_o = '0;", "fread_o = chain[3] ? '1 : '0;");
  const auto at = text.find("  // The top is the entry below sp");
  ASSERT_NE(at, std::string::npos);
  const std::string line = std::to_string(std::count(text.begin(), text.begin() + at, '\n') + 1);
  text.insert(at, "  wire [3:0] chain = {chain[2:0] & {3{sp_i[0]}}, 1'b0};  // 0\n");
  write("mine.sv", text);
  const std::string warning =
      "warning: mine.sv:" + line +
      " stacks.chain: depends on itself without a register between, perhaps "
      "bit by bit; Verilator may compute it wrongly: break the vector into "
      "wires";
  expect(0, verify("stacks=mine.sv"), warning);
  expect(0, {"render", "demo", "--frames", "1", "--crc", "--use", "stacks=mine.sv"}, warning);
  Program own(folder.path(), verify("all"));
  EXPECT_EQ(own.wait(), 0) << own.err();
  EXPECT_THAT(own.err(), Not(HasSubstr("warning")));
}

TEST_F(CliRtlTest, VerilateMakesAPluginForOthersAndSaysWhatItRead) {
  write("mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE"));
  write("one.svh", "`define ONE 1\n");
  expect(0, {"verilate", "stacks", "mine.sv", "-o", "mine.so", "--depfile", "mine.d"});
  const std::string rule = read_file(folder / "mine.d");
  EXPECT_EQ(rule.rfind("mine.so: ", 0), 0u) << rule;
  EXPECT_THAT(rule, HasSubstr("/one.svh"));
  expect(0, verify("stacks=mine.so"));
  expect(2, {"verilate", "stacks", "none.sv", "-o", "mine.so"}, "there is no file 'none.sv'");
}

TEST_F(CliRtlTest, NinjaReadsTheDepfileWhateverTheNamesAre) {
  fs::create_directory(folder / "my $x #1");
  write("my $x #1/mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE"));
  write("my $x #1/one.svh", "`define ONE 1\n");
  write("build.ninja",
        "rule rtl\n  command = '" RACEBEAM_BINARY
        "' verilate stacks 'my $$x #1/mine.sv' -o $out --depfile mine.d\n  depfile = mine.d\n"
        "build my$ $$o#.so: rtl\n");
  const auto ninja = [&] {
    const std::string command = "cd '" + folder.path() + "' && ninja >said 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "said");
    return read_file(folder / "said");
  };
  EXPECT_THAT(ninja(), HasSubstr("[1/1]"));
  EXPECT_TRUE(fs::exists(folder / "my $o#.so"));
  EXPECT_THAT(ninja(), HasSubstr("no work to do"));
  const fs::path include = folder / "my $x #1/one.svh";
  fs::last_write_time(include, fs::last_write_time(folder / "my $o#.so") + std::chrono::seconds(2));
  EXPECT_THAT(ninja(), HasSubstr("[1/1]"));
}

}  // namespace
}  // namespace racebeam
