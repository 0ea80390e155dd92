// voxel_setup: inverses of a direction's components.
// Contract: sc/voxel/voxel_setup.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_setup (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // voxel_walker
    input  wire logic start_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_y_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_z_i,
    output logic [voxel_pkg::VoxelInverseBits-1:0] inverse_x_o,
    output logic [voxel_pkg::VoxelInverseBits-1:0] inverse_y_o,
    output logic [voxel_pkg::VoxelInverseBits-1:0] inverse_z_o,
    output logic [2:0] parallel_o,  // z, y, x
    output logic done_o
);
  logic [3:0] step_q;  // clocks that are over; 0: idle too
  wire logic first = step_q == '0;
  wire logic divides = !first || start_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) step_q <= '0;
    else if (divides) step_q <= step_q + 1'b1;
  end

  voxel_divider u_voxel_divider_x (
      .clk_i(clk_i),
      .first_i(first),
      .divides_i(divides),
      .direction_i(direction_x_i),
      .inverse_o(inverse_x_o),
      .parallel_o(parallel_o[0])
  );
  voxel_divider u_voxel_divider_y (
      .clk_i(clk_i),
      .first_i(first),
      .divides_i(divides),
      .direction_i(direction_y_i),
      .inverse_o(inverse_y_o),
      .parallel_o(parallel_o[1])
  );
  voxel_divider u_voxel_divider_z (
      .clk_i(clk_i),
      .first_i(first),
      .divides_i(divides),
      .direction_i(direction_z_i),
      .inverse_o(inverse_z_o),
      .parallel_o(parallel_o[2])
  );

  assign done_o = step_q == '1;
endmodule

`default_nettype wire
