// What the program reads out of Verilator's XML, and what it relies on of Verilator.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/rtl_syntax.h"

#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/verilator.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class RtlSyntaxTest : public testing::Test {
 protected:
  RtlSources sources(const std::string& text, const std::string& top = "stacks") {
    std::ofstream(folder / "mine.sv") << text;
    return {top, {folder / "mine.sv"}};
  }
  RtlSyntax read(const std::string& text) { return read_rtl_syntax(sources(text)); }
  /// "LINE NAME" of each.
  static std::vector<std::string> lines(const std::vector<RtlSyntax::Place>& places) {
    std::vector<std::string> all;
    for (const auto& place : places) all.push_back(std::to_string(place.line) + " " + place.name);
    return all;
  }

  ScratchFolder folder;
};

TEST_F(RtlSyntaxTest, VerilatorIsTheVersionThatAllThisWasTriedWith) {
  EXPECT_THAT(verilator_version(), HasSubstr(TriedVerilator))
      << "run all tests of this file, then name the new version in tb/verilate/verilator.h";
}

TEST_F(RtlSyntaxTest, HasPortsWithTheirWidths) {
  const RtlSyntax syntax = read(R"(module stacks #(parameter int N = 5) (
    input clk_i, input [N-1:0] a_i, output logic [1:0][3:0] b_o,
    input struct packed {logic [8:0] x; logic y;} s_i, inout z);
  endmodule)");
  std::vector<std::string> ports;
  for (const auto& port : syntax.ports)
    ports.push_back(port.direction + " " + port.name + " " + std::to_string(port.bits));
  EXPECT_THAT(ports, ElementsAre("input clk_i 1", "input a_i 5", "output b_o 8", "input s_i 10",
                                 "inout z 1"));
  EXPECT_EQ(syntax.clock, "clk_i");
  EXPECT_EQ(syntax.top.file, folder / "mine.sv");
  EXPECT_EQ(syntax.top.line, 1);
}

TEST_F(RtlSyntaxTest, HasParametersAsTheyAreSet) {
  RtlSources some = sources(R"(module stacks #(parameter int A = 3, parameter B = -2,
    parameter T = "text in a string", parameter logic [7:0] C = A + 1) (input clk_i);
    localparam int D = 9;
  endmodule)");
  some.parameters = {"A=70"};
  std::vector<std::string> all;
  for (const auto& own : read_rtl_syntax(some).parameters)
    all.push_back(own.name + "=" + own.value);
  EXPECT_THAT(all, ElementsAre("A=70", "B=-2", "T=", "C=71"));
}

TEST_F(RtlSyntaxTest, ReadsIncludesBesideTheFileAndNamesThem) {
  std::ofstream(folder / "ports.svh") << "input clk_i, output o\n";
  const RtlSyntax syntax = read("module stacks (\n`include \"ports.svh\"\n);\nendmodule\n");
  EXPECT_EQ(syntax.ports.size(), 2u);
  EXPECT_THAT(syntax.files, testing::IsSupersetOf({std::string(folder / "ports.svh"),
                                                   std::string(folder / "mine.sv")}));
}

TEST_F(RtlSyntaxTest, AFolderMayHaveAnyName) {
  for (const std::string name : {"R&D <x>", "quoted \"'", "na\u00efve", "a\\b$c#d"}) {
    const std::string inside = folder / name;
    std::filesystem::create_directory(inside);
    std::ofstream(inside + "/ports.svh") << "input clk_i, output o\n";
    std::ofstream(inside + "/mine.sv")
        << "module stacks (\n`include \"ports.svh\"\n);\n\\a&<b u ();\n"
           "initial $system(\"\");\nendmodule\nmodule \\a&<b ; endmodule\n";
    const RtlSources some{"stacks", {inside + "/mine.sv"}};
    const RtlSyntax syntax = read_rtl_syntax(some);
    EXPECT_THAT(syntax.files, testing::IsSupersetOf({inside + "/ports.svh", inside + "/mine.sv"}));
    EXPECT_EQ(syntax.ports.size(), 2u);
    EXPECT_THAT(lines(syntax.calls), ElementsAre("5 $system"));
    std::ofstream(inside + "/ports.svh") << "input clk_i, output o, output p\n";
    EXPECT_EQ(read_rtl_syntax(some).ports.size(), 3u) << "a change is seen";
  }
}

