// Behaviour of the standard cells of SkyWater's sky130_fd_sc_hd, for chips that name some of them.
//
// Logic only, from what the cells are named for: no delays, no X, supplies always on. Each cell in
// every drive strength; supply pins (VPWR, VGND, VPB, VNB) come last and may be left open.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct Sky130Cell {
  std::string name;  ///< without library and drive strength, such as "nand2"
  std::vector<std::string> outputs, inputs;
  std::string body;  ///< Verilog
};

const std::vector<Sky130Cell>& sky130_cells();

/// "sky130_fd_sc_hd__nand2_1"
std::string sky130_module_name(const std::string& cell, int strength);

/// All cells as Verilog modules, a library for Verilator.
std::string sky130_library();

}  // namespace racebeam
