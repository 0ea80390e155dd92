// What can never be seen is proved equal, also in front of a multiplier, and what can is refuted.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_proof.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

constexpr int Unseen = 1, Seen = 2;

/// A module with mutants of `op_i == 2`: bit 1 of op_i inverted where bit 0 is 1, so that op_i is 2
/// or not, before and after; or where it is 0.
class Mine {
 public:
  Mine(const std::string& body, std::vector<PortTraffic::Port> ports) {
    std::ofstream(folder_ / "mine.sv") << body;
    RtlSources sources;
    sources.top = "mine";
    sources.files = {folder_ / "mine.sv"};
    netlist_ = mutant_netlist(sources, 1, 1);
    const std::size_t begin = netlist_.rtlil.find("$eq$mine.sv");
    const std::string cell =
        netlist_.rtlil.substr(begin, netlist_.rtlil.find_first_of("_ \n", begin) - begin);
    const auto mutant = [&cell](int number, const char* mode) {
      return Mutant{number,
                    std::string("mutate -mode ") + mode + " -module mine -cell " + cell +
                        " -port A -portbit 1 -ctrlbit 0",
                    mode, ""};
    };
    netlist_.mutants = {mutant(Unseen, "cnot1"), mutant(Seen, "cnot0")};
    ports_ = {"mine", std::move(ports), {}};
  }

  MutantProof prove(int number, const LegalInputs& legal = LegalInputs({})) const {
    return MutantProofs({netlist_, ports_, legal, std::chrono::seconds(10)}, {number})
        .prove(number);
  }
  /// What is told of one that is known as equal already.
  MutantProof prove_known(int number, bool again) const {
    const LegalInputs any({});
    const MutantNames known = {netlist_.mutants.at(static_cast<std::size_t>(number) - 1).name};
    return MutantProofs({netlist_, ports_, any, std::chrono::seconds(10), known, again}, {number})
        .prove(number);
  }

 private:
  const ScratchFolder folder_;
  MutantNetlist netlist_;
  PortTraffic ports_;
};

class MutantProofTest : public testing::Test {
 protected:
  const Mine mine_{
      "module mine (input wire clk_i, input wire rst_ni, input wire [1:0] op_i,\n"
      "  input wire [23:0] a_i, input wire [23:0] b_i, output reg [47:0] out_o);\n"
      "reg [23:0] left_q;\n"
      "always @(posedge clk_i)\n"
      "  if (!rst_ni) left_q <= 0; else left_q <= op_i == 2 ? a_i : b_i;\n"
      "always @(posedge clk_i) out_o <= left_q * (a_i + 24'd3);\n"
      "endmodule\n",
      {{"rst_ni", 1, true},
       {"op_i", 2, true},
       {"a_i", 24, true},
       {"b_i", 24, true},
       {"out_o", 48, false}}};
};

TEST_F(MutantProofTest, WhatCanNeverBeSeenIsEqual) {
  EXPECT_EQ(mine_.prove(Unseen).verdict, MutantProof::Equal);
}

TEST_F(MutantProofTest, WhatCanBeSeenHasACounterexample) {
  const MutantProof proof = mine_.prove(Seen);
  EXPECT_EQ(proof.verdict, MutantProof::Counterexample);
  EXPECT_GE(proof.inputs.size(), 3u) << "in reset, into left_q, into out_o";
}

TEST_F(MutantProofTest, WhatIsSeenOnlyWithInputsThatNoChipHasIsEqual) {
  const LegalInputs odd({{"op_i", [](std::uint64_t raw) { return raw | 1; }}});
  EXPECT_EQ(mine_.prove(Seen, odd).verdict, MutantProof::Equal) << "op_i is never 2";
}

TEST_F(MutantProofTest, WhatIsKnownAsEqualIsAskedOnlyIfItHasToBe) {
  EXPECT_EQ(mine_.prove_known(Seen, false).verdict, MutantProof::Equal);
  EXPECT_EQ(mine_.prove_known(Seen, true).verdict, MutantProof::Counterexample);
}

/// A large memory, and what is written to it when.
Mine memory(const std::string& written, const std::string& when) {
  return Mine(
      "module mine (input wire clk_i, input wire [1:0] op_i, input wire [9:0] at_i,\n"
      "  input wire [31:0] a_i, output reg [31:0] out_o);\n"
      "reg [31:0] kept_q[0:1023];\n"
      "always @(posedge clk_i) if (" +
          when + ") kept_q[at_i] <= " + written +
          ";\n"
          "always @(posedge clk_i) out_o <= kept_q[a_i[9:0]];\n"
          "endmodule\n",
      {{"op_i", 2, true}, {"at_i", 10, true}, {"a_i", 32, true}, {"out_o", 32, false}});
}

TEST(LargeMemoryTest, IsTheSameWhereTheSameIsWrittenToIt) {
  const Mine mine = memory("a_i", "op_i == 2");
  EXPECT_EQ(mine.prove(Unseen).verdict, MutantProof::Equal);
  const MutantProof seen = mine.prove(Seen);
  EXPECT_EQ(seen.verdict, MutantProof::Undecided);
  EXPECT_NE(seen.why.find("too much memory"), std::string::npos) << seen.why;
}

TEST(LargeMemoryTest, WhatIsNotWrittenNeedNotBeTheSame) {
  EXPECT_EQ(memory("op_i == 2 ? a_i : ~a_i", "op_i[0]").prove(Seen).verdict, MutantProof::Equal);
}

}  // namespace
}  // namespace racebeam
