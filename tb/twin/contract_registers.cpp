// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/contract_registers.h"

#include "tb/scene/engines.h"

namespace racebeam {

namespace {

constexpr const char* Told = "means nothing while the valid beside it is 0";
constexpr const char* Loaded = "goes on without reset; loaded before it counts";

const std::vector<Unreset> Rows = {
    {"vga_timing", "vs_q", "vs is not reset, 0 at power-up"},
    {"pwm_sound", "pwm_q", "the PWM counter is not reset, 0 at power-up"},
    {"ray_stepper", "tracer_reset_i", "resets nothing: it says who steers; camera_unit loads zero"},
    {"subdivider", "idx2_q", "idx2 is camera_unit's, loaded at the start of a line"},
    {"decision_datapath", "dom_prev_q", Loaded},
    {"decision_datapath", "dom_q", Loaded},
    {"decision_datapath", "face_q", Loaded},
    {"decision_datapath", "hit_face_q", Loaded},
    {"frame_scanout", "hsync_no", "the syncs go on as without reset"},
    {"frame_scanout", "vsync_no", "the syncs go on as without reset"},
    {"write_buffer", "take_address_o", Told},
    {"write_buffer", "take_data_o", Told},
    {"block_convert", "fixed_o", "what is of a sphere is without reset"},
    {"block_core", "word_address_o", Told},
    {"block_core", "word_o", Told},
    {"block_core", "u_block_lanes.g_lane.u_block_spheres",
     "the memory of the spheres; a sphere is written before spheres_i counts it"},
    {"voxel_leaf", "samples_q", "of a voxel; start_i sets it to 0"},
    {"voxel_leaf", "t_q", "along a ray; start_i loads it"},
    {"voxel_setup", "inverse_x_o", "the dividers wait for start_i"},
    {"voxel_setup", "inverse_y_o", "the dividers wait for start_i"},
    {"voxel_setup", "inverse_z_o", "the dividers wait for start_i"},
    {"voxel_shade", "colour_o", "of a ray; loaded with it"},
    {"voxel_walker", "ray_x_o", Loaded},
    {"voxel_walker", "ray_y_o", Loaded},
    {"voxel_walker", "ray_z_o", Loaded},
    {"voxel_walker", "step_o", Loaded},
    {"voxel_walker", "level_o", Loaded},
    {"voxel_walker", "from_x_o", Loaded},
    {"voxel_walker", "from_y_o", Loaded},
    {"voxel_walker", "from_z_o", Loaded},
    {"voxel_walker", "t_out_o", Loaded},
    {"voxel_walker", "t_o", Loaded},
    {"voxel_walker", "x_o", Loaded},
    {"voxel_walker", "y_o", Loaded},
    {"voxel_walker", "z_o", Loaded},
};

enum class Kind { Register, Output, Input };

Kind kind_of(const std::string& name) {
  const auto ends = [&](const std::string& end) {
    return name.size() > end.size() && name.rfind(end) == name.size() - end.size();
  };
  return ends("_o") || ends("_no") ? Kind::Output : ends("_i") ? Kind::Input : Kind::Register;
}

std::vector<Unreset> rows_of(const std::string& unit, Kind kind) {
  std::vector<Unreset> rows;
  for (const Unreset& row : Rows)
    if (unit == row.unit && kind_of(row.name) == kind) rows.push_back(row);
  return rows;
}

/// The registers of all units of `chip`, as its RTL has them.
std::vector<Unreset> registers_of_chip(const engine& chip) {
  std::vector<Unreset> rows;
  for (const std::string& unit : chip.unit_names(false))
    for (const Unreset& row : rows_of(unit, Kind::Register))
      rows.push_back({chip.top, chip.unit(unit)->path() + "." + row.name, row.reason});
  return rows;
}

/// Without what numbers elements and generate blocks.
std::string without_indices(const std::string& name) {
  std::string text;
  int depth = 0;
  for (const char letter : name) {
    depth += letter == '[';
    if (depth == 0) text += letter;
    depth -= letter == ']';
  }
  return text;
}

}  // namespace

bool is_named(const Unreset& row, const std::string& name) {
  const std::string plain = without_indices(name), wanted = without_indices(row.name);
  return plain == wanted || plain.rfind(wanted + ".", 0) == 0;
}

std::vector<Unreset> contract_registers(const std::string& unit) {
  for (const engine* built : engines())
    if (unit == built->top) return registers_of_chip(*built);
  return rows_of(unit, Kind::Register);
}
std::vector<Unreset> contract_ports(const std::string& unit) { return rows_of(unit, Kind::Output); }

std::string contract_reason(const std::string& unit, const std::string& name) {
  for (const std::vector<Unreset>& rows :
       {contract_registers(unit), contract_ports(unit), rows_of(unit, Kind::Input)})
    for (const Unreset& row : rows)
      if (is_named(row, name)) return row.reason;
  return "";
}

}  // namespace racebeam
