// Circuits whose inputs are held, so that what reads them reads constants, and whose registers are
// taken out.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/aiger.h"

#include <gtest/gtest.h>

#include <string>

#include "sc/swap/rtl_library.h"

namespace racebeam {
namespace {

// Inputs 2 and 4, a register 6 that takes the gate 8; the output is input 4 inverted. The gate is
// given by what it is above its inputs: 4 and 2.
const std::string Head = "aig 4 2 1 1 1\n", Names = "i0 a\ni1 b\nc\nmade here\n";
const std::string Circuit = Head + "8\n5\n\x04\x02" + Names;

TEST(AigerTest, WithoutConstantsItIsTheSame) {
  EXPECT_EQ(with_constant_inputs(Circuit, {}), Circuit);
}

TEST(AigerTest, AGateReadsTheConstantAndNotTheInput) {
  EXPECT_EQ(with_constant_inputs(Circuit, {{0, true}}), Head + "8\n5\n\x04\x03" + Names);
  EXPECT_EQ(with_constant_inputs(Circuit, {{0, false}}), Head + "8\n5\n\x04\x04" + Names);
}

TEST(AigerTest, AnInvertedInputIsTheInvertedConstant) {
  EXPECT_EQ(with_constant_inputs(Circuit, {{1, true}}), Head + "8\n0\n\x06\x01" + Names);
  EXPECT_EQ(with_constant_inputs(Circuit, {{1, false}}),
            Head + "8\n1\n" + std::string("\x06\x02", 2) + Names);
}

TEST(AigerTest, WithoutRegistersTheirNextValuesAreOutputs) {
  const std::string step = "aig 4 3 0 2 1\n8\n5\n\x04\x02";
  EXPECT_EQ(without_registers(Circuit), step);
  EXPECT_EQ(without_registers("aig 4 2 1 1 1\n8 1\n5\n\x04\x02"), step) << "it begins with 1";
  EXPECT_EQ(without_registers(step), step);
}

TEST(AigerTest, OtherFilesAreRefused) {
  EXPECT_THROW(with_constant_inputs("", {}), RtlError);
  EXPECT_THROW(without_registers("aag 0 0 0 0 0\n"), RtlError);
  EXPECT_THROW(without_registers(Circuit.substr(0, Head.size() + 5)), RtlError);
  EXPECT_THROW(with_constant_inputs("aag 0 0 0 0 0\n", {}), RtlError);
  EXPECT_THROW(with_constant_inputs(Circuit.substr(0, Head.size() + 5), {}), RtlError);
  EXPECT_THROW(with_constant_inputs("aig 4 2 1 1 1 1\n8\n5\n\x04\x02", {}), RtlError)
      << "bad states";
}

}  // namespace
}  // namespace racebeam
