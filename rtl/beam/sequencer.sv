// sequencer: the demo's conductor. Frame counter; what each frame shows and how the camera turns.
// All but the counter is a function of its bits: part = [13:11], pattern = [10:9], measure = [8:7].
// Contract: sc/beam/sequencer.h
//
// src_i = 3 asks for nothing and reads the focal length.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sequencer #(
    parameter int DrBits = 10
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // vga_timing
    input  wire logic frame_end_i,
    /* verilator lint_off UNUSEDSIGNAL */  // bit 9: lines are added as 9 bits
    input  wire logic signed [9:0] y_i,
    /* verilator lint_on UNUSEDSIGNAL */
    // camera_unit
    input  wire logic run_i,
    input  wire logic [1:0] src_i,
    output logic [racebeam_pkg::AngleBits-1:0] angle_o,
    // ray_stepper
    /* verilator lint_off UNUSEDSIGNAL */  // two bits of it gate the ray pattern
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_y_i,
    /* verilator lint_on UNUSEDSIGNAL */
    // Choices of the frame
    output logic [racebeam_pkg::FrameBits-1:0] frame_o,
    output logic [5:0] scene_flags_o,
    output logic [1:0] palette_o,
    output logic [racebeam_pkg::ColoursBits-1:0] colours_o,
    output logic shading_b_o,
    output logic scene_interlace_o,
    output logic lock_o,
    output logic inverse_o,
    // navigator: room centre minus camera
    output logic signed [racebeam_pkg::NavigatorPortBits-1:0] start_x_o,
    output logic signed [racebeam_pkg::NavigatorPortBits-1:0] start_y_o,
    output logic signed [racebeam_pkg::NavigatorPortBits-1:0] start_z_o,
    output logic [racebeam_pkg::RoomPortBits-1:0] start_room_o,
    output logic signed [racebeam_pkg::VelocityPortBits-1:0] velocity_x_o,
    output logic signed [racebeam_pkg::VelocityPortBits-1:0] velocity_y_o,
    output logic signed [racebeam_pkg::VelocityPortBits-1:0] velocity_z_o,
    output logic nav_reset_o
);
  localparam int FrameBits = racebeam_pkg::FrameBits;
  localparam int NavigatorPortBits = racebeam_pkg::NavigatorPortBits;
  localparam int VelocityPortBits = racebeam_pkg::VelocityPortBits;

  // Scene flags: W windows, P portals, B blocked, H heights, U tunnel, N narrow.
  localparam logic [5:0] W = 6'd1, P = 6'd2, B = 6'd4, H = 6'd8, U = 6'd16, N = 6'd32;

  logic [FrameBits-1:0] frame_q, frame_d;
  assign frame_d = frame_q == FrameBits'(racebeam_pkg::DemoFrames) ? '0
                 : frame_q + {{(FrameBits - 1){1'b0}}, frame_end_i};
  always_ff @(posedge clk_i) frame_q <= rst_ni ? frame_d : '0;

  logic [2:0] part, e, variant;
  logic [1:0] pattern, measure;
  logic lock_en, lock_partial, fast, mixed;  // mixed: parts that show all scenes

  assign {part, pattern, measure} = frame_q[13:7];
  assign mixed = part == 3'd1 || part == 3'd4;

  // --- Scene -----------------------------------------------------------------------------------
  logic [1:0] scene_palette;
  logic signed [8:0] start_y;
  logic signed [1:0] velocity_z;

  always_comb begin
    e = part;
    if (mixed) e = part == 3'd1 && frame_q[10:8] == 3'd5 ? 3'd1 : frame_q[10:8];

    scene_flags_o = W | B;
    scene_palette = 2'd0;
    shading_b_o = 1'b0;
    start_y = -9'sd224;
    velocity_z = -2'sd1;
    scene_interlace_o = 1'b1;
    case (e)
      3'd2, 3'd6: begin
        scene_flags_o = e == 3'd6 ? U | N : U;
        scene_palette = e == 3'd6 ? 2'd0 : 2'd1;
        shading_b_o = e == 3'd2;
        start_y = 9'sd160;
        velocity_z = -2'sd2;
        scene_interlace_o = 1'b0;
      end
      3'd3: scene_flags_o = H;
      3'd4: begin
        scene_flags_o = H | B;
        scene_palette = 2'd1;
      end
      3'd5: begin
        scene_flags_o = W | P | B | N;
        scene_palette = part == 3'd4 ? 2'd0 : 2'd2;
        shading_b_o = 1'b1;
        start_y = 9'sd32;
      end
      3'd7: begin
        scene_flags_o = H | N;
        scene_palette = 2'd1;
      end
      default: ;
    endcase
  end

  // --- Effects ---------------------------------------------------------------------------------
  logic gate;
  assign gate = dr2_y_i[DrBits-3 -: 2] != 2'd0;
  assign lock_en = part == 3'd1 && (pattern != 2'd0 || measure == 2'd3);
  assign lock_partial = pattern != 2'd1;
  assign fast = lock_en || (part == 3'd4 && e == 3'd5);
  assign inverse_o = part == 3'd4 && pattern == 2'd0 && measure[0];

  always_comb begin
    palette_o = scene_palette;
    lock_o = 1'b0;
    if (lock_en) begin
      if (gate || !lock_partial) begin
        palette_o = 2'd2;
        lock_o = run_i;
      end else begin
        palette_o = {1'b0, pattern[1] && !measure[1]};
      end
    end
  end

  // --- Camera ----------------------------------------------------------------------------------
  logic [9:0] turned, line, sum;  // yaw and pitch in 1/1024 turn
  logic [9:0] y9;
  logic pitch, add_line;

  assign y9 = {y_i[8], y_i[8:0]};
  assign pitch = src_i == 2'd1;

  always_comb begin
    case (part)
      3'd1: variant = frame_q[9:7] ^ 3'd4;
      3'd4: variant = frame_q[9:7] ^ {1'b0, frame_q[9], 1'b0};
      default: variant = 3'd0;
    endcase

    case ({fast, pitch})
      2'b00: turned = frame_q[11:2];
      2'b01: turned = ~frame_q[12:3];
      2'b10: turned = frame_q[9:0];
      default: turned = ~frame_q[10:1];
    endcase
    case (variant)
      3'd1: add_line = !pitch;
      3'd2, 3'd3: add_line = 1'b1;
      default: add_line = 1'b0;
    endcase
    line = variant == 3'd3 ? {y9[8:0], 1'b0} : y9;

    if (src_i[1]) begin
      sum = frame_q[10:1] + (variant[1] ? y9 : 10'd0);
      angle_o = variant[2] ? 11'(sum[7:0]) : 11'd96;
    end else begin
      sum = turned + (add_line ? line : 10'd0);
      angle_o = {sum, 1'b0};
    end
  end

  // --- Flight ----------------------------------------------------------------------------------
  assign frame_o = frame_q;
  assign colours_o = '0;
  assign start_x_o = '0;
  assign start_y_o = NavigatorPortBits'(start_y);
  assign start_z_o = '0;
  assign start_room_o = racebeam_pkg::RoomPortBits'(4);
  assign velocity_x_o = '0;
  assign velocity_y_o = '0;
  assign velocity_z_o = VelocityPortBits'(velocity_z);
  assign nav_reset_o = frame_q[7:0] == 8'd0 && (mixed || frame_q[10:8] == 3'd0);
endmodule

`default_nettype wire
