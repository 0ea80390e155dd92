// Mutants have the same names wherever the RTL lies: waivers and kept streams are written with
// them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_netlist.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

void expect_no_place(const MutantNetlist& netlist, const std::string& place) {
  EXPECT_THAT(netlist.rtlil, Not(HasSubstr(place)));
  for (const Mutant& mutant : netlist.mutants) {
    EXPECT_THAT(mutant.name, Not(HasSubstr(place)));
    EXPECT_THAT(mutant.source, Not(HasSubstr(place)));
  }
}

TEST(MutantNetlist, UnitsOfSeveralModulesDoNotTellWhereTheProjectLies) {
  RtlSources sources;
  sources.top = "voxel_setup";
  sources.files = {rtl_file("voxel_setup")};
  const MutantNetlist netlist = mutant_netlist(sources, 200, 1);
  expect_no_place(netlist, project_folder());
  EXPECT_THAT(netlist.rtlil, HasSubstr("$rtl/voxel/voxel_divider.sv:"));
}

TEST(MutantNetlist, RtlElsewhereDoesNotTellWhereItLies) {
  const ScratchFolder folder;
  for (const char* name : {"mine", "parts", "texts"}) fs::create_directory(folder / name);
  std::ofstream(folder / "mine/mine.sv")
      << "module mine (input wire clk_i, input wire [3:0] a_i, output wire [3:0] out_o);\n"
         "wire [3:0] x, y;\nbeside u_beside (a_i, x);\npart u_part (x, y);\n"
         "`include \"text.svh\"\nendmodule\n";
  std::ofstream(folder / "mine/beside.sv")
      << "module beside (input wire [3:0] a, output wire [3:0] y); assign y = a + 1; endmodule\n";
  std::ofstream(folder / "parts/part.v")
      << "module part (input wire [3:0] a, output wire [3:0] y); assign y = a ^ 5; endmodule\n";
  std::ofstream(folder / "texts/text.svh") << "assign out_o = y - a_i;\n";
  RtlSources sources;
  sources.top = "mine";
  sources.files = {folder / "mine/mine.sv"};
  sources.include_folders = {folder / "texts"};
  sources.libraries = {folder / "parts"};
  const MutantNetlist netlist = mutant_netlist(sources, 50, 1);
  expect_no_place(netlist, folder.path());
  for (const char* file : {"beside.sv:1", "part.v:1", "text.svh:1"})
    EXPECT_THAT(netlist.rtlil, HasSubstr(file)) << "is read";
  EXPECT_FALSE(netlist.mutants.empty());
}

TEST(MutantNetlist, OfATableMistakesAreInWhatIsReadOnly) {
  const ScratchFolder folder;
  std::ofstream(folder / "rows.mem") << "3\nc\n5\n9\n";
  std::ofstream(folder / "rom.sv")
      << "module rom (input wire [1:0] a_i, output wire [3:0] out_o);\nlogic [3:0] rows[4];\n"
         "initial $readmemh(\"" +
             std::string(folder / "rows.mem") +
             "\", rows);\nassign out_o = rows[a_i];\nendmodule\n";
  RtlSources sources;
  sources.top = "rom";
  sources.files = {folder / "rom.sv"};
  const MutantNetlist netlist = mutant_netlist(sources, 200, 1);
  EXPECT_THAT(netlist.rtlil, HasSubstr("$meminit"));
  EXPECT_FALSE(netlist.mutants.empty());
  for (const Mutant& mutant : netlist.mutants)
    EXPECT_THAT(mutant.name, ContainsRegex("memrd.* (ADDR|DATA|CLK)"));
}

std::ptrdiff_t registers_in(const std::string& rtlil) {
  static const std::regex Register("cell \\$[a-z]*dff");
  return std::distance(std::sregex_iterator(rtlil.begin(), rtlil.end(), Register), {});
}

TEST(MutantNetlist, AssertionsStandApartFromWhatGetsMistakes) {
  const ScratchFolder folder;
  const auto netlist = [&](const std::string& assertion) {
    std::ofstream(folder / "mine.sv")
        << "module mine (input wire clk_i, input wire rst_ni, output reg [3:0] out_o);\n"
           "always @(posedge clk_i) out_o <= out_o == 9 ? 4'd0 : out_o + 4'd1;\n"
           "`ifndef SYNTHESIS\nalways @(posedge clk_i) " +
               assertion + "\n`endif\nendmodule\n";
    RtlSources sources;
    sources.top = "mine";
    sources.files = {folder / "mine.sv"};
    return mutant_netlist(sources, 50, 1);
  };
  const MutantNetlist asserted = netlist("is_a_digit : assert (out_o <= 9);");
  EXPECT_THAT(asserted.asserted, HasSubstr("cell $assert"));
  EXPECT_THAT(asserted.rtlil, Not(HasSubstr("$assert")));
  const MutantNetlist nested =
      netlist("if (rst_ni) begin if (out_o != 3) is_a_digit : assert (out_o <= 9); end");
  EXPECT_EQ(registers_in(nested.asserted), registers_in(nested.rtlil)) << "it holds at its clock";
  const MutantNetlist other = netlist("assert (out_o <= 9) else $error(\"no digit\");");
  EXPECT_EQ(other.asserted, "") << "yosys does not read that";
  EXPECT_EQ(other.mutants.size(), asserted.mutants.size());
}

TEST(MutantNetlist, KeptStreamsNameNoFileByItsPlaceOnAMachine) {
  int streams = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(project_folder() + "/tb/twin/streams")) {
    if (!entry.is_regular_file()) continue;
    ++streams;
    const std::string text = whole_file(entry.path());
    EXPECT_THAT(text, Not(HasSubstr("$/"))) << entry.path();
    EXPECT_THAT(text, Not(HasSubstr(" /"))) << entry.path();
  }
  EXPECT_GT(streams, 0);
}

TEST(MutantNetlist, AssertionsOfModulesInsideArePartOfIt) {
  const ScratchFolder folder;
  fs::create_directory(folder / "inside");
  std::ofstream(folder / "mine.sv")
      << "module mine (input wire clk_i, input wire [3:0] a_i, output wire [3:0] out_o);\n"
         "digit u_digit (.clk_i(clk_i), .a_i(a_i), .out_o(out_o));\nendmodule\n";
  std::ofstream(folder / "inside/digit.sv")
      << "module digit (input wire clk_i, input wire [3:0] a_i, output reg [3:0] out_o);\n"
         "always @(posedge clk_i) out_o <= a_i > 9 ? 9 : a_i;\n"
         "`ifndef SYNTHESIS\nalways @(posedge clk_i) is_a_digit : assert (out_o <= 9);\n`endif\n"
         "endmodule\n";
  RtlSources sources;
  sources.top = "mine";
  sources.files = {folder / "mine.sv"};
  sources.libraries = {folder / "inside"};
  EXPECT_THAT(mutant_netlist(sources, 5, 1).asserted, HasSubstr("u_digit.is_a_digit"));
}

}  // namespace
}  // namespace racebeam
