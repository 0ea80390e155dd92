// RTL of the unit stacks that does in clock 500 what RTL should not.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/cli/program.h"

namespace racebeam {

/// `fault`: a statement of an always block, executed once.
inline std::string faulty_stacks(const std::string& fault) {
  std::string text = read_file(RACEBEAM_SOURCE_DIR "/rtl/beam/stacks.sv");
  const auto at = text.find("endmodule");
  if (at == std::string::npos) throw std::runtime_error("stacks.sv has no end");
  return text.insert(at,
                     "  int unsigned clocks_q = 0;\n"
                     "  always_ff @(posedge clk_i) begin\n"
                     "    clocks_q <= clocks_q + 1;\n"
                     "    if (clocks_q == 500) begin\n" +
                         fault +
                         "\n    end\n"
                         "  end\n");
}

/// A loop without a register, closed from clock 500 on.
inline std::string circular_stacks() {
  std::string text = read_file(RACEBEAM_SOURCE_DIR "/rtl/beam/stacks.sv");
  const std::string right = "    fread_o = '0;\n";
  const auto at = text.find(right);
  if (at == std::string::npos) throw std::runtime_error("stacks.sv has no fread_o");
  text.replace(at, right.size(),
               "    fread_o = '0;\n"
               "    if (swing) fread_o = '1;\n");
  return text.insert(text.find("endmodule"),
                     "  int unsigned clocks_q = 0;\n"
                     "  always_ff @(posedge clk_i) clocks_q <= clocks_q + 1;\n"
                     "  logic swing;\n"
                     "  assign swing = clocks_q >= 500 && !swing;\n");
}

}  // namespace racebeam
