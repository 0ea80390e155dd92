// 64 instances of a netlist at once are 64 times the RTL.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/parallel_gates.h"

#include <gmock/gmock.h>

#include <fstream>
#include <memory>
#include <random>

#include "tb/base/whole_file.h"
#include "tb/twin/bare_rtl.h"
#include "tb/twin/parallel_player.h"
#include "tb/verilate/gate_netlist.h"
#include "tb/verilate/rtl_plugin.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Word = ParallelGates::Word;

constexpr std::size_t Instances = ParallelGates::Instances;

std::string netlist(const std::string& body, const std::string& inputs = "a b s") {
  return ".model some\n.inputs " + inputs + "\n.outputs y\n" + body + ".end\n";
}

/// y after the inputs have these words.
Word answer(const std::string& body, const std::map<std::string, Word>& inputs) {
  ParallelGates gates(netlist(body));
  for (const auto& [name, word] : inputs) gates.net(gates.ports().at(name).nets[0]) = word;
  gates.settle();
  return gates.net(gates.ports().at("y").nets[0]);
}

TEST(ParallelGatesTest, EachGateDoesWhatItsNameSays) {
  const std::map<std::string, Word> in = {{"a", 0x0f0f}, {"b", 0x00ff}, {"s", 0x3333}};
  const auto gate = [&](const std::string& type, const std::string& pins) {
    return answer(".gate " + type + " A=a " + pins + " Y=y\n", in);
  };
  EXPECT_EQ(gate("$_NOT_", ""), ~Word{0x0f0f});
  EXPECT_EQ(gate("$_AND_", "B=b"), 0x000fu);
  EXPECT_EQ(gate("$_OR_", "B=b"), 0x0fffu);
  EXPECT_EQ(gate("$_XOR_", "B=b"), 0x0ff0u);
  EXPECT_EQ(gate("$_MUX_", "B=b S=s"), 0x0c3fu);
  EXPECT_EQ(answer(".names a y\n1 1\n", in), 0x0f0fu);
  EXPECT_EQ(answer(".names $true y\n1 1\n", in), ~Word{0});
  EXPECT_EQ(answer(".gate $_OR_ A=nobody B=a Y=y\n", in), 0x0f0fu) << "what nothing drives is 0";
}

TEST(ParallelGatesTest, ARegisterHasAtAnEdgeWhatSettledBefore) {
  ParallelGates gates(
      netlist(".gate $_DFF_P_ C=clk_i D=a Q=q\n.gate $_DFF_P_ C=clk_i D=q Q=y\n", "clk_i a"));
  EXPECT_EQ(gates.ports().count("clk_i"), 0u);
  Word& a = gates.net(gates.ports().at("a").nets[0]);
  const Word& y = gates.net(gates.ports().at("y").nets[0]);
  for (const Word value : {5, 9, 0}) {
    a = value;
    gates.settle();
    gates.edge();
  }
  gates.settle();
  EXPECT_EQ(y, 9u);
}

TEST(ParallelGatesTest, WhatIsNoSuchNetlistIsRefused) {
  const auto refused = [](const std::string& text) -> std::string {
    try {
      ParallelGates{text};
    } catch (const RtlError& error) {
      return error.what();
    }
    return "taken";
  };
  EXPECT_THAT(refused(netlist(".gate $_AND_ A=a B=y Y=y\n")), HasSubstr("loop"));
  EXPECT_THAT(refused(netlist(".gate $_DLATCH_P_ E=a D=b Q=y\n")), HasSubstr("$_DLATCH_P_"));
  EXPECT_THAT(refused(netlist(".gate $_DFF_P_ C=a D=s Q=q\n.gate $_DFF_P_ C=b D=q Q=y\n")),
              HasSubstr("2 clocks"));
  EXPECT_THAT(refused(".model some\n"), HasSubstr("no end"));
  EXPECT_THAT(refused(netlist(".latch a y\n")), HasSubstr(".latch"));
}

class ParallelPlayerTest : public testing::Test {
 protected:
  ParallelPlayerTest() {
    std::ofstream(folder / "mine.sv") << R"(module mine (
  input logic clk_i, input logic add_i, input logic [11:0] a_i, input logic [39:0] b_i,
  output logic [39:0] sum_o, output logic odd_o);
  logic [39:0] sum_q;
  always_ff @(posedge clk_i) if (add_i) sum_q <= sum_q + (b_i ^ 40'(a_i)); else sum_q <= b_i;
  assign sum_o = sum_q, odd_o = ^sum_q ^ a_i[0];
endmodule
)";
  }
  const ScratchFolder folder;
  const RtlSources rtl{"mine", {folder / "mine.sv"}};
  const std::vector<PortTraffic::Port> ports = {{"add_i", 1, true},  {"a_i", 12, true},
                                                {"b_i", 40, true},   {"sum_o", 40, false},
                                                {"odd_o", 1, false}, {"more_o", 1, false, true}};
};

TEST_F(ParallelPlayerTest, EachInstanceIsTheRtlAndAWrongBitNamesItsInstance) {
  ParallelPlayer gates(whole_file(gate_bits(rtl)), ports);
  std::vector<std::unique_ptr<BareRtl>> each;
  for (std::size_t n = 0; n < Instances; ++n)
    each.push_back(std::make_unique<BareRtl>(rtl_plugin(rtl), ports));
  std::mt19937_64 random(3);
  std::vector<std::string> packed(Instances, std::string(gates.row().bytes(), '\0'));
  for (int clock = 0; clock < 500; ++clock) {
    Word wrong = 0;
    ParallelPlayer::Rows rows;
    for (std::size_t n = 0; n < Instances; ++n) {
      std::vector<std::uint64_t> row(ports.size());
      row[0] = random() & 1;
      row[1] = random() & 0xfff;
      row[2] = random() >> 24;
      each[n]->settle(row.data());
      row[3] = each[n]->value(3);
      row[4] = each[n]->value(4);
      each[n]->edge();
      if (random() % 100 == 0) {
        wrong |= Word{1} << n;
        row[3] ^= std::uint64_t{1} << random() % 40;
      }
      gates.row().pack(row.data(), packed[n].data());
      rows[n] = packed[n].data();
    }
    const Word compared = random();
    ASSERT_EQ(gates.clock(rows, compared), wrong & compared) << "clock " << clock;
  }
}

TEST_F(ParallelPlayerTest, PortsOfAnotherUnitAreRefused) {
  const std::string gates = whole_file(gate_bits(rtl));
  EXPECT_THROW(ParallelPlayer(gates, {{"a_i", 11, true}}), RtlError);
  EXPECT_THROW(ParallelPlayer(gates, {{"a_i", 12, false}}), RtlError);
  EXPECT_THROW(ParallelPlayer(gates, {{"c_i", 12, true}}), RtlError);
}

TEST_F(ParallelPlayerTest, RegistersOfOtherEdgesHaveNoSuchNetlist) {
  std::ofstream(folder / "mine.sv")
      << "module mine (input logic clk_i, rst_ni, d, output logic q);\n"
         "always_ff @(posedge clk_i or negedge rst_ni)\n"
         "  if (!rst_ni) q <= 0; else q <= d;\nendmodule\n";
  EXPECT_THROW(gate_bits(rtl), RtlError);
}

}  // namespace
}  // namespace racebeam
