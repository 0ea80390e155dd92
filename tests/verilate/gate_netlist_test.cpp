// Gates of RTL that is not the project's, their figures, and netlists that are broken.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/gate_netlist.h"

#include <gmock/gmock.h>

#include <fstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/scene/engines.h"
#include "tb/verilate/gate_timing.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/simulated_cells.h"
#include "tests/support/fake_mapping.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

class GatesOfACounter : public testing::Test {
 protected:
  GatesOfACounter() {
    std::ofstream(folder / "counter.sv") << R"(module counter #(parameter int Step = 1) (
  input logic clk_i, input logic rst_ni, input logic [2:0] mask_i, output logic [7:0] count_o);
  logic [7:0] count_q;
  always_ff @(posedge clk_i) count_q <= rst_ni ? count_q + 8'(Step) : '0;
  assign count_o = count_q ^ 8'(mask_i);
endmodule
)";
  }
  RtlSources rtl(int step) const {
    RtlSources all{"counter", {folder / "counter.sv"}};
    all.parameters = {"Step=" + std::to_string(step)};
    return all;
  }
  /// What it says after a reset and `clocks`, with the mask 5.
  static std::uint64_t counted(const RtlSources& sources, int clocks) {
    rtl_library counter(rtl_plugin(sources));
    const auto port = [&](const char* name) {
      return static_cast<std::uint8_t*>(rtl_port_of(counter.model(), name).data);
    };
    *port("mask_i") = 5;
    *port("rst_ni") = 0;
    counter.eval();
    counter.rise();
    *port("rst_ni") = 1;
    for (int n = 0; n < clocks; ++n) {
      counter.eval();
      counter.rise();
    }
    counter.eval();
    return *port("count_o");
  }
  static std::string fault(const GateNetlist& netlist) {
    try {
      return "slack " +
             std::to_string(gate_timing(engine_of_unit("stacks"), "counter", netlist).slack());
    } catch (const RtlError& error) {
      return error.what();
    }
  }

  ScratchFolder folder;
};

TEST_F(GatesOfACounter, CountAsItsRtlDoes) {
  for (const std::string& kind : gate_kinds()) {
    EXPECT_EQ(counted(simulated_gates(rtl(3), kind, true), 30), (90u ^ 5u)) << kind;
    EXPECT_EQ(counted(simulated_gates(rtl(-1), kind, false), 7), (249u ^ 5u)) << kind;
  }
}

TEST_F(GatesOfACounter, SayWithWhatTheyWereMade) {
  const rtl_library gates(rtl_plugin(simulated_gates(rtl(3), GenericGates, false)));
  EXPECT_EQ(std::string(gates.model().parameters), "Step=3 ");
}

TEST_F(GatesOfACounter, RegistersAreSeenByName) {
  const auto names = [&](const std::string& kind) {
    const rtl_library gates(rtl_plugin(simulated_gates(rtl(3), kind, true)));
    std::vector<std::string> all;
    for (int n = 0; n < gates.model().signal_count; ++n)
      all.emplace_back(gates.model().signals[n].name);
    return all;
  };
  EXPECT_THAT(names(GenericGates), testing::Contains("count_q"));
  EXPECT_THAT(names(Osu018Gates), testing::Contains("u_cells.count_q[0]"));
}

TEST_F(GatesOfACounter, HaveFiguresAndASlack) {
  const GateNetlist netlist = gate_netlist(rtl(3), Osu018Gates);
  EXPECT_EQ(netlist.flip_flops, 8);
  EXPECT_GT(netlist.cells, 16);
  EXPECT_GE(netlist.area, netlist.cells * 16) << "of the smallest cell";
  const GateTiming timing = gate_timing(engine_of_unit("stacks"), "counter", netlist);
  EXPECT_GT(timing.ns, 0.3);
  EXPECT_NEAR(timing.slack(), 1000 / 50.4 - timing.ns, 1e-6);
  const GateTiming slower = gate_timing(engine_of_unit("sphere_tracer"), "counter", netlist);
  EXPECT_NEAR(slower.ns, timing.ns, 0.002);
  EXPECT_NEAR(slower.slack(), 1000 / 25.2 - slower.ns, 1e-6) << "its clock has half the speed";
}

