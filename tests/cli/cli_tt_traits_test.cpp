// `racebeam render --tt` with the traits of strangers' projects: other clocks, modes and folders,
// cells of the process, faults of the picture, and RTL that is not to be trusted.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/program.h"
#include "tests/support/read_picture.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

const std::string Bars = RACEBEAM_SOURCE_DIR "/tests/tt/bars";
const std::string Svga = RACEBEAM_SOURCE_DIR "/tests/tt/svga";

class CliTtTraitsTest : public testing::Test {
 protected:
  CliTtTraitsTest() { fs::copy(Bars, folder / "bars", fs::copy_options::recursive); }

  void write(const std::string& file, const std::string& text) {
    fs::create_directories((folder / file).substr(0, (folder / file).rfind('/')));
    std::ofstream(folder / file) << text;
  }
  /// Changes one place of a file of the bars.
  void change(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = read_file(folder / ("bars/" + file));
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write("bars/" + file, text.replace(at, from.size(), to));
  }
  void reset_bars() {
    fs::remove_all(folder / "bars");
    fs::copy(Bars, folder / "bars", fs::copy_options::recursive);
  }
  /// Renders the bars: exit code, what is said, and what is not.
  void expect_bars(const Words& more, int code, const Words& said, const std::string& unsaid = "") {
    Words words = {"render", "--tt", "bars", "--json", "--crc", "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), code) << run.err();
    for (const std::string& text : said) EXPECT_THAT(run.err(), HasSubstr(text));
    if (!unsaid.empty()) {
      EXPECT_THAT(run.err(), Not(HasSubstr(unsaid)));
    }
    stats = run.out().empty() ? Json() : Json::parse(run.out());
  }
  /// The bars with a line of Verilog in their top module are refused, where `said` is in it, and
  /// with a line before it, if there is one.
  void expect_distrust(const std::string& line, const std::string& said,
                       const std::string& before = "") {
    reset_bars();
    change("src/tt_um_bars.v", "  assign uio_oe", "  " + line + "\n  assign uio_oe");
    if (!before.empty())
      change("src/tt_um_bars.v", "`default_nettype none", "`default_nettype none " + before);
    const std::string place = before.empty() ? "38" : "5";
    expect_bars(
        {}, 2,
        {"bars/src/tt_um_bars.v:" + place + ": ", said, "; --trust if you trust this project"});
    EXPECT_FALSE(fs::exists(folder / "touched"));
  }

  ScratchFolder folder;
  Json stats;
};

TEST_F(CliTtTraitsTest, ClocksAreReadAsYamlWritesThemOrAssumed) {
  change("info.yaml", "25175000", "25_175_000");
  expect_bars({}, 0, {}, "assumed");
  EXPECT_EQ(stats["chip"]["clock_hz"], 25175000);
  const auto crc = stats["frames"][0]["pins_crc32"];
  change("info.yaml", "25_175_000", "0");
  expect_bars({}, 0,
              {"info.yaml names no clock; assumed 25200000 Hz, since a line has 800 clocks"});
  EXPECT_EQ(stats["chip"]["clock_assumed"], true);
  EXPECT_EQ(stats["frames"][0]["pins_crc32"], crc);
  change("info.yaml", "  clock_hz: 0\n", "");
  expect_bars({"--clock-hz", "24000000"}, 0, {}, "assumed");
  EXPECT_EQ(stats["chip"]["clock_hz"], 24000000);
  EXPECT_NEAR(stats["syncs"]["frames_per_second"].get<double>(), 57.14, 0.01);
}

TEST_F(CliTtTraitsTest, OtherModesAreNamedAndDrawnWhole) {
  Program run(folder.path(), {"render", "--tt", Svga, "--gif", "a.gif", "--sheet", "a.png", "-o",
                              "out", "--json"});
  ASSERT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.err(), HasSubstr("src/config.json defines EDGE=6'd12"));
  EXPECT_EQ(run.json()["syncs"]["mode"], "800x600 at 60 Hz");
  EXPECT_EQ(run.json()["chip"]["clock_hz"], 40000000) << "40_000_000";
  const Picture picture = read_picture(folder / "out/frame_0000.png");
  ASSERT_EQ(picture.size(), 800u * 600);
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 800; ++x) {
      const bool edge = x == 0 || x == 799 || y == 0 || y == 599;
      ASSERT_EQ(picture[y * 800 + x], edge                      ? 12
                                      : (x / 100 + y / 100) % 2 ? 48
                                                                : 3)
          << x << " " << y;
    }
  EXPECT_TRUE(fs::exists(folder / "a.gif"));
}

