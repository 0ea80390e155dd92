// vga_timing: raster counters, syncs and the events that start lines and frames.
// Two counters of the same kind, each with the region it is in: pixels and lines.
// Contract: sc/video/vga_timing.h
//
// half_q counts the clocks of a pixel: one bit on the chip, more if ClocksPerPixel needs them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module vga_timing #(
    parameter int ClocksPerPixel = 2
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Pins of the chip
    input  wire logic [2:0] speed_i,
    output logic hsync_no,
    output logic vsync_no,
    // Beam position
    output logic signed [10:0] x2_o,
    output logic signed [9:0] y_o,
    output logic active_o,
    output logic h_active_o,
    // Events, 1 for one clock
    output logic consume_o,
    output logic line_end_o,
    output logic active_start_o,
    output logic frame_end_o,
    // The navigator's line
    output logic nav_line_o
);
  localparam int HalfBits = ClocksPerPixel > 2 ? $clog2(ClocksPerPixel) : 1;

  // Regions in the order of the beam; "active" and "sync" have other numbers in the two counters.
  localparam logic [1:0] HSync = 2'd1, HBackPorch = 2'd2, HActive = 2'd3;
  localparam logic [1:0] VActive = 2'd1, VSync = 2'd3;
  localparam logic signed [9:0] FirstPosition = 10'(racebeam_pkg::FirstPosition);
  localparam logic signed [9:0] FirstLine = 10'(racebeam_pkg::FirstLine);
  localparam logic signed [9:0] LastLine = 10'(racebeam_pkg::LastLine);

  logic [1:0] h_region_q, h_region_d, v_region_q, v_region_d;
  logic signed [9:0] h_pos_q, h_pos_d, v_pos_q, v_pos_d;
  logic [HalfBits-1:0] half_q, half_d;
  logic vs_q, vs_d;

  // --- Pixels ----------------------------------------------------------------------------------
  logic fast, h_en, h_step;
  logic signed [9:0] h_last;

  always_comb begin
    unique case (h_pos_q[3:0])
      4'd7, 4'd15: fast = speed_i[0];
      4'd5, 4'd9, 4'd11, 4'd13: fast = speed_i[1];
      4'd6, 4'd8, 4'd10: fast = speed_i[2];
      default: fast = 1'b0;
    endcase
  end
  assign h_en = fast || half_q == HalfBits'(ClocksPerPixel - 1);

  always_comb begin
    unique case (h_region_q)
      2'd0: h_last = -10'sd465;
      2'd1: h_last = -10'sd369;
      2'd2: h_last = -10'sd321;
      default: h_last = 10'sd319;
    endcase
  end
  assign h_step = h_en && h_pos_q == h_last;

  always_comb begin
    half_d = h_en ? '0 : half_q + 1'b1;
    h_pos_d = line_end_o ? FirstPosition : h_pos_q + $signed({9'd0, h_en});
    h_region_d = h_region_q + {1'b0, h_step};  // after the last the first
  end

  // --- Lines -----------------------------------------------------------------------------------
  logic v_step;
  logic signed [9:0] v_last;

  always_comb begin
    unique case (v_region_q)
      2'd0: v_last = -10'sd241;
      2'd1: v_last = 10'sd239;
      2'd2: v_last = 10'sd249;
      default: v_last = LastLine;
    endcase
  end
  assign v_step = line_end_o && v_pos_q == v_last;

  always_comb begin
    v_pos_d = frame_end_o ? FirstLine : v_pos_q + $signed({9'd0, line_end_o});
    v_region_d = v_region_q + {1'b0, v_step};
    vs_d = h_step && h_region_q == HSync ? v_region_q != VSync : vs_q;
  end

  // --- Outputs ---------------------------------------------------------------------------------
  assign hsync_no = h_region_q != HSync;
  assign vsync_no = vs_q;
  assign x2_o = {h_pos_q, h_en};
  assign y_o = v_pos_q;
  assign h_active_o = h_region_q == HActive;
  assign active_o = h_active_o && v_region_q == VActive;
  assign consume_o = h_active_o && h_en;
  assign line_end_o = h_active_o && h_step;
  assign active_start_o = h_region_q == HBackPorch && h_step;
  assign nav_line_o = v_region_q == VSync && v_pos_q[0];  // the second of two
  assign frame_end_o = line_end_o && nav_line_o;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      h_region_q <= 2'd0;
      h_pos_q <= FirstPosition;
      half_q <= '0;
      v_region_q <= 2'd0;
      v_pos_q <= FirstLine;
    end else begin
      h_region_q <= h_region_d;
      h_pos_q <= h_pos_d;
      half_q <= half_d;
      v_region_q <= v_region_d;
      v_pos_q <= v_pos_d;
    end
    vs_q <= vs_d;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni)
      assert (h_pos_q <= h_last && v_pos_q <= v_last)
      else $error("the beam is beyond the end of its region");
`endif
endmodule

`default_nettype wire