TEST_F(RtlSyntaxTest, TellsRegistersOnTheFallingEdgeAlsoInsideAndUnderAnotherName) {
  const RtlSyntax syntax = read(R"(module inner (input c, input d, output reg q);
    always @(negedge c) q <= d;
  endmodule
  module stacks (input clk_i, input rst_n, input d, output reg a, b, output c);
    wire also = clk_i;
    always @(negedge also) a <= d;
    always @(posedge clk_i or negedge rst_n) if (!rst_n) b <= 0; else b <= d;
    inner u (also, d, c);
  endmodule)");
  EXPECT_FALSE(syntax.rising_only);
  EXPECT_THAT(lines(syntax.falling), UnorderedElementsAre("2 q", "6 a"));
}

TEST_F(RtlSyntaxTest, KnowsRtlThatUsesNothingButRisingEdges) {
  const std::string head = "module stacks (input clk_i, input d, output reg q);\n";
  EXPECT_TRUE(read(head + "always @(posedge clk_i) q <= d;\nendmodule\n").rising_only);
  for (const char* other : {"always @(negedge clk_i) q <= d;", "always_comb q = clk_i & d;",
                            "always_latch if (!clk_i) q = d;", "always @(clk_i) q = d;",
                            "wire gated = clk_i & d; always @(posedge gated) q <= d;"})
    EXPECT_FALSE(read(head + other + "\nendmodule\n").rising_only) << other;
}

TEST_F(RtlSyntaxTest, KnowsRtlThatSpeaksAsItsInputsMove) {
  const std::string head = "module stacks (input clk_i, input d, output reg q);\n";
  for (const char* at_edges :
       {"always @(posedge clk_i) begin q <= d; $display(d); end", "initial $display(\"begun\");",
        "final $display(\"done\");", "always @(posedge clk_i) assert (!d);"})
    EXPECT_FALSE(read(head + at_edges + "\nendmodule\n").speaks_between_edges) << at_edges;
  for (const char* between :
       {"always_comb begin q = d; $display(d); end", "always_comb assert (d);",
        "function tell(input a); $display(a); tell = a; endfunction\nassign q = tell(d);"})
    EXPECT_TRUE(read(head + between + "\nendmodule\n").speaks_between_edges) << between;
}

TEST_F(RtlSyntaxTest, TellsWhetherAllStateIsInRegisters) {
  const std::string head = "module stacks (input clk_i, input d, output reg [3:0] q);\n";
  for (const char* registers :
       {"always @(posedge clk_i) q <= q + 4'(d);", "always @(posedge clk_i) assert (!d);",
        "reg [7:0] m [0:3]; always @(posedge clk_i) m[0] <= m[1];",
        "always @(posedge clk_i) $display(\"%t %d\", $time, q);"})
    EXPECT_FALSE(read(head + registers + "\nendmodule\n").state_elsewhere) << registers;
  for (const char* elsewhere :
       {"always @(posedge clk_i) q <= 4'($random);", "always @(posedge clk_i) q <= 4'($urandom);",
        "int f[$]; always @(posedge clk_i) f.push_back(1);",
        "string s; always @(posedge clk_i) s = {s, \"a\"};",
        "import \"DPI-C\" function int getpid(); always @(posedge clk_i) q <= 4'(getpid());",
        "integer f; initial f = $fopen(\"a\", \"r\"); always @(posedge clk_i) q <= 4'($fgetc(f));"})
    EXPECT_TRUE(read(head + elsewhere + "\nendmodule\n").state_elsewhere) << elsewhere;
}

TEST_F(RtlSyntaxTest, TellsLoopsThatNoConstantEnds) {
  const RtlSyntax syntax = read(R"(module stacks (input clk_i, input [7:0] a_i, output reg [7:0] o);
    integer n, left;
    always @(posedge clk_i) begin
      for (n = 0; n < 4; n = n + 1) o[n] <= a_i[n];
      while (a_i != left) left = left / 2;
    end
    initial forever left = 0;
  endmodule)");
  EXPECT_THAT(lines(syntax.loops), ElementsAre("5 while", "7 forever"));
}

TEST_F(RtlSyntaxTest, TellsWhatReachesBeyondTheSimulation) {
  const RtlSyntax syntax = read(R"(module stacks (input clk_i);
    import "DPI-C" function int getpid();
    reg [7:0] table_q [0:3]; integer f;
    initial begin
      $system("true");
      $c("(void)0;");
      f = $fopen("a", "w");
      f = $fopen("b", "r");
      f = getpid();
      $readmemh("c", table_q);
      $writememh("d", table_q);
      f = $fopen("e");
      f = $system("true");
      $display("%d", f);
    end
`systemc_implementation
static int unused;
`verilog
  endmodule)");
  EXPECT_THAT(
      lines(syntax.calls),
      UnorderedElementsAre("2 getpid", "5 $system", "6 $c", "7 $fopen", "11 $writememh",
                           "12 $fopen", "13 $system", testing::EndsWith("systemc_implementation")));
}

