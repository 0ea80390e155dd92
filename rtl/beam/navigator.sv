// navigator: flies the camera. Once per frame it adds the velocity and changes the room.
// Contract: sc/beam/navigator.h
//
// Bits of the camera and of its room that are wired have no flip-flops; bit 3 of nav_state and the
// portal are there where faces may have several portals only.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module navigator #(
    parameter int NavigatorBits = 9,
    parameter int FreeFlight = 0,
    parameter int PortalsPerFace = 1
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    input  wire logic nav_reset_i,
    // vga_timing
    input  wire logic nav_line_i,
    input  wire logic active_start_i,
    /* verilator lint_off UNUSEDSIGNAL */  // bits that are wired or beyond the register
    // sequencer
    input  wire logic signed [racebeam_pkg::NavigatorPortBits-1:0] start_x_i,
    input  wire logic signed [racebeam_pkg::NavigatorPortBits-1:0] start_y_i,
    input  wire logic signed [racebeam_pkg::NavigatorPortBits-1:0] start_z_i,
    input  wire logic [racebeam_pkg::RoomPortBits-1:0] start_room_i,
    // decision_datapath
    input  wire logic signed [racebeam_pkg::CornerPortBits-1:0] corner_x_i,
    input  wire logic signed [racebeam_pkg::CornerPortBits-1:0] corner_y_i,
    input  wire logic signed [racebeam_pkg::CornerPortBits-1:0] corner_z_i,
    input  wire logic [racebeam_pkg::RoomPortBits-1:0] room_i,
    /* verilator lint_on UNUSEDSIGNAL */
    output logic signed [racebeam_pkg::NavigatorPortBits-1:0] nav_position_x_o,
    output logic signed [racebeam_pkg::NavigatorPortBits-1:0] nav_position_y_o,
    output logic signed [racebeam_pkg::NavigatorPortBits-1:0] nav_position_z_o,
    output logic [racebeam_pkg::RoomPortBits-1:0] nav_room_o,
    output logic [1:0] nav_axis_o,
    output logic [racebeam_pkg::PortalBits-1:0] nav_portal_o,
    output logic nav_negative_o,
    output logic [2:0] nav_op_o,
    output logic nav_move_o
);
  typedef enum logic [3:0] {
    NavIdle = 4'd0,
    NavToPlus = 4'd1,
    NavCheckPlus = 4'd2,
    NavCheckMinus = 4'd3,
    NavFinish = 4'd4,
    NavStore = 4'd5,
    NavAdjust = 4'd6,
    NavTryPlus = 4'd8,
    NavTryDone = 4'd9,
    NavTryCheckPlus = 4'd10,
    NavTryCheckMinus = 4'd11,
    NavTryNext = 4'd12
  } navigator_state;

  localparam bit SeveralPortals = PortalsPerFace > 1;

  logic [3:0] nav_state_q, nav_state_d;  // navigator_state
  logic [racebeam_pkg::PortalBits-1:0] portal_q, portal_d;  // that is tried

  // An axis qualifies when the corner lies below 0 in even states, not below in odd ones.
  wire logic [2:0] below = {
    corner_z_i[racebeam_pkg::CornerPortBits-1],
    corner_y_i[racebeam_pkg::CornerPortBits-1],
    corner_x_i[racebeam_pkg::CornerPortBits-1]
  };
  wire logic [2:0] found = nav_state_q[0] ? ~below : below;
  wire logic reset = !rst_ni || nav_reset_i;

  always_comb begin
    nav_axis_o = '0;
    nav_negative_o = 1'b0;
    nav_op_o = racebeam_pkg::CornerHold;
    nav_move_o = 1'b0;
    if (nav_line_i) begin
      nav_axis_o = found[0] ? 2'd0 : found[1] ? 2'd1 : found[2] ? 2'd2 : 2'd0;
      unique case (nav_state_q)
        NavAdjust: nav_op_o = racebeam_pkg::CornerAddVelocity;
        NavToPlus: nav_op_o = racebeam_pkg::CornerAddS;
        NavCheckPlus: begin
          nav_op_o = found != '0 ? racebeam_pkg::CornerLeavePlus : racebeam_pkg::CornerSubtract2S;
          nav_move_o = found != '0;
        end
        NavCheckMinus:
          if (found != '0) begin
            nav_op_o = racebeam_pkg::CornerLeaveMinus;
            nav_negative_o = 1'b1;
            nav_move_o = 1'b1;
          end
        NavFinish: nav_op_o = racebeam_pkg::CornerAddR;
        NavTryPlus, NavTryDone: nav_op_o = racebeam_pkg::CornerAddS;
        NavTryCheckPlus: if (found == '0) nav_op_o = racebeam_pkg::CornerSubtract2S;
        NavTryNext: nav_op_o = racebeam_pkg::CornerCamera;
        default: ;
      endcase
    end
  end
  assign nav_portal_o = portal_q;

  wire logic another = 32'(portal_q) + 1 < PortalsPerFace;
  wire logic start = nav_line_i && active_start_i;

  always_comb begin
    unique case (nav_state_q)
      NavAdjust: nav_state_d = NavToPlus;
      NavToPlus: nav_state_d = NavCheckPlus;
      NavCheckPlus: nav_state_d = found != '0 ? NavFinish : NavCheckMinus;
      NavCheckMinus: nav_state_d = found != '0 ? NavFinish : NavIdle;
      NavFinish: nav_state_d = another ? NavTryPlus : NavStore;
      NavTryPlus: nav_state_d = NavTryCheckPlus;
      NavTryCheckPlus: nav_state_d = found != '0 ? NavTryNext : NavTryCheckMinus;
      NavTryCheckMinus: nav_state_d = found != '0 ? NavTryNext : NavTryDone;
      NavTryDone: nav_state_d = NavStore;
      NavTryNext: nav_state_d = NavToPlus;
      default: nav_state_d = NavIdle;
    endcase
    if (start) nav_state_d = NavAdjust;
    if (reset) nav_state_d = NavIdle;
  end

  wire logic store_position = reset || nav_state_q == NavToPlus || nav_state_q == NavStore;
  wire logic store_room = reset || nav_state_q == NavStore;

  always_comb begin
    portal_d = portal_q;
    if (nav_state_q == NavTryNext) portal_d = portal_q + 1'b1;
    if (reset || start) portal_d = '0;
  end

  always_ff @(posedge clk_i) begin
    nav_state_q <= {SeveralPortals && nav_state_d[3], nav_state_d[2:0]};
    portal_q <= SeveralPortals ? portal_d : '0;
  end

  if (FreeFlight != 0) begin : g_free
    logic signed [NavigatorBits-1:0] position_x_q, position_y_q, position_z_q;
    logic [racebeam_pkg::RoomPortBits-1:0] room_q;

    always_ff @(posedge clk_i) begin
      if (store_position) begin
        position_x_q <= NavigatorBits'(reset ? start_x_i : corner_x_i);
        position_y_q <= NavigatorBits'(reset ? start_y_i : corner_y_i);
        position_z_q <= NavigatorBits'(reset ? start_z_i : corner_z_i);
      end
      if (store_room) room_q <= reset ? start_room_i : room_i;
    end

    assign nav_position_x_o = racebeam_pkg::NavigatorPortBits'(position_x_q);
    assign nav_position_y_o = racebeam_pkg::NavigatorPortBits'(position_y_q);
    assign nav_position_z_o = racebeam_pkg::NavigatorPortBits'(position_z_q);
    assign nav_room_o = room_q;
  end else begin : g_along_z
    // x in steps of 64, y odd multiples of 32; i = 4 and k = 0.
    logic signed [NavigatorBits-1:6] position_x_q, position_y_q;
    logic signed [NavigatorBits-1:0] position_z_q;
    logic [3:0] room_j_q;

    always_ff @(posedge clk_i) begin
      if (store_position) begin
        position_x_q <= reset ? start_x_i[NavigatorBits-1:6] : corner_x_i[NavigatorBits-1:6];
        position_y_q <= reset ? start_y_i[NavigatorBits-1:6] : corner_y_i[NavigatorBits-1:6];
        position_z_q <= NavigatorBits'(reset ? start_z_i : corner_z_i);
      end
      if (store_room) room_j_q <= reset ? start_room_i[7:4] : room_i[7:4];
    end

    assign nav_position_x_o = racebeam_pkg::NavigatorPortBits'(signed'({position_x_q, 6'd0}));
    assign nav_position_y_o = racebeam_pkg::NavigatorPortBits'(signed'({position_y_q, 6'd32}));
    assign nav_position_z_o = racebeam_pkg::NavigatorPortBits'(position_z_q);
    assign nav_room_o = racebeam_pkg::RoomPortBits'({room_j_q, 4'd4});
  end
endmodule

`default_nettype wire
