// Promises of tb/verilate/comb_paths.h: an input is called quiet only if no output follows it
// before the next edge, and is in one group with each output that does; and the headers of all
// units name, as Comb, each input that is not quiet.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/comb_paths.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/rtl_syntax.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Of a module with the inputs clk_i, a_i, b_i, two bits of s_i and the outputs y_o and z_o.
CombGroups groups_of(const std::string& body, const std::string& before = "") {
  const ScratchFolder folder;
  const std::string file = folder.path() + "/mine.sv";
  std::ofstream(file) << before << R"(module mine (
  input wire clk_i, input wire a_i, input wire b_i, input wire [1:0] s_i,
  output logic y_o, output logic z_o);
)" << body << "\nendmodule\n";
  return comb_groups({"mine", {file}});
}

struct QuietInputs : testing::Test {
  static std::set<std::string> of(const std::string& body, const std::string& before = "") {
    std::set<std::string> quiet = {"a_i", "b_i", "s_i"};
    for (const auto& [port, group] : groups_of(body, before)) quiet.erase(port);
    return quiet;
  }
};

TEST_F(QuietInputs, AreThoseBeforeARegister) {
  EXPECT_THAT(of("logic q; always_ff @(posedge clk_i) if (s_i[0]) q <= a_i; assign y_o = q & b_i;"),
              ElementsAre("a_i", "s_i"));
}

TEST_F(QuietInputs, AreNotSoByOneBitOfThem) {
  EXPECT_THAT(of("logic q; always_ff @(posedge clk_i) q <= s_i[0] & a_i; assign y_o = q & s_i[1];"),
              ElementsAre("a_i", "b_i"));
}

TEST_F(QuietInputs, AreNotThoseThatMakeAClock) {
  EXPECT_THAT(of("wire c = clk_i & b_i; always_ff @(posedge c) y_o <= a_i;"),
              ElementsAre("a_i", "s_i"));
}

TEST_F(QuietInputs, AreNotThoseThatSetARegisterWithoutTheClock) {
  EXPECT_THAT(of("always_ff @(posedge clk_i or negedge b_i) if (!b_i) y_o <= 0; else y_o <= a_i;"),
              ElementsAre("a_i", "s_i"));
}

TEST_F(QuietInputs, AreNotThoseOfALatch) {
  EXPECT_THAT(of("always_latch if (a_i) y_o = b_i;"), ElementsAre("s_i"));
}

TEST_F(QuietInputs, AreNotAddressesOfAMemory) {
  EXPECT_THAT(of("logic [3:0] m [4]; always_ff @(posedge clk_i) if (a_i) m[0] <= {4{b_i}};\n"
                 "assign y_o = m[s_i][0];"),
              ElementsAre("a_i", "b_i"));
}

// Verilator gives the unknown value some value, and so the choice shows.
TEST_F(QuietInputs, AreNotThoseThatChooseAnUnknownValue) {
  EXPECT_THAT(of("always_comb if (s_i[0]) y_o = a_i; else y_o = 1'bx;"), ElementsAre("b_i"));
}

TEST_F(QuietInputs, AreUnknownOfRtlThatAsksWhoReadsIt) {
  EXPECT_THAT(of("`ifdef SYNTHESIS\nassign y_o = 0;\n`else\nassign y_o = a_i;\n`endif"), IsEmpty());
}

TEST_F(QuietInputs, AreUnknownOfRtlThatYosysCannotRead) {
  EXPECT_THAT(of("import mine_pkg::*; always_ff @(posedge clk_i) y_o <= a_i;",
                 "package mine_pkg; localparam int N = 1; endpackage\n"),
              IsEmpty());
}

TEST(CombGroups, AreApartWhereNoOutputFollowsTwoInputs) {
  const CombGroups groups = groups_of("assign y_o = a_i; assign z_o = b_i & s_i[1];");
  EXPECT_EQ(groups.at("y_o"), groups.at("a_i"));
  EXPECT_EQ(groups.at("z_o"), groups.at("b_i"));
  EXPECT_EQ(groups.at("z_o"), groups.at("s_i"));
  EXPECT_NE(groups.at("y_o"), groups.at("z_o"));
}