TEST_F(CliTtTraitsTest, ModesWithoutANameAreDrawn) {
  Program run(folder.path(), {"render", "--tt", Svga, "--define", "H_BACK=188", "--json"});
  ASSERT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.err(), HasSubstr("1156 clocks by 628 lines are no mode with a name"));
  EXPECT_EQ(run.json()["syncs"]["width"], 800);
  EXPECT_EQ(run.json()["syncs"]["height"], 600);
}

TEST_F(CliTtTraitsTest, ColourInTheBlankingIsDrawnAndReported) {
  change("src/hvsync_generator.v", "vpos < `V_DISPLAY", "vpos <= `V_DISPLAY");
  expect_bars({"--frames", "2", "-o", "out"}, 1,
              {"wrote 2 frames", "colour outside of the visible pixels in ",
               "first, frame 0, line 240, clock "});
  EXPECT_TRUE(fs::exists(folder / "out/frame_0001.png"));
  EXPECT_EQ(stats["faults"]["sync_clocks"], 0);
  EXPECT_GT(stats["faults"]["colour_clocks"], 0);
}

TEST_F(CliTtTraitsTest, DefinesAndIncludeFoldersAreTheUsers) {
  change("src/tt_um_bars.v", "`default_nettype none",
         "`include \"mine.vh\"\n`ifndef PURE_RTL\nsky130_fd_sc_hd__unheard_1 x();\n`endif\n");
  write("bars/test/Makefile",
        "ifneq ($(GATES),yes)\nCOMPILE_ARGS += -DPURE_RTL -I../src\nelse\n"
        "COMPILE_ARGS += -DGL_TEST\nendif\n");
  write("more/mine.vh", "`define MINE 1\n");
  expect_bars({}, 2, {"mine.vh"});
  expect_bars({"--include", "none"}, 2, {"there is no folder none"});
  expect_bars({"--include", "more"}, 2,
              {"bars/test/Makefile defines what may be missing: --define PURE_RTL"}, "GL_TEST");
  expect_bars({"--include", "more", "--define", "PURE_RTL"}, 0, {});
}

TEST_F(CliTtTraitsTest, CellsOfTheProcessAreAtHand) {
  expect_bars({"--ui", "21"}, 0, {});
  const auto crc = stats["frames"][0]["pins_crc32"];
  change("src/tt_um_bars.v",
         "wire [5:0] rgb = display_on ? palette[bar ^ band][5:0] ^ ui_in[5:0] : 6'd0;",
         "wire [5:0] mixed, rgb;\n"
         "  sky130_fd_sc_hd__xor2_4 mix[5:0] (.X(mixed), .A(palette[bar ^ band][5:0]),\n"
         "      .B(ui_in[5:0]), .VPWR(1'b1), .VGND(1'b0), .VPB(1'b1), .VNB(1'b0));\n"
         "  sky130_fd_sc_hd__mux2_1 blank[5:0] (.X(rgb), .A0(1'b0), .A1(mixed), .S(display_on));\n"
         "  sky130_fd_sc_hd__decap_12 fill ();\n");
  expect_bars({"--ui", "21"}, 0, {});
  EXPECT_EQ(stats["frames"][0]["pins_crc32"], crc);
}

