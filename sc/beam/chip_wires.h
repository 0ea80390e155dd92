// chip_wires: all wires of the chip in one clock, settled, as plain numbers; by the names that they
// have in chip.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/base/fixed_point.h"

namespace racebeam {

struct chip_core;
struct knobs;

struct chip_wires {
  int rst_n, speed, no_interlace, x2, y, hsync_n, vsync_n, active, h_active, consume, line_end,
      active_start, frame_end, nav_line, angle, frame, scene_flags, palette, colours, shading_b,
      scene_interlace, lock, inverse, nav_reset, start_room, src, run, tracer_reset, load,
      load_zero, ext, copy_ext, idx_load, ext_sign, axis_mask, idx_start, i2_init, state, descend,
      climb, restart, emit, cur, leave, ray_signs, len_m1, idx2, i2, step, neg, copy_sub, push_en,
      step_size, sp, sd, line_done, top_tag, top_i2, fread, dec, mask, tag, wall, second, fwrite,
      fdata, hit_face, room, look_axis, look_way, look_signs, look_portal, neighbour, back, edges,
      nav_room, nav_axis, nav_portal, nav_negative, nav_move, nav_op, ack, starving, display, value,
      display_half, half, fill, uo;
  vec3 start, velocity, delta, dr1, dr2, corner, half_size, position, nav_position;
  int pwm;

  /// The wire at a port of a unit: of y_i it is y, of rst_ni rst_n, of dr2_y_i the y of dr2. Throws
  /// std::out_of_range.
  int& at(const std::string& port);
};

/// chip_core::clock(), which tells all wires before the edge.
void clock_wires(chip_core& chip, bool rst_n, const knobs& k, chip_wires& wires);

}  // namespace racebeam
