// RtlBench: plug-ins of a small module whose body a test writes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include "sc/swap/rtl_library.h"
#include "tb/verilate/rtl_plugin.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {

class RtlBench : public testing::Test {
 protected:
  /// A plug-in of the module mine with this body; its inputs are a_i and b_i, its output out_o.
  std::string plugin(const std::string& body) {
    std::ofstream(folder / "mine.sv") << "module mine (input wire logic clk_i,\n"
                                         "  input wire logic [7:0] a_i, b_i,\n"
                                         "  output logic [31:0] out_o);\n"
                                      << body << "\nendmodule\n";
    RtlSources sources;
    sources.top = "mine";
    sources.files = {folder / "mine.sv"};
    return rtl_plugin(sources);
  }
  static void put(const rtl_library& rtl, const char* input, std::uint8_t value) {
    *static_cast<std::uint8_t*>(rtl_port_of(rtl.model(), input).data) = value;
  }
  static std::uint32_t out(rtl_library& rtl) {
    rtl.eval();
    std::uint32_t value = 0;
    std::memcpy(&value, rtl_port_of(rtl.model(), "out_o").data, sizeof value);
    return value;
  }

  ScratchFolder folder;
};

}  // namespace racebeam
