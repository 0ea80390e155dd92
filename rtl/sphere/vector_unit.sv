// vector_unit: the three multipliers of the sphere tracer.
// Contract: sc/sphere/vector_unit.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module vector_unit (
    // sphere_tracer
    input  wire logic [1:0] op_i,  // vector_op
    input  wire logic [sphere_pkg::SphereBits-1:0] a_x_i,  // signed, all of them
    input  wire logic [sphere_pkg::SphereBits-1:0] a_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] a_z_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] b_x_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] b_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] b_z_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] s_i,
    output logic [sphere_pkg::SphereBits-1:0] product_x_o,
    output logic [sphere_pkg::SphereBits-1:0] product_y_o,
    output logic [sphere_pkg::SphereBits-1:0] product_z_o,
    output logic [sphere_pkg::SphereSumBits-1:0] sum_o,
    output logic [sphere_pkg::SphereSumBits-1:0] square_o
);
  typedef logic signed [sphere_pkg::SphereBits-1:0] number;
  typedef logic signed [sphere_pkg::SphereSumBits-1:0] product;

  wire logic square = op_i[1];  // VectorSquare, and the code that is free
  wire logic dot = op_i == sphere_pkg::VectorDot;

  wire number left_x = square ? s_i : a_x_i;
  wire number left_y = square ? s_i : a_y_i;
  wire number left_z = square ? s_i : a_z_i;
  wire number right_x = dot ? b_x_i : s_i;
  wire number right_y = dot ? b_y_i : s_i;
  wire number right_z = dot ? b_z_i : s_i;

  wire product lane_x = left_x * right_x;
  wire product lane_y = left_y * right_y;
  wire product lane_z = left_z * right_z;

  assign product_x_o = lane_x[sphere_pkg::SphereFraction+:sphere_pkg::SphereBits];
  assign product_y_o = lane_y[sphere_pkg::SphereFraction+:sphere_pkg::SphereBits];
  assign product_z_o = lane_z[sphere_pkg::SphereFraction+:sphere_pkg::SphereBits];
  assign sum_o = lane_x + lane_y + lane_z;
  assign square_o = lane_x;
endmodule

`default_nettype wire
