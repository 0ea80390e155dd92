// The units of the sphere tracer that have RTL.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// All units of sphere_chip but its memory.
inline const std::vector<std::string>& sphere_units() {
  static const std::vector<std::string> units = {
      "vga_timing",    "sphere_inputs", "sphere_host_link", "sphere_table", "plane_table",
      "sphere_raygen", "vector_unit",   "root_unit",        "divider_unit", "sphere_tracer",
      "sphere_shader", "write_buffer",  "store_arbiter",    "frame_scanout"};
  return units;
}

}  // namespace racebeam
