// stacks: the interval ring stack and the face stack.
// Contract: sc/beam/stacks.h
//
// Words are flip-flops without reset; a 2-state simulation starts them at 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module stacks #(
    parameter int IntervalStackDepth = 4,
    parameter int FaceStackDepth = 9,
    parameter int PortalsPerFace = 1
) (
    // Clock
    input  wire logic clk_i,
    /* verilator lint_off UNUSEDSIGNAL */  // upper bits: with several portals in a face only
    // Interval stack: subdivider pushes {tag, i2}
    input  wire logic push_en_i,
    input  wire logic [racebeam_pkg::TagPortBits-1:0] tag_i,  // {portal, depth, level}
    input  wire logic [racebeam_pkg::PixelBits-1:0] i2_i,
    input  wire logic [racebeam_pkg::StackPointerPortBits-1:0] sp_i,
    output logic [racebeam_pkg::TagPortBits-1:0] top_tag_o,
    output logic [racebeam_pkg::PixelBits-1:0] top_i2_o,
    // Face stack: decision_datapath; its address is the depth in tag_i
    input  wire logic fwrite_i,
    input  wire logic [racebeam_pkg::FacePortBits-1:0] fdata_i,
    output logic [racebeam_pkg::FacePortBits-1:0] fread_o
    /* verilator lint_on UNUSEDSIGNAL */
);
  // Bits that are stored: portals only where a face may have several.
  localparam int TagWidth = PortalsPerFace > 1 ? racebeam_pkg::TagPortBits : racebeam_pkg::TagBits;
  localparam int FaceWidth =
      PortalsPerFace > 1 ? racebeam_pkg::FacePortBits : racebeam_pkg::FaceBits;

  logic [TagWidth-1:0] tags_q[IntervalStackDepth];
  logic [racebeam_pkg::PixelBits-1:0] i2s_q[IntervalStackDepth];
  logic [FaceWidth-1:0] faces_q[FaceStackDepth];

  wire logic [racebeam_pkg::DepthBits-1:0] depth =
      tag_i[racebeam_pkg::LevelBits +: racebeam_pkg::DepthBits];

  always_ff @(posedge clk_i) begin
    for (int n = 0; n < IntervalStackDepth; n++)
      if (push_en_i && 32'(sp_i) == n) begin
        tags_q[n] <= tag_i[TagWidth-1:0];
        i2s_q[n] <= i2_i;
      end
    for (int n = 0; n < FaceStackDepth; n++)
      if (fwrite_i && 32'(depth) == n) faces_q[n] <= fdata_i[FaceWidth-1:0];
  end

  // The top is the entry below sp, the face the one below the depth.
  always_comb begin
    top_tag_o = '0;
    top_i2_o = '0;
    for (int n = 0; n < IntervalStackDepth; n++)
      if (32'(sp_i) == (n + 1) % IntervalStackDepth) begin
        top_tag_o = racebeam_pkg::TagPortBits'(tags_q[n]);
        top_i2_o = i2s_q[n];
      end
    fread_o = '0;
    for (int n = 0; n < FaceStackDepth; n++)
      if (32'(depth) == n + 1) fread_o = racebeam_pkg::FacePortBits'(faces_q[n]);
  end
endmodule

`default_nettype wire
