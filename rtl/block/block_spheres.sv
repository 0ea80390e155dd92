// block_spheres: the spheres of one lane.
// Contract: sc/block/block_spheres.h
//
// Entries are flip-flops without reset; a 2-state simulation starts them at 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_spheres #(
    parameter int Lanes = 4
) (
    // Clock
    input  wire logic clk_i,
    // block_convert
    input  wire logic write_i,
    input  wire logic [block_pkg::BlockFieldBits-1:0] field_i,  // block_field
    input  wire logic [block_pkg::BlockIndexBits-1:0] index_i,  // in this lane
    input  wire logic [block_pkg::BlockBits-1:0] value_i,
    input  wire logic [block_pkg::BlockBits-1:0] eye_k_i,  // signed, of the axis of a centre
    // block_core
    input  wire logic [block_pkg::BlockIndexBits-1:0] group_i,
    output logic [block_pkg::BlockBits-1:0] pose_x_o,  // signed, from the centre to the eye
    output logic [block_pkg::BlockBits-1:0] pose_y_o,
    output logic [block_pkg::BlockBits-1:0] pose_z_o,
    output logic [block_pkg::BlockBits-1:0] rv_o,  // signed
    output logic [block_pkg::BlockBits-1:0] centre_x_o,  // signed
    output logic [block_pkg::BlockBits-1:0] centre_y_o,
    output logic [block_pkg::BlockBits-1:0] centre_z_o,
    output logic [block_pkg::BlockBits-1:0] radius_o,
    output logic [block_pkg::BlockBits-1:0] radius2_o,
    output logic [block_pkg::BlockBits-1:0] red_o,
    output logic [block_pkg::BlockBits-1:0] green_o,
    output logic [block_pkg::BlockBits-1:0] blue_o
);
  localparam int Bits = block_pkg::BlockBits;
  localparam int Entries = block_pkg::BlockEntries / Lanes;
  localparam int PlaceBits = Entries > 1 ? $clog2(Entries) : 1;

  typedef logic [Bits-1:0] number;

  number pose_x_q[Entries], pose_y_q[Entries], pose_z_q[Entries], rv_q[Entries];
  number centre_x_q[Entries], centre_y_q[Entries], centre_z_q[Entries];
  number radius_q[Entries], radius2_q[Entries];
  number red_q[Entries], green_q[Entries], blue_q[Entries];

  /* verilator lint_off UNUSEDSIGNAL */  // more lanes, fewer entries
  wire logic [block_pkg::BlockIndexBits-1:0] index = index_i;
  wire logic [block_pkg::BlockIndexBits-1:0] group = group_i;
  /* verilator lint_on UNUSEDSIGNAL */
  wire logic [PlaceBits-1:0] to = index[PlaceBits-1:0];
  wire logic [PlaceBits-1:0] from = group[PlaceBits-1:0];
  wire number pose = eye_k_i - value_i;

  always_ff @(posedge clk_i) begin
    if (write_i) begin
      unique case (field_i)
        block_pkg::BlockCentreX: {centre_x_q[to], pose_x_q[to]} <= {value_i, pose};
        block_pkg::BlockCentreY: {centre_y_q[to], pose_y_q[to]} <= {value_i, pose};
        block_pkg::BlockCentreZ: {centre_z_q[to], pose_z_q[to]} <= {value_i, pose};
        block_pkg::BlockRed: red_q[to] <= value_i;
        block_pkg::BlockGreen: green_q[to] <= value_i;
        block_pkg::BlockBlue: blue_q[to] <= value_i;
        block_pkg::BlockRadius: radius_q[to] <= value_i;
        block_pkg::BlockRadius2: radius2_q[to] <= value_i;
        block_pkg::BlockRv: rv_q[to] <= value_i;
        default: ;
      endcase
    end
  end

  assign pose_x_o = pose_x_q[from];
  assign pose_y_o = pose_y_q[from];
  assign pose_z_o = pose_z_q[from];
  assign rv_o = rv_q[from];
  assign centre_x_o = centre_x_q[from];
  assign centre_y_o = centre_y_q[from];
  assign centre_z_o = centre_z_q[from];
  assign radius_o = radius_q[from];
  assign radius2_o = radius2_q[from];
  assign red_o = red_q[from];
  assign green_o = green_q[from];
  assign blue_o = blue_q[from];
endmodule

`default_nettype wire