TEST_F(RtlSyntaxTest, LooksIntoPackagesInterfacesAndClassesToo) {
  const RtlSyntax syntax = read(R"(package p;
    function int call(); $system("true"); return 0; endfunction
    function int wait_for(int n); while (n != 1) n = n / 2; return n; endfunction
    class plain; int n; function new(); endfunction endclass
    import "DPI-C" getpid = function int \new ();
  endpackage
  function int call(); $c("(void)0;"); return 0; endfunction
  interface wires (input c, input d);
    reg q; reg [7:0] table_q [0:3];
    always @(negedge c) q <= d;
    initial $readmemh("file", table_q);
  endinterface
  module stacks (input clk_i, input d);
    wires u (clk_i, d);
    integer n = p::call() + call() + p::wait_for(8) + p::\new ();
    p::plain o;
    initial o = new;
  endmodule)");
  EXPECT_THAT(lines(syntax.calls), UnorderedElementsAre("2 $system", "5 new", "7 $c"));
  EXPECT_THAT(lines(syntax.loops), ElementsAre("3 while"));
  EXPECT_THAT(lines(syntax.reads), ElementsAre("11 file"));
  EXPECT_THAT(lines(syntax.falling), ElementsAre("10 q"));
  EXPECT_FALSE(syntax.rising_only);
}

TEST_F(RtlSyntaxTest, FindsNothingToSayOfTheProjectsOwnRtl) {
  const RtlSyntax syntax =
      read_rtl_syntax({"racebeam_top", {RACEBEAM_SOURCE_DIR "/rtl/beam/racebeam_top.sv"}});
  EXPECT_TRUE(syntax.rising_only);
  EXPECT_THAT(lines(syntax.falling), IsEmpty());
  EXPECT_THAT(lines(syntax.calls), IsEmpty());
  EXPECT_THAT(lines(syntax.loops), IsEmpty());
  EXPECT_GT(syntax.files.size(), 12u) << "modules are found beside the file";
}

TEST_F(RtlSyntaxTest, SaysWhatVerilatorSaysOfAMistake) {
  try {
    read("module stacks (input clk_i);\nassign x = ;\nendmodule\n");
    FAIL();
  } catch (const RtlError& error) {
    EXPECT_THAT(error.what(), HasSubstr("mine.sv:2:"));
    EXPECT_THAT(error.what(), HasSubstr("syntax error"));
  }
  EXPECT_THROW(read_rtl_syntax({"stacks", {folder / "none.sv"}}), UsageError);
}

// The glue: members for ports, scopes for what is inside, the clock that falls with the inputs.

