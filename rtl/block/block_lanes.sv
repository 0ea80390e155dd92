// block_lanes: the spheres of a core, in banks, and a lane at each of them.
// A part of block_core; contract: sc/block/block_core.h
//
// All lanes meet one ray in a pass; culling, they meet one sphere with a corner ray each. Lane n
// has the spheres of index n modulo Lanes. Of all lanes stand in one word, lane 0 at the bottom.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_lanes #(
    parameter int Lanes = 4
) (
    // Clock
    input  wire logic clk_i,
    // block_convert
    input  wire logic write_i,
    input  wire logic [block_pkg::BlockFieldBits-1:0] field_i,  // block_field
    input  wire logic [block_pkg::BlockIndexBits-1:0] index_i,  // of the sphere
    input  wire logic [block_pkg::BlockBits-1:0] value_i,
    input  wire logic [block_pkg::BlockBits-1:0] eye_k_i,
    // Which spheres meet what
    input  wire logic [block_pkg::BlockIndexBits-1:0] group_i,
    input  wire logic [block_pkg::BlockIndexBits-1:0] chosen_i,  // lane
    input  wire logic culls_i,  // the chosen sphere's eye, with corners from corner_i on
    input  wire logic measures_i,  // the way to the light
    input  wire logic first_pass_i,  // the eye, else position_i
    input  wire logic secondary_i,  // the second clock of a later pass
    input  wire logic [1:0] corner_i,
    input  wire logic [4*3*block_pkg::BlockBits-1:0] corners_i,
    input  wire block_pkg::axes to_light_i,
    input  wire block_pkg::axes position_i,
    input  wire block_pkg::axes dir_i,
    // What they make of it
    output logic [Lanes*block_pkg::BlockBits-1:0] b_o,
    output logic [Lanes*block_pkg::BlockDistanceBits-1:0] d_o,
    output logic [Lanes-1:0] crossed_o,  // d > 0
    // Of the chosen sphere
    output block_pkg::axes centre_o,
    output block_pkg::axes base_o,
    output block_pkg::number radius_o,
    output block_pkg::number radius2_o
);
  localparam int Bits = block_pkg::BlockBits;
  localparam int LongBits = block_pkg::BlockDistanceBits;
  localparam int IndexBits = block_pkg::BlockIndexBits;
  localparam int LaneBits = $clog2(Lanes);

  wire logic [Lanes*3*Bits-1:0] poses, centres, bases;
  wire logic [Lanes*Bits-1:0] rvs, radii, squares;
  wire logic [3*Bits-1:0] pose = poses[32'(chosen_i)*3*Bits+:3*Bits];
  wire block_pkg::number rv = rvs[32'(chosen_i)*Bits+:Bits];
  assign centre_o = centres[32'(chosen_i)*3*Bits+:3*Bits];
  assign base_o = bases[32'(chosen_i)*3*Bits+:3*Bits];
  assign radius_o = radii[32'(chosen_i)*Bits+:Bits];
  assign radius2_o = squares[32'(chosen_i)*Bits+:Bits];

  for (genvar n = 0; n < Lanes; n++) begin : g_lane
    wire block_pkg::axes own_pose, own_centre, own_base, a, ray;
    wire block_pkg::number own_rv, radius2, k;
    wire logic [1:0] corner = corner_i + 2'(n);
    wire logic writes = write_i && (index_i & IndexBits'(Lanes - 1)) == IndexBits'(n);

    block_spheres #(
        .Lanes(Lanes)
    ) u_block_spheres (
        .clk_i(clk_i),
        .write_i(writes),
        .field_i(field_i),
        .index_i(index_i >> LaneBits),
        .value_i(value_i),
        .eye_k_i(eye_k_i),
        .group_i(group_i),
        .pose_x_o(own_pose[2*Bits+:Bits]),
        .pose_y_o(own_pose[Bits+:Bits]),
        .pose_z_o(own_pose[0+:Bits]),
        .rv_o(own_rv),
        .centre_x_o(own_centre[2*Bits+:Bits]),
        .centre_y_o(own_centre[Bits+:Bits]),
        .centre_z_o(own_centre[0+:Bits]),
        .radius_o(radii[n*Bits+:Bits]),
        .radius2_o(radius2),
        .red_o(own_base[2*Bits+:Bits]),
        .green_o(own_base[Bits+:Bits]),
        .blue_o(own_base[0+:Bits])
    );
    assign poses[n*3*Bits+:3*Bits] = own_pose;
    assign centres[n*3*Bits+:3*Bits] = own_centre;
    assign bases[n*3*Bits+:3*Bits] = own_base;
    assign rvs[n*Bits+:Bits] = own_rv;
    assign squares[n*Bits+:Bits] = radius2;

    assign a = culls_i ? pose : measures_i ? to_light_i
               : first_pass_i ? own_pose : block_pkg::difference_of(position_i, own_centre);
    assign ray = culls_i ? corners_i[32'(corner)*3*Bits+:3*Bits] : dir_i;
    assign k = culls_i ? rv : first_pass_i ? own_rv : radius2;

    block_lane u_block_lane (
        .clk_i(clk_i),
        .secondary_i(secondary_i),
        .a_x_i(a[2*Bits+:Bits]),
        .a_y_i(a[Bits+:Bits]),
        .a_z_i(a[0+:Bits]),
        .dir_x_i(ray[2*Bits+:Bits]),
        .dir_y_i(ray[Bits+:Bits]),
        .dir_z_i(ray[0+:Bits]),
        .k_i(k),
        .b_o(b_o[n*Bits+:Bits]),
        .d_o(d_o[n*LongBits+:LongBits])
    );
    assign crossed_o[n] = !d_o[n*LongBits+LongBits-1] && d_o[n*LongBits+:LongBits] != '0;
  end
endmodule

`default_nettype wire
