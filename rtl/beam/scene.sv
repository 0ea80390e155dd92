// scene: the world as logic. Size and place of a room, and the room behind each of its faces.
// Contract: sc/beam/scene.h
//
// Room ids are 9 bits, so 511 is none to decision_datapath; its neighbour is room 4 on all sides.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module scene #(
    parameter int SkipSharedEdges = 0
) (
    // sequencer
    input  wire logic [5:0] scene_flags_i,
    /* verilator lint_off UNUSEDSIGNAL */  // upper bits, and what only scene_rom looks at
    // decision_datapath
    input  wire logic [racebeam_pkg::RoomPortBits-1:0] room_i,
    input  wire logic [1:0] look_axis_i,
    input  wire logic [2:0] look_signs_i,
    input  wire logic [racebeam_pkg::PortalBits-1:0] look_portal_i,
    input  wire logic [1:0] look_way_i,
    /* verilator lint_on UNUSEDSIGNAL */
    output logic [racebeam_pkg::CornerPortBits-1:0] half_size_x_o,
    output logic [racebeam_pkg::CornerPortBits-1:0] half_size_y_o,
    output logic [racebeam_pkg::CornerPortBits-1:0] half_size_z_o,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] position_x_o,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] position_y_o,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] position_z_o,
    output logic [racebeam_pkg::RoomPortBits-1:0] neighbour_o,
    output logic [racebeam_pkg::PortalBits-1:0] back_o,
    output logic [3:0] edges_o
);
  localparam int CornerBits = racebeam_pkg::CornerBits;
  localparam int PortBits = racebeam_pkg::CornerPortBits;
  localparam int RoomBits = racebeam_pkg::RoomBits;
  localparam logic [3:0] LastCell = 4'd8;

  wire logic windows = scene_flags_i[0];
  wire logic portals = scene_flags_i[1];
  wire logic blocked = scene_flags_i[2];
  wire logic heights = scene_flags_i[3];
  wire logic tunnel = scene_flags_i[4];
  wire logic narrow = scene_flags_i[5];

  wire logic k = room_i[8];
  wire logic [3:0] j = room_i[7:4];
  wire logic [3:0] i = room_i[3:0];
  wire logic odd_odd = blocked && i[0] && j[0];
  wire logic main_type = !k || odd_odd;

  // Size and place.
  logic signed [3:0] bend_x, bend_y;  // of the tunnel, steps of 64
  always_comb begin
    unique case (j[2:0])
      3'd0: {bend_x, bend_y} = {4'sd0, 4'sd3};
      3'd1: {bend_x, bend_y} = {-4'sd2, 4'sd2};
      3'd2: {bend_x, bend_y} = {-4'sd3, 4'sd0};
      3'd3: {bend_x, bend_y} = {-4'sd2, -4'sd2};
      3'd4: {bend_x, bend_y} = {4'sd0, -4'sd3};
      3'd5: {bend_x, bend_y} = {4'sd2, -4'sd2};
      3'd6: {bend_x, bend_y} = {4'sd3, 4'sd0};
      default: {bend_x, bend_y} = {4'sd2, 4'sd2};
    endcase
  end

  wire logic [9:0] even_size = narrow ? 10'd80 : 10'd128;
  wire logic [9:0] odd_size = narrow ? 10'd176 : 10'd128;
  logic [9:0] size_x, size_y, size_z;
  logic signed [CornerBits-1:0] place_x, place_y;

  always_comb begin
    place_x = {i, 8'd0};
    if (main_type) begin
      size_x = i[0] ? odd_size : even_size;
      size_z = j[0] ? odd_size : even_size;
      size_y = heights ? 10'd256 * (10'd1 + 10'(!i[0]) + 10'(!j[0])) : 10'd256;
      place_y = '0;
      if (portals && odd_odd) begin
        if (k) size_x = 10'd80;
        else size_z = 10'd80;
        size_y = 10'd160;
      end
      if (tunnel) begin
        size_x = 10'd256;
        place_x = CornerBits'(bend_x) <<< 6;
        place_y = CornerBits'(bend_y) <<< 6;
      end
    end else begin
      {size_x, size_y, size_z} = {10'd96, 10'd16, 10'd96};
      place_y = -(CornerBits'(272));  // yosys takes -N'(x) for (-N)'(x)
    end
  end

  assign half_size_x_o = PortBits'(size_x);
  assign half_size_y_o = PortBits'(size_y);
  assign half_size_z_o = PortBits'(size_z);
  assign position_x_o = PortBits'(place_x);
  assign position_y_o = PortBits'(place_y);
  assign position_z_o = PortBits'(signed'({j, 8'd0}));

  // The room behind a face.
  wire logic [2:0] signs = look_signs_i;
  logic open;
  logic [RoomBits-1:0] neighbour;

  always_comb begin
    open = 1'b0;
    neighbour = '1;
    unique case (look_axis_i)
      2'd0: begin
        neighbour = {k, j, signs[0] ? i - 4'd1 : i + 4'd1};
        open = main_type && i != (signs[0] ? 4'd0 : LastCell);
        if (blocked && (portals ? odd_odd && k : j[0])) open = 1'b0;
      end
      2'd1: begin
        neighbour = {!k, j, i};
        open = windows && !odd_odd && k != signs[1];
      end
      2'd2: begin
        neighbour = {k ^ (blocked && portals && i[0]), signs[2] ? j - 4'd1 : j + 4'd1, i};
        open = main_type && (tunnel || j != (signs[2] ? 4'd0 : LastCell));
        if (blocked && (portals ? odd_odd && !k : i[0])) open = 1'b0;
      end
      default: ;
    endcase
    if (room_i[RoomBits-1:0] == '1) {open, neighbour} = {1'b1, RoomBits'(4)};
  end

  assign neighbour_o = open ? racebeam_pkg::RoomPortBits'(neighbour) : '1;
  assign back_o = '0;

  // Edges of the face looked at that lie on or beyond those of the room behind.
  if (SkipSharedEdges == 2) begin : g_edges
    wire logic high = !heights || !(look_axis_i == 2'd0 ? i[0] : j[0]);
    logic [2:1] bend;  // of the tunnel, between this place and the next one
    logic after_positive, after_negative, two_after_positive, two_after_negative;

    always_comb begin
      bend = 2'((j[2:0] - 3'(signs[2])) >> 1);
      {after_negative, after_positive} = 2'b11;
      {two_after_negative, two_after_positive} = {2{high}};
      unique case (look_axis_i)
        2'd0: begin
          {after_negative, after_positive} = {2{high}};
          {two_after_negative, two_after_positive} = 2'b11;
        end
        2'd1: begin
          {after_negative, after_positive} = {2{main_type != (narrow && !j[0])}};
          {two_after_negative, two_after_positive} = {2{main_type != (narrow && !i[0])}};
        end
        default:
        if (tunnel) begin
          after_positive = (bend[2] == bend[1]) != signs[2];
          after_negative = !after_positive;
          if (!heights) begin
            two_after_positive = bend[2] == signs[2];
            two_after_negative = !two_after_positive;
          end
        end
      endcase
      if (portals && odd_odd && look_axis_i != 2'd1)
        {after_negative, after_positive, two_after_negative, two_after_positive} = '0;
    end
    assign edges_o = {after_negative, two_after_negative, after_positive, two_after_positive};
  end else begin : g_no_edges
    assign edges_o = '0;
  end
endmodule

`default_nettype wire
