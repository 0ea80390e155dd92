// timeline: the conductor of a scene file, read from a table; takes the place of sequencer.
// Two rows of the table are read at once: the shot that holds, and the one that is next.
// Contract: sc/beam/timeline.h
//
// The table is ShotFile, for $readmemh: one row a shot, by frame, the first at frame 0; then a row
// that ends it, with end = 1 and frame = the number of frames. It has room for `Shots` shots; rows
// after the end are not read. A row is one hexadecimal number of 89 digits, most significant first;
// negative values are two's complement in the digits given, and `_` may stand between fields:
//
//   digits  1 end        4 frame       4 start_room  3 x 4 start   3 x 3 velocity, x y z
//           3 x 15 turn: yaw, pitch, fov, each
//                        1 load        3 start       3 step        5 every       3 per_line
//           1 flags: 1 restart, 2 interlace, 4 shading_b, 8 inverse
//           1 pattern (0 off, 1 partial, 2 full)     6 colours     6 pattern_colours
//
// Values are taken modulo the width of what they go to; `every` is 1 to 131071. Row 0 loads all its
// turns. src_i = 3 asks for nothing and reads the focal length.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module timeline #(
    parameter ShotFile = "",  // typed it would not pass yosys
    parameter int Shots = 1,
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
  localparam int AngleBits = racebeam_pkg::AngleBits;
  localparam int WaitedBits = 17;
  localparam int ShotBits = $clog2(Shots + 1);
  localparam int RowBits = 4 * 89;

  // Lowest bit of each field, and of each field in a turn.
  localparam int PatternColours = 0, Colours = 24, Pattern = 48, Flags = 52;
  localparam int FovTurn = 56, TurnBits = 60;
  localparam int VelocityZ = 236, VelocityY = 248, VelocityX = 260;
  localparam int StartZ = 272, StartY = 288, StartX = 304, StartRoom = 320, Frame = 336, End = 352;
  localparam int PerLine = 0, Every = 12, Step = 32, Start = 44, Load = 56;

  /* verilator lint_off UNDRIVEN */  // without a file there is no table
  logic [RowBits-1:0] table_rom[Shots+1];
  /* verilator lint_on UNDRIVEN */
  if (ShotFile != "") begin : g_table
    initial $readmemh(ShotFile, table_rom);
  end

  logic [FrameBits-1:0] frame_q, frame_d;
  logic [ShotBits-1:0] shot_q, shot_d;

  // --- Frames and shots ------------------------------------------------------------------------
  /* verilator lint_off UNUSEDSIGNAL */  // fields are padded to whole digits
  logic [RowBits-1:0] row, next_row, loaded_row;
  /* verilator lint_on UNUSEDSIGNAL */
  logic [FrameBits-1:0] next_frame;
  logic over, restart, new_shot;

  assign row = table_rom[shot_q];
  assign next_row = table_rom[shot_q + 1'b1];
  assign next_frame = frame_q + 1'b1;
  assign over = next_row[End] && frame_q == next_row[Frame +: FrameBits];
  assign restart = !rst_ni || over;
  assign new_shot = frame_end_i && !next_row[End] && next_frame == next_row[Frame +: FrameBits];
  assign loaded_row = restart ? table_rom[0] : next_row;

  always_comb begin
    frame_d = frame_end_i ? next_frame : frame_q;
    shot_d = new_shot ? shot_q + 1'b1 : shot_q;
    if (restart) begin
      frame_d = '0;
      shot_d = '0;
    end
  end
  always_ff @(posedge clk_i) begin
    frame_q <= frame_d;
    shot_q <= shot_d;
  end

  // --- Turns: 0 yaw, 1 pitch, 2 focal length ---------------------------------------------------
  logic [3*AngleBits-1:0] values;
  for (genvar t = 0; t < 3; t++) begin : g_turn
    localparam int Turn = FovTurn + (2 - t) * TurnBits;
    logic [AngleBits-1:0] value_q, value_d;
    logic [WaitedBits-1:0] waited_q, waited_d;
    logic last;  // frame of a step

    assign last = waited_q + 1'b1 == row[Turn + Every +: WaitedBits];
    always_comb begin
      value_d = value_q;
      waited_d = waited_q;
      if (restart || (new_shot && next_row[Turn + Load])) begin
        value_d = loaded_row[Turn + Start +: AngleBits];
        waited_d = '0;
      end else if (frame_end_i) begin
        if (last) value_d = value_q + row[Turn + Step +: AngleBits];
        waited_d = last ? '0 : waited_q + 1'b1;
      end
    end
    always_ff @(posedge clk_i) begin
      value_q <= value_d;
      waited_q <= waited_d;
    end
    assign values[t*AngleBits +: AngleBits] = value_q;

`ifndef SYNTHESIS
    if (ShotFile != "") begin : g_asserted
      always_ff @(posedge clk_i)
        if (rst_ni) assert (waited_q < row[Turn + Every +: WaitedBits]);
    end
`endif
  end

  logic [AngleBits-1:0] value, per_line, y9, angle;
  assign y9 = {{(AngleBits - 9){y_i[8]}}, y_i[8:0]};
  always_comb begin
    unique case (src_i)
      2'd0: begin
        value = values[0*AngleBits +: AngleBits];
        per_line = row[FovTurn + 2*TurnBits + PerLine +: AngleBits];
      end
      2'd1: begin
        value = values[1*AngleBits +: AngleBits];
        per_line = row[FovTurn + TurnBits + PerLine +: AngleBits];
      end
      default: begin
        value = values[2*AngleBits +: AngleBits];
        per_line = row[FovTurn + PerLine +: AngleBits];
      end
    endcase
    angle = value + per_line * y9;
    angle_o = src_i[1] ? AngleBits'(angle[7:0]) : angle;
  end

  // --- What the shot says ----------------------------------------------------------------------
  logic [1:0] pattern;
  logic shown;  // the ray pattern, here
  assign pattern = row[Pattern +: 2];
  assign shown = pattern[1] || (pattern[0] && dr2_y_i[DrBits-3 -: 2] != 2'd0);

  assign frame_o = frame_q;
  assign scene_flags_o = '0;
  assign palette_o = 2'(racebeam_pkg::TablePalette);
  assign colours_o = shown ? row[PatternColours +: racebeam_pkg::ColoursBits]
                           : row[Colours +: racebeam_pkg::ColoursBits];
  assign lock_o = shown && run_i;
  assign scene_interlace_o = row[Flags + 1];
  assign shading_b_o = row[Flags + 2];
  assign inverse_o = row[Flags + 3];
  assign start_x_o = row[StartX +: racebeam_pkg::NavigatorPortBits];
  assign start_y_o = row[StartY +: racebeam_pkg::NavigatorPortBits];
  assign start_z_o = row[StartZ +: racebeam_pkg::NavigatorPortBits];
  assign start_room_o = row[StartRoom +: racebeam_pkg::RoomPortBits];
  assign velocity_x_o = row[VelocityX +: racebeam_pkg::VelocityPortBits];
  assign velocity_y_o = row[VelocityY +: racebeam_pkg::VelocityPortBits];
  assign velocity_z_o = row[VelocityZ +: racebeam_pkg::VelocityPortBits];
  assign nav_reset_o = row[Flags] && frame_q == row[Frame +: FrameBits];

`ifndef SYNTHESIS
  if (ShotFile != "") begin : g_asserted
    always_ff @(posedge clk_i)
      if (rst_ni) begin
        shot_is_there : assert (shot_q < ShotBits'(Shots));
        frame_has_begun : assert (frame_q >= row[Frame +: FrameBits]);
        frame_has_not_ended :
          assert (over || frame_q < next_row[Frame +: FrameBits]);
      end
  end
`endif
endmodule

`default_nettype wire