TEST_F(CliTtTraitsTest, RunsNoCommandsOfStrangers) {
  expect_distrust("initial $system(\"touch ../../touched\");", "$system reaches beyond");
  expect_distrust("initial $c(\"system(\\\"touch ../../touched\\\");\");", "$c reaches beyond");
  expect_distrust("integer f; initial f = $fopen(\"../../touched\", \"w\");", "$fopen reaches");
  expect_distrust(
      "import \"DPI-C\" function int system(input string s);"
      " integer f; initial f = system(\"touch ../../touched\");",
      "system reaches beyond");
  expect_distrust("reg [7:0] m[0:3]; initial $readmemh(\"../../secret.hex\", m);",
                  "../../secret.hex is read, which lies outside of bars");
  const std::string touch = "$system(\"touch ../../touched\");";
  const std::string touching = "function int go(); " + touch + " return 0; endfunction ";
  const std::string calls = "$system reaches beyond";
  expect_distrust("integer n = p::go();", calls, "package p; " + touching + "endpackage");
  expect_distrust("integer n = p::n;", calls,
                  "package p; " + touching + "int n = go(); endpackage");
  expect_distrust("integer n = go();", calls, touching);
  expect_distrust("i u_i ();", calls, "interface i; initial " + touch + " endinterface");
  expect_distrust("p u_p ();", calls, "program p; initial " + touch + " endprogram");
  expect_distrust("c u_c = new; integer n = u_c.go();", calls, "class c; " + touching + "endclass");
  expect_distrust("integer n = p::c::go();", calls,
                  "package p; class c; static " + touching + "endclass endpackage");
  expect_distrust("integer n = p::system(\"touch ../../touched\");", "system reaches beyond",
                  "package p; import \"DPI-C\" function int system(input string s); endpackage");
  expect_distrust("integer n = system(\"touch ../../touched\");", "system reaches beyond",
                  "import \"DPI-C\" function int system(input string s);");
  expect_distrust("integer n = p::go();", "$fopen reaches beyond",
                  "package p; function int go(); int f; f = $fopen(\"../../touched\", \"w\");"
                  " return f; endfunction endpackage");
  expect_distrust("integer n = p::go();", "/etc/hostname is read, which lies outside of bars",
                  "package p; reg [7:0] m[0:3]; function int go();"
                  " $readmemh(\"/etc/hostname\", m); return 0; endfunction endpackage");
  reset_bars();
  change("src/tt_um_bars.v", "  assign uio_oe",
         "  initial $system(\"touch ../../touched\");\n  assign uio_oe");
  expect_bars({"--trust"}, 0, {});
  EXPECT_TRUE(fs::exists(folder / "touched")) << "the command runs in the folder of the sources";
}

TEST_F(CliTtTraitsTest, NamesAFileThatTheRtlReadsAndThatIsNotThere) {
  change("src/tt_um_bars.v", "  assign uio_oe",
         "  reg [7:0] m[0:3], n[0:3];\n"
         "  initial begin $readmemh(\"../data/one.hex\", m); $readmemh(\"two.hex\", n);"
         " $readmemh(\"two.hex\", m); end\n  assign uio_oe");
  expect_bars({}, 0,
              {"warning: bars/data/one.hex is not there, nor 1 more file that the RTL reads"},
              "$readmem file not found");
  write("bars/data/one.hex", "1 2 3 4\n");
  expect_bars({}, 0, {"warning: bars/src/two.hex is not there, which the RTL reads: "}, "one.hex");
  write("bars/src/two.hex", "1 2 3 4\n");
  expect_bars({}, 0, {}, "warning");
}

TEST_F(CliTtTraitsTest, WarnsOfAVectorThatFeedsItselfBitByBit) {
  expect_bars({}, 0, {}, "warning");
  change("src/tt_um_bars.v", "assign uio_oe = 8'h80;",
         "wire [3:0] chain = {chain[2:0] & ui_in[2:0], 1'b0};  // 0\n"
         "  assign uio_oe = 8'h80 | {8{chain[3]}};");
  expect_bars({}, 0,
              {"warning: bars/src/tt_um_bars.v:38 tt_um_bars.chain: depends on itself without a "
               "register between"});
}

TEST_F(CliTtTraitsTest, ReadsNothingOutsideOfTheFolder) {
  write("outside.v", "`define OUTSIDE 1\n");
  change("src/tt_um_bars.v", "`default_nettype none", "`include \"../../outside.v\"");
  expect_bars({}, 2, {"outside.v:1: an include or source outside of bars"});
  expect_bars({"--trust"}, 0, {});
  reset_bars();
  change("info.yaml", "\"tt_um_bars.v\"", "\"../../outside.v\"");
  expect_bars({}, 2, {"bars/info.yaml:11: the source file ../../outside.v lies outside"});
  EXPECT_FALSE(fs::exists(folder / "racebeam_out/frame_0001.png"));
}

TEST_F(CliTtTraitsTest, WithoutTtTheOptionsMeanNothing) {
  for (const Words& more : {Words{"--trust"}, {"--define", "A"}, {"--clock-hz", "25000000"}}) {
    Words words = {"render", "demo"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.err(), HasSubstr("are about the project of --tt"));
  }
}

}  // namespace
}  // namespace racebeam
