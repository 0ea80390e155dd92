// Circuits are read and written, inputs of them held, registers taken out, and they run.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/aiger.h"

#include <gmock/gmock.h>

#include <string>

#include "sc/swap/rtl_library.h"

namespace racebeam {
namespace {

using testing::ElementsAre;

// Inputs 2 and 4, a register 6 that takes the gate 8; the output is input 4 inverted. The gate is
// given by what it is above its inputs: 4 and 2.
const std::string Head = "aig 4 2 1 1 1\n", Circuit = Head + "8\n5\n\x04\x02";

std::string held(const std::map<std::size_t, bool>& constants) {
  return aiger_of(with_constant_inputs(read_circuit(Circuit), constants));
}

TEST(AigerTest, IsWrittenAsItWasRead) {
  EXPECT_EQ(aiger_of(read_circuit(Circuit)), Circuit);
  EXPECT_EQ(aiger_of(read_circuit(Circuit + "i0 a\ni1 b\nc\nmade here\n")), Circuit);
  EXPECT_EQ(held({}), Circuit);
}

TEST(AigerTest, AGateReadsTheConstantAndNotTheInput) {
  EXPECT_EQ(held({{0, true}}), Head + "8\n5\n\x04\x03");
  EXPECT_EQ(held({{0, false}}), Head + "8\n5\n\x04\x04");
}

TEST(AigerTest, AnInvertedInputIsTheInvertedConstant) {
  EXPECT_EQ(held({{1, true}}), Head + "8\n0\n\x06\x01");
  EXPECT_EQ(held({{1, false}}), Head + "8\n1\n" + std::string("\x06\x02", 2));
}

TEST(AigerTest, WithoutRegistersTheirNextValuesAreOutputs) {
  const std::string step = "aig 4 3 0 2 1\n8\n5\n\x04\x02";
  EXPECT_EQ(aiger_of(without_registers(read_circuit(Circuit))), step);
  EXPECT_EQ(aiger_of(without_registers(read_circuit(step))), step);
}

TEST(AigerTest, AssertionsFailWhereTheyAreBad) {
  const AndCircuit circuit = read_circuit("aig 4 2 1 1 1 1\n8\n5\n7\n\x04\x02");
  EXPECT_THAT(circuit.outputs, ElementsAre(5));
  EXPECT_THAT(circuit.failing, ElementsAre(7));
  EXPECT_THAT(without_registers(circuit).failing, ElementsAre(7));
  EXPECT_THAT(with_constant_inputs(read_circuit("aig 1 1 0 0 0 1\n3\n"), {{0, true}}).failing,
              ElementsAre(False));
  EXPECT_EQ(aiger_of(circuit), Circuit) << "they are not written";
}

TEST(AigerTest, GatesAreAddedWhereTheyAreNeeded) {
  AndCircuit circuit = read_circuit(Circuit);
  EXPECT_EQ(circuit.all(2, 3), False);
  EXPECT_EQ(circuit.all(2, True), 2u);
  EXPECT_EQ(circuit.any(2, False), 2u);
  EXPECT_EQ(circuit.gates.size(), 1u);
  EXPECT_EQ(circuit.all(2, 6), 10u);
  EXPECT_EQ(circuit.any(2, 6), 13u);
  EXPECT_THAT(circuit.gates, ElementsAre(ElementsAre(4, 2), ElementsAre(2, 6), ElementsAre(3, 7)));
}

TEST(AigerTest, AConeHasOnlyTheGatesThatItNeeds) {
  AndCircuit circuit;
  circuit.inputs = 3;
  const Literal both = circuit.all(2, 4), other = circuit.all(4, 6);
  const AndCircuit cone = cone_of(circuit, {circuit.all(other, 3) ^ 1, 5});
  EXPECT_EQ(cone.inputs, 3u);
  EXPECT_THAT(cone.gates, ElementsAre(ElementsAre(4, 6), ElementsAre(8, 3)));
  EXPECT_THAT(cone.outputs, ElementsAre(11, 5));
  EXPECT_EQ(cone_of(circuit, {both}).gates.size(), 1u);
}

TEST(AigerTest, LanesRunAsTheCircuitSays) {
  const AndCircuit circuit = read_circuit(Circuit);
  CircuitLanes lanes(circuit);
  lanes.input(0) = 0b1100;
  lanes.input(1) = 0b1010;
  lanes.settle();
  EXPECT_EQ(lanes.of(circuit.outputs[0]) & 0xf, 0b0101u);
  EXPECT_EQ(lanes.register_at(0), 0u);
  lanes.clock();
  EXPECT_EQ(lanes.register_at(0), 0b1000u);
}

TEST(AigerTest, OtherFilesAreRefused) {
  for (const std::string& text :
       {std::string(), std::string("aag 0 0 0 0 0\n"), Circuit.substr(0, Head.size() + 5),
        std::string("aig 4 2 1 1 1 0 1\n8\n5\n7\n\x04\x02"),  // a constraint
        std::string("aig 4 2 1 1 1\n8 1\n5\n\x04\x02")})      // begins with 1
    EXPECT_THROW(read_circuit(text), RtlError) << text;
}

}  // namespace
}  // namespace racebeam
