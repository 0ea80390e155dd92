// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/contract_registers.h"

namespace racebeam {

namespace {

constexpr const char* Told = "means nothing while the valid beside it is 0";
constexpr const char* Loaded = "goes on without reset; loaded before it counts";

constexpr Unreset Rows[] = {
    {"vga_timing", "vs_q", "vs is not reset, 0 at power-up"},
    {"pwm_sound", "pwm_q", "the PWM counter is not reset, 0 at power-up"},
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
    {"block_core", "word_data_o", Told},
    {"voxel_leaf", "samples_o", Loaded},
    {"voxel_leaf", "t_o", Loaded},
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

bool is_port(const std::string& name) {
  return name.size() > 2 && (name.rfind("_o") == name.size() - 2 ||
                             (name.size() > 3 && name.rfind("_no") == name.size() - 3));
}

std::vector<Unreset> rows_of(const std::string& unit, bool ports) {
  std::vector<Unreset> rows;
  for (const Unreset& row : Rows)
    if (unit == row.unit && is_port(row.name) == ports) rows.push_back(row);
  return rows;
}

}  // namespace

std::vector<Unreset> contract_registers(const std::string& unit) { return rows_of(unit, false); }
std::vector<Unreset> contract_ports(const std::string& unit) { return rows_of(unit, true); }

std::string contract_reason(const std::string& unit, const std::string& name) {
  for (const Unreset& row : Rows)
    if (unit == row.unit && name == row.name) return row.reason;
  return "";
}

}  // namespace racebeam
