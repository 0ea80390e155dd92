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

// Bit 1 of op_i inverted where bit 0 is 1: op_i is 2 or not, before and after.
constexpr const char* Unseen =
    "mutate -mode cnot1 -module mine -cell $eq$mine.sv:5$3 -port A -portbit 1 -ctrlbit 0";
constexpr const char* Seen =
    "mutate -mode cnot0 -module mine -cell $eq$mine.sv:5$3 -port A -portbit 1 -ctrlbit 0";

class MutantProofTest : public testing::Test {
 protected:
  MutantProofTest() {
    std::ofstream(folder_ / "mine.sv")
        << "module mine (input wire clk_i, input wire rst_ni, input wire [1:0] op_i,\n"
           "  input wire [23:0] a_i, input wire [23:0] b_i, output reg [47:0] out_o);\n"
           "reg [23:0] left_q;\n"
           "always @(posedge clk_i)\n"
           "  if (!rst_ni) left_q <= 0; else left_q <= op_i == 2 ? a_i : b_i;\n"
           "always @(posedge clk_i) out_o <= left_q * (a_i + 24'd3);\n"
           "endmodule\n";
    RtlSources sources;
    sources.top = "mine";
    sources.files = {folder_ / "mine.sv"};
    netlist_ = mutant_netlist(sources, 1, 1);
    netlist_.mutants = {{1, Unseen, "unseen", ""}, {2, Seen, "seen", ""}};
    ports_ = {"mine",
              {{"rst_ni", 1, true},
               {"op_i", 2, true},
               {"a_i", 24, true},
               {"b_i", 24, true},
               {"out_o", 48, false}},
              {}};
  }

  MutantProof prove(int number, const LegalInputs& legal = LegalInputs({})) const {
    return MutantProofs({netlist_, ports_, legal, std::chrono::seconds(10)}, {number})
        .prove(number);
  }

 private:
  const ScratchFolder folder_;
  MutantNetlist netlist_;
  PortTraffic ports_;
};

TEST_F(MutantProofTest, WhatCanNeverBeSeenIsEqual) {
  EXPECT_EQ(prove(1).verdict, MutantProof::Equal);
}

TEST_F(MutantProofTest, WhatCanBeSeenHasACounterexample) {
  const MutantProof proof = prove(2);
  EXPECT_EQ(proof.verdict, MutantProof::Counterexample);
  EXPECT_GE(proof.inputs.size(), 3u) << "in reset, into left_q, into out_o";
}

TEST_F(MutantProofTest, WhatIsSeenOnlyWithInputsThatNoChipHasIsEqual) {
  const LegalInputs odd({{"op_i", [](std::uint64_t raw) { return raw | 1; }}});
  EXPECT_EQ(prove(2, odd).verdict, MutantProof::Equal) << "op_i is never 2";
}

}  // namespace
}  // namespace racebeam
