// voxel_leaf: samples the columns along a ray, and says where the ray is.
// Contract: sc/voxel/voxel_leaf.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_leaf #(
    parameter int SizeX = 64,
    parameter int SizeY = 64,
    parameter int MemoryClocks = 1
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // voxel_walker
    input  wire logic start_i,
    input  wire logic at_i,
    input  wire logic fetch_i,
    input  wire logic [voxel_pkg::VoxelTBits-1:0] t_from_i,
    input  wire logic [voxel_pkg::VoxelTBits-1:0] t_to_i,
    input  wire logic [voxel_pkg::VoxelTBits-1:0] step_i,
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_y_i,
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_z_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_y_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_z_i,
    // voxel_limits
    input  wire logic stop_i,
    // column_memory
    input  wire logic [voxel_pkg::VoxelMemoryBits-1:0] data_i,
    output logic read_o,
    output logic [voxel_pkg::VoxelColumnBits-1:0] address_o,
    // voxel_walker
    output logic some_o,
    output logic sample_o,
    output logic hit_o,
    output logic done_o,
    output logic [voxel_pkg::VoxelTBits-1:0] t_o,
    output logic [voxel_pkg::VoxelSampleBits-1:0] samples_o,
    output logic [voxel_pkg::VoxelPositionBits-1:0] position_x_o,  // signed
    output logic [voxel_pkg::VoxelPositionBits-1:0] position_y_o,
    output logic [voxel_pkg::VoxelPositionBits-1:0] position_z_o
);
  localparam int Bits = voxel_pkg::VoxelPositionBits;
  localparam int Fraction = voxel_pkg::VoxelPositionFraction;
  localparam int HeightBits = voxel_pkg::VoxelHeightBits;
  localparam int ColumnBits = voxel_pkg::VoxelColumnBits;
  localparam logic [3:0] LastPhase = 4'(MemoryClocks + 1);

  logic active_q, active_d;
  logic [3:0] phase_q, phase_d;  // clocks of the sample that are over
  logic [voxel_pkg::VoxelTBits-1:0] t_q, t_d;
  logic [voxel_pkg::VoxelSampleBits-1:0] samples_q, samples_d;

  // --- Along the ray ---------------------------------------------------------------------------
  wire logic [voxel_pkg::VoxelTBits:0] first = {1'b0, t_from_i} + {2'b0, step_i[31:1]};
  wire logic [voxel_pkg::VoxelTBits:0] next = {1'b0, t_q} + {1'b0, step_i};
  assign some_o = first < {1'b0, t_to_i};
  assign sample_o = active_q && phase_q == LastPhase;
  assign done_o = sample_o && (hit_o || next >= {1'b0, t_to_i});

  always_comb begin
    {active_d, phase_d, t_d, samples_d} = {active_q, phase_q, t_q, samples_q};
    if (active_q) phase_d = phase_q + 1'b1;
    if (sample_o) begin
      phase_d = '0;
      active_d = !done_o && !stop_i;
      if (!hit_o) begin
        samples_d = samples_q + 1'b1;
        t_d = next[voxel_pkg::VoxelTBits-1:0];
      end
    end
    if (start_i) begin
      {active_d, phase_d, samples_d} = {some_o, 4'd0, voxel_pkg::VoxelSampleBits'(0)};
      t_d = first[voxel_pkg::VoxelTBits-1:0];
    end
  end

  always_ff @(posedge clk_i) begin
    active_q <= rst_ni && active_d;
    {phase_q, t_q, samples_q} <= {phase_d, t_d, samples_d};
  end
  assign t_o = t_q;
  assign samples_o = samples_q;

  // --- Where the ray is ------------------------------------------------------------------------
  wire logic [voxel_pkg::VoxelTBits-1:0] t = at_i ? t_from_i : t_q;
  voxel_point u_voxel_point_x (
      .origin_i(origin_x_i),
      .t_i(t),
      .direction_i(direction_x_i),
      .position_o(position_x_o)
  );
  voxel_point u_voxel_point_y (
      .origin_i(origin_y_i),
      .t_i(t),
      .direction_i(direction_y_i),
      .position_o(position_y_o)
  );
  voxel_point u_voxel_point_z (
      .origin_i(origin_z_i),
      .t_i(t),
      .direction_i(direction_z_i),
      .position_o(position_z_o)
  );

  // --- Its column ------------------------------------------------------------------------------
  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] x, y;
  voxel_wrap #(
      .Side(SizeX),
      .Levels(1)
  ) u_voxel_wrap_x (
      .value_i(position_x_o[Bits-1:Fraction]),
      .level_i('0),
      .place_o(x)
  );
  voxel_wrap #(
      .Side(SizeY),
      .Levels(1)
  ) u_voxel_wrap_y (
      .value_i(position_y_o[Bits-1:Fraction]),
      .level_i('0),
      .place_o(y)
  );
  always_comb begin  // y times a constant: adders of what its ones shift
    address_o = ColumnBits'(x);
    for (int n = 0; n < ColumnBits; n++)
      if (SizeX[n]) address_o = address_o + (ColumnBits'(y) << n);
  end
  assign read_o = fetch_i || active_q && phase_q == '0;

  // --- Whether that is in its solid ------------------------------------------------------------
  wire logic [HeightBits-1:0] low = data_i[0+:HeightBits];
  wire logic [HeightBits-1:0] middle = data_i[HeightBits+:HeightBits];
  wire logic [HeightBits-1:0] high = data_i[2*HeightBits+:HeightBits];
  wire logic [HeightBits-1:0] z = position_z_o[Fraction+:HeightBits];
  wire logic below = position_z_o[Bits-1];
  wire logic above = !below && position_z_o[Bits-2:Fraction+HeightBits] != '0;
  wire logic solid = below || !above && (z < low || z >= middle && z < high);
  assign hit_o = sample_o && solid;

  /* verilator lint_off UNUSEDSIGNAL */
  wire logic [voxel_pkg::VoxelMemoryBits-1:3*HeightBits] materials =
      data_i[voxel_pkg::VoxelMemoryBits-1:3*HeightBits];
  /* verilator lint_on UNUSEDSIGNAL */
endmodule

`default_nettype wire
