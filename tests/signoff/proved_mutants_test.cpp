// A file of proofs holds for the circuit that they were asked of, and for no other one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/proved_mutants.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

TEST(ProvedMutantsTest, HoldForTheirCircuitAlone) {
  const ScratchFolder folder;
  const std::string file = folder / "mine.proved";
  const MutantNames names = {"inv $procmux$85 Y[5]", "cnot1 $procmux$85 Y[5] 1"};
  std::ofstream(file) << proved_text("mine", "0123", names);
  EXPECT_EQ(read_proved(file, "0123"), names);
  EXPECT_EQ(read_proved(file, "012"), MutantNames{});
  EXPECT_EQ(read_proved(folder / "none.proved", "0123"), MutantNames{});
}

}  // namespace
}  // namespace racebeam
