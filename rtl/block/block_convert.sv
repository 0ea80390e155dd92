// block_convert: numbers of a scene, floats to 12.20, and what follows from those of a sphere.
// Contract: sc/block/block_convert.h
//
// Three multipliers. The registers of a sphere are without reset.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_convert #(
    parameter int FractionBits = 20
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Host
    input  wire logic valid_i,
    input  wire logic [31:0] float_i,
    input  wire logic [block_pkg::BlockFieldBits-1:0] field_i,  // block_field
    input  wire logic [block_pkg::BlockIndexBits-1:0] index_i,
    output logic ready_o,
    // block_spheres
    output logic write_o,
    output logic [block_pkg::BlockFieldBits-1:0] field_o,  // block_field
    output logic [block_pkg::BlockIndexBits-1:0] index_o,
    output logic [block_pkg::BlockBits-1:0] fixed_o,  // signed
    output logic [block_pkg::BlockBits-1:0] eye_k_o,  // signed, of the axis of a centre
    // block_core
    output logic [block_pkg::BlockBits-1:0] eye_x_o,  // signed, all of them
    output logic [block_pkg::BlockBits-1:0] eye_y_o,
    output logic [block_pkg::BlockBits-1:0] eye_z_o,
    output logic [block_pkg::BlockBits-1:0] light_x_o,
    output logic [block_pkg::BlockBits-1:0] light_y_o,
    output logic [block_pkg::BlockBits-1:0] light_z_o,
    output logic [block_pkg::BlockBits-1:0] start_x_o,  // of block (0, 0)
    output logic [block_pkg::BlockBits-1:0] start_y_o,
    output logic [block_pkg::BlockBits-1:0] start_z_o
);
  localparam int Bits = block_pkg::BlockBits;
  localparam int Fraction = block_pkg::BlockFraction;
  localparam logic [Bits-1:0] Kept = Bits'(-(1 << (Fraction - FractionBits)));
  localparam logic [7:0] Limit = 8'd135;  // the exponent of 256
  localparam logic [31:0] Least = 32'hc3800000;  // -256.0
  localparam logic [7:0] WholeExponent = 8'd136;  // of which no bit is below 2^-14
  localparam logic [7:0] MostShift = 8'd31;

  // --- Float to fixed --------------------------------------------------------------------------
  wire logic [7:0] exponent = float_i[30:23];
  wire logic [7:0] right = WholeExponent - exponent;
  wire logic [4:0] shift = right > MostShift ? MostShift[4:0] : right[4:0];
  /* verilator lint_off UNUSEDSIGNAL */  // never as large
  wire logic [23:0] whole;
  /* verilator lint_on UNUSEDSIGNAL */
  wire logic [30:0] below;
  assign {whole, below} = {1'b1, float_i[22:0], 31'd0} >> shift;
  wire logic up = below[30] && (below[29:0] != '0 || whole[0]);  // half: to even
  wire logic minus = float_i[31];
  wire logic [22:0] magnitude = whole[22:0] + 23'(up);  // in 2^-14
  wire logic fits = exponent < Limit ? minus || !magnitude[22] : float_i == Least;
  wire logic [22:0] rounded = !fits ? '0 : minus ? -magnitude : magnitude;
  wire block_pkg::number fixed = {{3{rounded[22]}}, rounded, 6'd0} & Kept;

  // --- What follows from it --------------------------------------------------------------------
  logic [1:0] derive_q, derive_d;  // 1: radius squared, 2: distance squared, 3: their difference
  logic [block_pkg::BlockIndexBits-1:0] index_q;
  block_pkg::number radius_q, radius2_q, norm2_q, pose_x_q, pose_y_q, pose_z_q;
  block_pkg::number eye_x_q, eye_y_q, eye_z_q, light_x_q, light_y_q, light_z_q, width_q, height_q;

  wire logic takes = valid_i && ready_o;
  wire logic squares_radius = derive_q == 2'd1;
  wire block_pkg::number left = squares_radius ? radius_q : pose_x_q;
  wire block_pkg::product product_x = left * left;
  wire block_pkg::product product_y = pose_y_q * pose_y_q;
  wire block_pkg::product product_z = pose_z_q * pose_z_q;
  wire block_pkg::number radius2 = block_pkg::fixed_of(product_x);
  wire block_pkg::number norm2 = block_pkg::fixed_of(product_x + product_y + product_z);

  always_comb begin
    derive_d = derive_q == '0 ? '0 : derive_q + 1'b1;
    if (takes && field_i == block_pkg::BlockBlue) derive_d = 2'd1;
  end

  always_comb begin
    unique case (field_i)
      block_pkg::BlockCentreX: eye_k_o = eye_x_q;
      block_pkg::BlockCentreY: eye_k_o = eye_y_q;
      block_pkg::BlockCentreZ: eye_k_o = eye_z_q;
      default: eye_k_o = '0;
    endcase
  end

  always_comb begin
    write_o = takes && field_i < block_pkg::BlockRv;
    field_o = field_i;
    index_o = index_i;
    fixed_o = fixed;
    if (!ready_o) begin
      write_o = derive_q != 2'd2;
      field_o = squares_radius ? block_pkg::BlockRadius2 : block_pkg::BlockRv;
      index_o = index_q;
      fixed_o = squares_radius ? radius2 : radius2_q - norm2_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      derive_q <= '0;
      {eye_x_q, eye_y_q, eye_z_q} <= '0;
      {light_x_q, light_y_q, light_z_q} <= '0;
      {width_q, height_q} <= '0;
    end else begin
      derive_q <= derive_d;
      if (takes)
        unique case (field_i)
          block_pkg::BlockEyeX: eye_x_q <= fixed;
          block_pkg::BlockEyeY: eye_y_q <= fixed;
          block_pkg::BlockEyeZ: eye_z_q <= fixed;
          block_pkg::BlockLightX: light_x_q <= fixed;
          block_pkg::BlockLightY: light_y_q <= fixed;
          block_pkg::BlockLightZ: light_z_q <= fixed;
          block_pkg::BlockScreenWidth: width_q <= fixed;
          block_pkg::BlockScreenHeight: height_q <= fixed;
          default: ;
        endcase
    end
    if (takes) begin
      index_q <= index_i;
      unique case (field_i)
        block_pkg::BlockCentreX: pose_x_q <= eye_k_o - fixed;
        block_pkg::BlockCentreY: pose_y_q <= eye_k_o - fixed;
        block_pkg::BlockCentreZ: pose_z_q <= eye_k_o - fixed;
        block_pkg::BlockRadius: radius_q <= fixed;
        default: ;
      endcase
    end
    if (squares_radius) radius2_q <= radius2;
    if (derive_q[1]) norm2_q <= norm2;  // the same in both clocks
  end

  assign ready_o = derive_q == '0;
  assign {eye_x_o, eye_y_o, eye_z_o} = {eye_x_q, eye_y_q, eye_z_q};
  assign {light_x_o, light_y_o, light_z_o} = {light_x_q, light_y_q, light_z_q};
  assign start_x_o = ((-width_q) >>> 1) - eye_x_q;
  assign start_y_o = (height_q >>> 1) - eye_y_q;
  assign start_z_o = -eye_z_q;
endmodule

`default_nettype wire