TEST(CombGroups, AreOneWhereAnInputReachesTwoOutputs) {
  const CombGroups groups = groups_of("assign y_o = a_i ^ s_i[0]; assign z_o = b_i & s_i[1];");
  EXPECT_THAT(groups, SizeIs(5));
  for (const auto& [port, group] : groups) EXPECT_EQ(group, 0) << port;
}

TEST(CombGroups, AreNotJoinedByTheClock) {
  const CombGroups groups = groups_of(
      "logic p, q; always_ff @(posedge clk_i) {p, q} <= s_i;\n"
      "assign y_o = a_i & p; assign z_o = b_i & q;");
  EXPECT_EQ(groups.count("clk_i"), 0U);
  EXPECT_NE(groups.at("a_i"), groups.at("b_i"));
}

TEST(CombGroupsOfANetlist, AreNotGuessedFromSomethingElse) {
  EXPECT_THROW(comb_groups_in("{}", "clk_i"), RtlError);
  EXPECT_THROW(comb_groups_in("no netlist", "clk_i"), RtlError);
}

/// A unit's header, by whose stem its RTL is called.
std::vector<std::string> headers_with_rtl() {
  std::vector<std::string> headers;
  for (const auto& entry : fs::recursive_directory_iterator(project_folder() + "/sc")) {
    const fs::path& file = entry.path();
    const fs::path rtl = project_folder() + "/rtl/" + file.parent_path().filename().string() + "/" +
                         file.stem().string() + ".sv";
    if (file.extension() == ".h" && fs::exists(rtl) &&
        whole_file(file).find("// Comb ") != std::string::npos)
      headers.push_back(file);
  }
  std::sort(headers.begin(), headers.end());
  return headers;
}

/// What the header says from Comb up to its next field.
std::string comb_field(const std::string& header) {
  const std::string text = whole_file(header);
  const std::size_t begin = text.find("// Comb ");
  std::size_t end = begin;
  do end = text.find("\n//", end + 1);
  while (!std::isupper(static_cast<unsigned char>(text.at(end + 4))));
  return text.substr(begin, end - begin);
}

/// dr1_*_i is each such name, and v_i the three of an axis too.
bool names(const std::string& comb, const std::string& input) {
  static const std::regex Word("[a-z0-9_*]+_n?i\\b");
  for (std::sregex_iterator word(comb.begin(), comb.end(), Word), end; word != end; ++word) {
    std::string pattern = word->str();
    const std::size_t star = pattern.find('*');
    if (star != std::string::npos) pattern.replace(star, 1, ".*");
    else pattern.insert(pattern.rfind('_'), "(_[xyz])?");
    if (std::regex_match(input, std::regex(pattern))) return true;
  }
  return comb.find("all inputs") != std::string::npos;
}

using Header = testing::TestWithParam<std::string>;

TEST_P(Header, NamesEachInputThatReachesAnOutput) {
  const std::string unit = fs::path(GetParam()).stem();
  const std::string engine = fs::path(GetParam()).parent_path().filename();
  const RtlSources rtl{unit, {project_folder() + "/rtl/" + engine + "/" + unit + ".sv"}};
  const RtlSyntax syntax = read_rtl_syntax(rtl);
  const CombGroups groups = comb_groups(rtl);
  for (const RtlSyntax::Port& port : syntax.ports) {
    if (port.direction == "input" && groups.count(port.name) != 0) {
      EXPECT_TRUE(names(comb_field(GetParam()), port.name))
          << port.name << " reaches an output of " << unit << ", and its header says\n"
          << comb_field(GetParam());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Units, Header, testing::ValuesIn(headers_with_rtl()),
                         [](const auto& header) { return fs::path(header.param).stem().string(); });

}  // namespace
}  // namespace racebeam
