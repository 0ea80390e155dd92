// The bits of memories that something is written to, by all of its ports once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/memory_bits.h"

#include <gtest/gtest.h>

#include "tb/base/whole_file.h"
#include "tb/signoff/yosys_sources.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

TEST(MemoryBitsTest, TablesDoNotCount) {
  const ScratchFolder folder;
  run_yosys(
      "read_verilog -sv <<EOT\n"
      "module mine (input clk, input [3:0] at, input [4:0] a, output [7:0] b, output [4:0] c);\n"
      "reg [7:0] table_q[0:15];\n"
      "integer n;\n"
      "initial for (n = 0; n < 16; n = n + 1) table_q[n] = 3 * n;\n"
      "reg [4:0] kept_q[0:11];\n"
      "always @(posedge clk) begin\n"
      "  kept_q[at] <= a;\n"
      "  if (a[0]) kept_q[at + 1] <= 0;\n"
      "end\n"
      "assign b = table_q[at];\n"
      "assign c = kept_q[at];\n"
      "endmodule\n"
      "EOT\n"
      "proc\nwrite_rtlil mine.il\n",
      folder.path(), "mine");
  EXPECT_EQ(written_bits(whole_file(folder / "mine.il")), 12u * 5u);
}

}  // namespace
}  // namespace racebeam
