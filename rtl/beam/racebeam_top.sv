// racebeam_top: all units wired under one clock.
// Contract: sc/beam/chip.h, whose wires these are.
//
// No arithmetic: a wire has the name of the port that drives it, without its suffix;
// a parameter that of the units that have it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module racebeam_top #(
    parameter int IntervalStackDepth = 4,
    parameter int FaceStackDepth = 9,
    parameter int MaxRoomDepth = 8,
    parameter int FifoEntries = 10,
    parameter int FifoShortLengthBits = 6,
    parameter int HurryThreshold = 32,
    parameter int DrBits = 10,
    parameter int CornerBits = 12,
    parameter int CornerFactorBits = 8,
    parameter int PartialProductsCut = 5,
    parameter int Bisection = 0,
    parameter int Stepping = 0,
    parameter int Dithering = 1,
    parameter int ClocksPerPixel = 2,
    parameter int SkipSharedEdges = 0,
    parameter int HeadStart = 0,
    parameter int SteppingFractionBits = 9,
    parameter int DdrFractionBits = 9,
    parameter int CornerRounding = 0,
    parameter int FifoMerge = 1,
    parameter int NavigatorBits = 9,
    parameter int FreeFlight = 0,
    parameter int PortalsPerFace = 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic [2:0] speed_i,
    input wire logic no_interlace_i,
    output logic [7:0] uo_o,  // {hsync, B0, G0, R0, vsync, B1, G1, R1}
    output logic pwm_o
);
  /* verilator lint_off UNUSEDSIGNAL */  // h_active, sd, line_done and fill are for monitors
  // vga_timing
  wire logic [10:0] x2;
  wire logic [9:0] y;
  wire logic hsync_n, vsync_n, active, h_active;
  wire logic consume, line_end, active_start;
  wire logic frame_end, nav_line;
  // sequencer
  wire logic [racebeam_pkg::AngleBits-1:0] angle;
  wire logic [racebeam_pkg::FrameBits-1:0] frame;
  wire logic [5:0] scene_flags;
  wire logic [1:0] palette;
  wire logic [racebeam_pkg::ColoursBits-1:0] colours;
  wire logic shading_b, scene_interlace, lock;
  wire logic inverse, nav_reset;
  wire logic [racebeam_pkg::NavigatorPortBits-1:0] start_x, start_y, start_z;
  wire logic [racebeam_pkg::RoomPortBits-1:0] start_room;
  wire logic [racebeam_pkg::VelocityPortBits-1:0] velocity_x, velocity_y, velocity_z;
  // camera_unit
  wire logic [1:0] src;
  wire logic run, tracer_reset;
  wire logic load, load_zero, ext, copy_ext, idx_load;
  wire logic [2:0] ext_sign, axis_mask;
  wire logic [racebeam_pkg::DdrPortBits-1:0] delta_x, delta_y, delta_z;
  wire logic [racebeam_pkg::PixelBits-1:0] idx_start, i2_init;
  // ray_stepper
  wire logic [racebeam_pkg::DrPortBits-1:0] dr1_x, dr1_y, dr1_z;
  wire logic [racebeam_pkg::DrPortBits-1:0] dr2_x, dr2_y, dr2_z;
  // subdivider
  wire logic [1:0] state;
  wire logic descend, climb, restart, emit;
  wire logic [3:0] cur;
  wire logic [1:0] leave;
  wire logic [2:0] ray_signs;
  wire logic [racebeam_pkg::PixelBits-1:0] len_m1, idx2, i2;
  wire logic step, neg, copy_sub, push_en;
  wire logic [10:0] step_size;
  wire logic [racebeam_pkg::StackPointerPortBits-1:0] sp;
  wire logic [racebeam_pkg::StackCountPortBits-1:0] sd;
  wire logic line_done;
  // stacks
  wire logic [racebeam_pkg::TagPortBits-1:0] top_tag;
  wire logic [racebeam_pkg::PixelBits-1:0] top_i2;
  wire logic [racebeam_pkg::FacePortBits-1:0] fread;
  // decision_datapath
  wire logic [3:0] dec, mask;
  wire logic [racebeam_pkg::TagPortBits-1:0] tag;
  wire logic wall, second, fwrite;
  wire logic [racebeam_pkg::FacePortBits-1:0] fdata;
  wire logic [1:0] hit_face;
  wire logic [racebeam_pkg::RoomPortBits-1:0] room;
  wire logic [1:0] look_axis, look_way;
  wire logic [2:0] look_signs;
  wire logic [racebeam_pkg::PortalBits-1:0] look_portal;
  wire logic [racebeam_pkg::CornerPortBits-1:0] corner_x, corner_y, corner_z;
  // scene
  wire logic [racebeam_pkg::CornerPortBits-1:0] half_size_x, half_size_y, half_size_z;
  wire logic [racebeam_pkg::CornerPortBits-1:0] position_x, position_y, position_z;
  wire logic [racebeam_pkg::RoomPortBits-1:0] neighbour;
  wire logic [racebeam_pkg::PortalBits-1:0] back;
  wire logic [3:0] edges;
  // navigator
  wire logic [racebeam_pkg::NavigatorPortBits-1:0] nav_position_x, nav_position_y, nav_position_z;
  wire logic [racebeam_pkg::RoomPortBits-1:0] nav_room;
  wire logic [1:0] nav_axis;
  wire logic [racebeam_pkg::PortalBits-1:0] nav_portal;
  wire logic nav_negative, nav_move;
  wire logic [2:0] nav_op;
  // interval_fifo, pixel_output
  wire logic ack, starving;
  wire logic [1:0] display, value;
  wire logic display_half, half;
  wire logic [6:0] fill;
  /* verilator lint_on UNUSEDSIGNAL */

  vga_timing #(
      .ClocksPerPixel(ClocksPerPixel)
  ) u_vga_timing (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .speed_i(speed_i),
      .hsync_no(hsync_n),
      .vsync_no(vsync_n),
      .x2_o(x2),
      .y_o(y),
      .active_o(active),
      .h_active_o(h_active),
      .consume_o(consume),
      .line_end_o(line_end),
      .active_start_o(active_start),
      .frame_end_o(frame_end),
      .nav_line_o(nav_line)
  );

  sequencer #(
      .DrBits(DrBits)
  ) u_sequencer (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .frame_end_i(frame_end),
      .y_i(y),
      .run_i(run),
      .src_i(src),
      .angle_o(angle),
      .dr2_y_i(dr2_y),
      .frame_o(frame),
      .scene_flags_o(scene_flags),
      .palette_o(palette),
      .colours_o(colours),
      .shading_b_o(shading_b),
      .scene_interlace_o(scene_interlace),
      .lock_o(lock),
      .inverse_o(inverse),
      .start_x_o(start_x),
      .start_y_o(start_y),
      .start_z_o(start_z),
      .start_room_o(start_room),
      .velocity_x_o(velocity_x),
      .velocity_y_o(velocity_y),
      .velocity_z_o(velocity_z),
      .nav_reset_o(nav_reset)
  );

  camera_unit #(
      .DrBits(DrBits),
      .HeadStart(HeadStart),
      .DdrFractionBits(DdrFractionBits)
  ) u_camera_unit (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .line_end_i(line_end),
      .y_i(y),
      .src_o(src),
      .angle_i(angle),
      .run_o(run),
      .tracer_reset_o(tracer_reset),
      .dr2_x_i(dr2_x),
      .dr2_y_i(dr2_y),
      .dr2_z_i(dr2_z),
      .load_o(load),
      .load_zero_o(load_zero),
      .ext_o(ext),
      .ext_sign_o(ext_sign),
      .axis_mask_o(axis_mask),
      .delta_x_o(delta_x),
      .delta_y_o(delta_y),
      .delta_z_o(delta_z),
      .copy_ext_o(copy_ext),
      .step_i(step),
      .idx_load_o(idx_load),
      .idx_start_o(idx_start),
      .i2_init_o(i2_init)
  );

  navigator #(
      .NavigatorBits(NavigatorBits),
      .FreeFlight(FreeFlight),
      .PortalsPerFace(PortalsPerFace)
  ) u_navigator (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .nav_reset_i(nav_reset),
      .nav_line_i(nav_line),
      .active_start_i(active_start),
      .start_x_i(start_x),
      .start_y_i(start_y),
      .start_z_i(start_z),
      .start_room_i(start_room),
      .corner_x_i(corner_x),
      .corner_y_i(corner_y),
      .corner_z_i(corner_z),
      .room_i(room),
      .nav_position_x_o(nav_position_x),
      .nav_position_y_o(nav_position_y),
      .nav_position_z_o(nav_position_z),
      .nav_room_o(nav_room),
      .nav_axis_o(nav_axis),
      .nav_portal_o(nav_portal),
      .nav_negative_o(nav_negative),
      .nav_op_o(nav_op),
      .nav_move_o(nav_move)
  );

  ray_stepper #(
      .DrBits(DrBits),
      .Bisection(Bisection),
      .Stepping(Stepping),
      .SteppingFractionBits(SteppingFractionBits)
  ) u_ray_stepper (
      .clk_i(clk_i),
      .tracer_reset_i(tracer_reset),
      .load_i(load),
      .load_zero_i(load_zero),
      .ext_i(ext),
      .ext_sign_i(ext_sign),
      .axis_mask_i(axis_mask),
      .delta_x_i(delta_x),
      .delta_y_i(delta_y),
      .delta_z_i(delta_z),
      .copy_ext_i(copy_ext),
      .step_i(step),
      .neg_i(neg),
      .step_size_i(step_size),
      .idx2_i(idx2),
      .copy_sub_i(copy_sub),
      .dr1_x_o(dr1_x),
      .dr1_y_o(dr1_y),
      .dr1_z_o(dr1_z),
      .dr2_x_o(dr2_x),
      .dr2_y_o(dr2_y),
      .dr2_z_o(dr2_z)
  );

  subdivider #(
      .IntervalStackDepth(IntervalStackDepth),
      .HurryThreshold(HurryThreshold),
      .Bisection(Bisection),
      .PortalsPerFace(PortalsPerFace)
  ) u_subdivider (
      .clk_i(clk_i),
      .tracer_reset_i(tracer_reset),
      .idx_load_i(idx_load),
      .idx_start_i(idx_start),
      .i2_init_i(i2_init),
      .state_o(state),
      .dec_i(dec),
      .mask_i(mask),
      .wall_i(wall),
      .second_i(second),
      .tag_i(tag),
      .descend_o(descend),
      .climb_o(climb),
      .cur_o(cur),
      .leave_o(leave),
      .ray_signs_o(ray_signs),
      .restart_o(restart),
      .emit_o(emit),
      .len_m1_o(len_m1),
      .ack_i(ack),
      .starving_i(starving),
      .step_o(step),
      .neg_o(neg),
      .step_size_o(step_size),
      .idx2_o(idx2),
      .copy_sub_o(copy_sub),
      .push_en_o(push_en),
      .i2_o(i2),
      .sp_o(sp),
      .sd_o(sd),
      .top_tag_i(top_tag),
      .top_i2_i(top_i2),
      .lock_i(lock),
      .consume_i(consume),
      .line_done_o(line_done)
  );

  stacks #(
      .IntervalStackDepth(IntervalStackDepth),
      .FaceStackDepth(FaceStackDepth),
      .PortalsPerFace(PortalsPerFace)
  ) u_stacks (
      .clk_i(clk_i),
      .push_en_i(push_en),
      .tag_i(tag),
      .i2_i(i2),
      .sp_i(sp),
      .top_tag_o(top_tag),
      .top_i2_o(top_i2),
      .fwrite_i(fwrite),
      .fdata_i(fdata),
      .fread_o(fread)
  );

  decision_datapath #(
      .DrBits(DrBits),
      .CornerBits(CornerBits),
      .CornerFactorBits(CornerFactorBits),
      .PartialProductsCut(PartialProductsCut),
      .CornerRounding(CornerRounding),
      .MaxRoomDepth(MaxRoomDepth),
      .FaceStackDepth(FaceStackDepth),
      .SkipSharedEdges(SkipSharedEdges),
      .FreeFlight(FreeFlight),
      .PortalsPerFace(PortalsPerFace)
  ) u_decision_datapath (
      .clk_i(clk_i),
      .tracer_reset_i(tracer_reset),
      .nav_line_i(nav_line),
      .active_start_i(active_start),
      .y_i(y),
      .no_interlace_i(no_interlace_i),
      .scene_interlace_i(scene_interlace),
      .velocity_x_i(velocity_x),
      .velocity_y_i(velocity_y),
      .velocity_z_i(velocity_z),
      .nav_position_x_i(nav_position_x),
      .nav_position_y_i(nav_position_y),
      .nav_position_z_i(nav_position_z),
      .nav_room_i(nav_room),
      .nav_axis_i(nav_axis),
      .nav_portal_i(nav_portal),
      .nav_negative_i(nav_negative),
      .nav_op_i(nav_op),
      .nav_move_i(nav_move),
      .corner_x_o(corner_x),
      .corner_y_o(corner_y),
      .corner_z_o(corner_z),
      .dr1_x_i(dr1_x),
      .dr1_y_i(dr1_y),
      .dr1_z_i(dr1_z),
      .dr2_x_i(dr2_x),
      .dr2_y_i(dr2_y),
      .dr2_z_i(dr2_z),
      .state_i(state),
      .dec_o(dec),
      .mask_o(mask),
      .tag_o(tag),
      .wall_o(wall),
      .second_o(second),
      .descend_i(descend),
      .climb_i(climb),
      .cur_i(cur),
      .leave_i(leave),
      .ray_signs_i(ray_signs),
      .restart_i(restart),
      .top_tag_i(top_tag),
      .fread_i(fread),
      .fwrite_o(fwrite),
      .fdata_o(fdata),
      .room_o(room),
      .look_axis_o(look_axis),
      .look_signs_o(look_signs),
      .look_portal_o(look_portal),
      .look_way_o(look_way),
      .half_size_x_i(half_size_x),
      .half_size_y_i(half_size_y),
      .half_size_z_i(half_size_z),
      .position_x_i(position_x),
      .position_y_i(position_y),
      .position_z_i(position_z),
      .neighbour_i(neighbour),
      .back_i(back),
      .edges_i(edges),
      .hit_face_o(hit_face)
  );

  scene #(
      .SkipSharedEdges(SkipSharedEdges)
  ) u_scene (
      .scene_flags_i(scene_flags),
      .room_i(room),
      .look_axis_i(look_axis),
      .look_signs_i(look_signs),
      .look_portal_i(look_portal),
      .look_way_i(look_way),
      .half_size_x_o(half_size_x),
      .half_size_y_o(half_size_y),
      .half_size_z_o(half_size_z),
      .position_x_o(position_x),
      .position_y_o(position_y),
      .position_z_o(position_z),
      .neighbour_o(neighbour),
      .back_o(back),
      .edges_o(edges)
  );

  interval_fifo #(
      .FifoEntries(FifoEntries),
      .FifoShortLengthBits(FifoShortLengthBits),
      .FifoMerge(FifoMerge),
      .Dithering(Dithering)
  ) u_interval_fifo (
      .clk_i(clk_i),
      .tracer_reset_i(tracer_reset),
      .emit_i(emit),
      .len_m1_i(len_m1),
      .value_i(value),
      .half_i(half),
      .ack_o(ack),
      .starving_o(starving),
      .consume_i(consume),
      .display_o(display),
      .display_half_o(display_half),
      .fill_o(fill)
  );

  pixel_output #(
      .Dithering(Dithering),
      .DrBits(DrBits)
  ) u_pixel_output (
      .hit_face_i(hit_face),
      .ray_signs_i(ray_signs),
      .y_i(y),
      .shading_b_i(shading_b),
      .starving_i(starving),
      .value_o(value),
      .half_o(half),
      .display_i(display),
      .display_half_i(display_half),
      .x2_i(x2),
      .lock_i(lock),
      .dr2_x_i(dr2_x),
      .dr2_y_i(dr2_y),
      .dr2_z_i(dr2_z),
      .inverse_i(inverse),
      .palette_i(palette),
      .colours_i(colours),
      .active_i(active),
      .hsync_ni(hsync_n),
      .vsync_ni(vsync_n),
      .uo_o(uo_o)
  );

  pwm_sound u_pwm_sound (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .speed_i(speed_i),
      .pwm_o(pwm_o),
      .x2_i(x2),
      .y_i(y),
      .frame_i(frame)
  );

`ifndef SYNTHESIS
  // The exception of timing in sound_voice.sdc. The phase changes in clocks 0 and 1 of a slot.
  wire logic [10+5+racebeam_pkg::FrameBits:0] given = {x2[10:5], y, frame};
  always_ff @(posedge clk_i)
    if (rst_ni && ClocksPerPixel == 2 && x2[4:0] == 5'd29)
      voice_has_settled : assert (
          given == $past(given, 1) && given == $past(given, 2) && given == $past(given, 3));
`endif
endmodule

`default_nettype wire
