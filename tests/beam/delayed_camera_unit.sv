// delayed_camera_unit: camera_unit behind the registers of a delayed channel "line"; its pins are
// those of camera_unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module delayed_camera_unit #(
    parameter int Latency = 1,
    parameter int Capacity = 2,
    parameter int DrBits = 10,
    parameter int HeadStart = 0,
    parameter int DdrFractionBits = 9
) (
    input  wire logic clk_i,
    input  wire logic rst_ni,
    input  wire logic line_end_i,
    input  wire logic signed [9:0] y_i,
    output logic [1:0] src_o,
    input  wire logic [racebeam_pkg::AngleBits-1:0] angle_i,
    output logic run_o,
    output logic tracer_reset_o,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_x_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_y_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_z_i,
    output logic load_o,
    output logic load_zero_o,
    output logic ext_o,
    output logic [2:0] ext_sign_o,
    output logic [2:0] axis_mask_o,
    output logic signed [racebeam_pkg::DdrPortBits-1:0] delta_x_o,
    output logic signed [racebeam_pkg::DdrPortBits-1:0] delta_y_o,
    output logic signed [racebeam_pkg::DdrPortBits-1:0] delta_z_o,
    output logic copy_ext_o,
    input  wire logic step_i,
    output logic idx_load_o,
    output logic [racebeam_pkg::PixelBits-1:0] idx_start_o,
    output logic [racebeam_pkg::PixelBits-1:0] i2_init_o
);
  wire logic late_line_end;

  channel_delay #(
      .Latency(Latency),
      .Capacity(Capacity),
      .Width(1)
  ) u_channel_delay (
      .clk_i(clk_i),
      .clear_i(!rst_ni),
      .offer_valid_i(line_end_i),
      .offer_data_i(1'b0),
      .offer_ready_o(),
      .offer_ack_o(),
      .take_valid_o(late_line_end),
      .take_data_o(),
      .take_ready_i(1'b1)
  );

  camera_unit #(
      .DrBits(DrBits),
      .HeadStart(HeadStart),
      .DdrFractionBits(DdrFractionBits)
  ) u_camera_unit (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .line_end_i(late_line_end),
      .y_i(y_i),
      .src_o(src_o),
      .angle_i(angle_i),
      .run_o(run_o),
      .tracer_reset_o(tracer_reset_o),
      .dr2_x_i(dr2_x_i),
      .dr2_y_i(dr2_y_i),
      .dr2_z_i(dr2_z_i),
      .load_o(load_o),
      .load_zero_o(load_zero_o),
      .ext_o(ext_o),
      .ext_sign_o(ext_sign_o),
      .axis_mask_o(axis_mask_o),
      .delta_x_o(delta_x_o),
      .delta_y_o(delta_y_o),
      .delta_z_o(delta_z_o),
      .copy_ext_o(copy_ext_o),
      .step_i(step_i),
      .idx_load_o(idx_load_o),
      .idx_start_o(idx_start_o),
      .i2_init_o(i2_init_o)
  );
endmodule

`default_nettype wire