TEST_F(GatesOfACounter, ConstantsHaveNoCellsAndTheWholeClock) {
  std::ofstream(folder / "counter.sv") << "module counter(output logic [1:0] one_o);\n"
                                          "  assign one_o = 2'd1;\nendmodule\n";
  const GateNetlist netlist = gate_netlist({"counter", {folder / "counter.sv"}}, Osu018Gates);
  EXPECT_EQ(netlist.cells, 0);
  EXPECT_EQ(netlist.area, 0);
  EXPECT_NEAR(gate_timing(engine_of_unit("stacks"), "counter", netlist).slack(), 1000 / 50.4, 1e-6);
}

// OpenSTA takes each of these, and ends with 0.
TEST_F(GatesOfACounter, ABrokenNetlistHasNoSlack) {
  GateNetlist netlist = gate_netlist(rtl(3), Osu018Gates);
  const std::string good = whole_file(netlist.file);
  EXPECT_THAT(fault(netlist), HasSubstr("slack 1"));
  const auto broken = [&](const std::string& text) {
    netlist.file = folder / "broken.gates";
    std::ofstream(netlist.file) << text;
    return fault(netlist);
  };
  std::string unknown = good;
  unknown.replace(unknown.find("  DFFPOSX1 "), 11, "  NOSUCHX1 ");
  EXPECT_THAT(broken(unknown), HasSubstr("module NOSUCHX1 not found.  Creating black box"));
  EXPECT_THAT(broken(good.substr(0, good.size() / 2)), HasSubstr("there is no longest path"));
  EXPECT_THAT(broken("// counter 8 40 900\nmodule other(); endmodule\n"),
              HasSubstr("there is no longest path"));
  EXPECT_THAT(broken(""), HasSubstr("there is no longest path"));
}

TEST_F(GatesOfACounter, AStaThatSaysNothingIsAFault) {
  const GateNetlist netlist = gate_netlist(rtl(3), Osu018Gates);
  const FakeTool silent("sta", "exit 0");
  EXPECT_THAT(fault(netlist), HasSubstr("sta has not found the WORST path of counter"));
}

TEST_F(GatesOfACounter, AnotherTextIsAnotherNetlist) {
  const std::string first = gate_netlist(rtl(3), GenericGates).file;
  EXPECT_EQ(gate_netlist(rtl(3), GenericGates).file, first);
  EXPECT_NE(gate_netlist(rtl(4), GenericGates).file, first);
  std::ofstream(folder / "counter.sv", std::ios::app) << "// saved\n";
  EXPECT_NE(gate_netlist(rtl(3), GenericGates).file, first);
}

TEST(GateWord, NamesKindAndFile) {
  const ScratchFolder folder;
  const std::string file = folder / "mine.sv";
  std::ofstream(file) << "module mine; endmodule\n";
  const auto read = [](const std::string& text) {
    const auto word = gate_word(text);
    return word ? word->kind + "|" + word->file : "";
  };
  EXPECT_EQ(read("gates"), "generic|");
  EXPECT_EQ(read("gates:generic"), "generic|");
  EXPECT_EQ(read("gates:osu018"), "osu018|");
  EXPECT_EQ(read("gates:" + file), "generic|" + file);
  EXPECT_EQ(read("gates:osu018:" + file), "osu018|" + file);
  for (const char* none : {"rtl", "gatesx", "gates.v", "", "GATES"}) EXPECT_EQ(read(none), "");
  for (const char* wrong : {"gates:", "gates:osu", "gates:osu018:", "gates:osu018:generic",
                            "gates:none.sv", "gates:list.f"})
    EXPECT_THROW(gate_word(wrong), UsageError) << wrong;
}

TEST(MarkedRegisters, AreThoseWithNamesOfTheSource) {
  const std::string mark = " /*verilator public_flat_rw*/ ;";
  EXPECT_EQ(with_marked_registers("  reg [3:0] a_q;\n"), "  reg [3:0] a_q" + mark + "\n");
  EXPECT_EQ(with_marked_registers("  wire \\g[0].a_q[1] ;\n"),
            "  wire \\g[0].a_q[1] " + mark + "\n");
  for (const char* none :
       {"  wire _12_;\n", "  wire \\_12_[3] ;\n", "  assign a = b;\n", "  reg a_q = 1'h0;\n"})
    EXPECT_EQ(with_marked_registers(none), none);
}

}  // namespace
}  // namespace racebeam