TEST_F(RtlSyntaxTest, PluginHasPortsParametersAndRemarks) {
  const rtl_library library(rtl_plugin(sources(R"(module stacks #(parameter int N = 3) (
    input clk_i, input a, output reg b, output c);
    always @(negedge clk_i) b <= a;
    wire x = !y, y = !x | a;
    assign c = x;
  endmodule)")));
  const rtl_model& model = library.model();
  EXPECT_EQ(model.port_count, 4);
  EXPECT_EQ(rtl_port_of(model, "b").is_input, 0);
  EXPECT_STREQ(model.unit, "stacks");
  EXPECT_STREQ(model.parameters, "N=3 ");
  EXPECT_EQ(model.signal_count, 0);
  const std::string mine = folder / "mine.sv";
  EXPECT_EQ(rtl_place(model), mine + ":1");
  EXPECT_THAT(model.remarks, HasSubstr("file " + mine + ":1 -\n"));
  EXPECT_THAT(model.remarks, HasSubstr("falling " + mine + ":3 b\n"));
  EXPECT_THAT(model.remarks, testing::ContainsRegex("circular .*mine.sv:4 .*[xy]\n"));
}

TEST_F(RtlSyntaxTest, APortThatFeedsItselfIsNamedAsTheRtlHasIt) {
  const rtl_library library(rtl_plugin(sources(R"(module stacks (
    input clk_i, input [3:0] a,
    output [3:0] b);
    assign b = {b[2:0] ^ a[2:0], a[3]};
  endmodule)")));
  const std::string place = "circular " + (folder / "mine.sv") + ":3 stacks.b\n";
  EXPECT_THAT(library.model().remarks, HasSubstr(place));
}

/// Of a port of one byte.
int value(const rtl_port& port) { return *static_cast<const unsigned char*>(port.data); }
void set(const rtl_port& port, int value) {
  *static_cast<unsigned char*>(port.data) = static_cast<unsigned char>(value);
}

constexpr const char* TwoRegisters =
    R"(module inner (input clk_i, input [3:0] d, output reg [3:0] q);
    always @(posedge clk_i) q <= d;
  endmodule
  module stacks (input clk_i, input [3:0] d, output [3:0] o);
    reg [3:0] past [0:1];
    wire [3:0] q;
    inner u_inner (.clk_i, .d, .q);
    always @(posedge clk_i) {past[1], past[0]} <= {past[0], q};
    assign o = past[1] ^ d;
  endmodule)";

TEST_F(RtlSyntaxTest, PluginWithSignalsHasThemByTheirPaths) {
  RtlSources some = sources(TwoRegisters);
  some.signals = true;
  const rtl_library library(rtl_plugin(some));
  std::map<std::string, const rtl_port*> inside;
  for (int n = 0; n < library.model().signal_count; ++n)
    inside[library.model().signals[n].name] = &library.model().signals[n];
  for (const char* name : {"past[0]", "past[1]", "q", "u_inner.q", "u_inner.d", "clk_i"})
    ASSERT_EQ(inside.count(name), 1u) << name;
  EXPECT_EQ(inside["past[1]"]->bits, 4);
  library.model().eval(library.model().top);
  set(rtl_port_of(library.model(), "d"), 9);
  library.model().eval(library.model().top);
  for (int clock = 0; clock < 3; ++clock) library.model().rise(library.model().top);
  EXPECT_EQ(value(*inside["u_inner.q"]), 9);
  EXPECT_EQ(value(*inside["past[1]"]), 9);
  set(*inside["past[1]"], 5);  // a deposit, seen by the logic behind it
  library.model().eval(library.model().top);
  EXPECT_EQ(value(rtl_port_of(library.model(), "o")), 5 ^ 9);
}

TEST_F(RtlSyntaxTest, ADoorWritesItsRegisterWithTheNextInputsAndNoOther) {
  RtlSources some = sources(TwoRegisters);
  some.doors = {"u_inner.q", "past[1]"};
  const rtl_library library(rtl_plugin(some));
  const rtl_model& model = library.model();
  ASSERT_EQ(model.door_count, 2);
  EXPECT_STREQ(model.doors[1].name, "past[1]");
  const rtl_port& out = rtl_port_of(model, "o");
  set(rtl_port_of(model, "d"), 3);
  model.eval(model.top);
  EXPECT_EQ(value(out), 3);
  std::memcpy(model.doors[1].data, std::array<std::uint64_t, 1>{5}.data(), 8);
  model.eval(model.top);
  EXPECT_EQ(value(out), 3) << "nobody has knocked";
  *model.knock = 1u << 1;
  model.eval(model.top);
  EXPECT_EQ(value(out), 5 ^ 3);
  EXPECT_EQ(*model.knock, 0u);
  for (int clock = 0; clock < 3; ++clock) model.rise(model.top);  // d is at past[1]
  EXPECT_EQ(value(out), 3 ^ 3);
}

TEST_F(RtlSyntaxTest, EachRiseIsOneClockWithAndWithoutChangesBetween) {
  const rtl_library library(rtl_plugin(sources(TwoRegisters)));
  const rtl_model& model = library.model();
  int q = 0, past[2] = {};
  for (int clock = 0; clock < 40; ++clock) {
    const int d = clock * clock / 3 % 16;
    if (clock % 3 != 2) {  // every third clock has no change of an input
      set(rtl_port_of(model, "d"), d);
      model.eval(model.top);
    }
    const int now = value(rtl_port_of(model, "d"));
    model.rise(model.top);
    past[1] = past[0];
    past[0] = q;
    q = now;
    if (clock <= 2) continue;
    ASSERT_EQ(value(rtl_port_of(model, "o")), past[1] ^ now) << "clock " << clock;
  }
}

TEST_F(RtlSyntaxTest, RegistersOnTheFallingEdgeTakeTheirInputThere) {
  const rtl_library library(rtl_plugin(sources(R"(module stacks (
    input clk_i, input [3:0] d, output reg [3:0] o);
    reg [3:0] q;
    always @(posedge clk_i) q <= d;
    always @(negedge clk_i) o <= q;
  endmodule)")));
  const rtl_model& model = library.model();
  for (const int d : {3, 12, 7}) {
    set(rtl_port_of(model, "d"), d);
    model.eval(model.top);
    model.rise(model.top);
    EXPECT_EQ(value(rtl_port_of(model, "o")), d) << "half a clock later, in the same clock";
  }
}

}  // namespace
}  // namespace racebeam
