// block_shade: light and highlight of a hit, and the ray that leaves it.
// Contract: sc/block/block_shade.h
//
// Three multipliers, one vector operation a clock. The registers of the numbers are without reset;
// normal, lit and s hold what the step that comes next needs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_shade #(
    parameter int SpecularSquarings = 4
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // block_core
    input  wire logic start_i,
    input  wire logic [block_pkg::BlockBits-1:0] position_x_i,  // signed, all but the colours
    input  wire logic [block_pkg::BlockBits-1:0] position_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] position_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] dir_x_i,
    input  wire logic [block_pkg::BlockBits-1:0] dir_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] dir_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] distance_i,
    input  wire logic [block_pkg::BlockBits-1:0] centre_x_i,
    input  wire logic [block_pkg::BlockBits-1:0] centre_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] centre_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] light_x_i,
    input  wire logic [block_pkg::BlockBits-1:0] light_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] light_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] base_red_i,
    input  wire logic [block_pkg::BlockBits-1:0] base_green_i,
    input  wire logic [block_pkg::BlockBits-1:0] base_blue_i,
    output logic [block_pkg::BlockBits-1:0] point_x_o,
    output logic [block_pkg::BlockBits-1:0] point_y_o,
    output logic [block_pkg::BlockBits-1:0] point_z_o,
    output logic [block_pkg::BlockBits-1:0] direction_x_o,
    output logic [block_pkg::BlockBits-1:0] direction_y_o,
    output logic [block_pkg::BlockBits-1:0] direction_z_o,
    output logic [block_pkg::BlockBits-1:0] colour_red_o,
    output logic [block_pkg::BlockBits-1:0] colour_green_o,
    output logic [block_pkg::BlockBits-1:0] colour_blue_o,
    output logic done_o,
    // block_normalise
    output logic normalise_o,
    output logic [block_pkg::BlockBits-1:0] v_x_o,
    output logic [block_pkg::BlockBits-1:0] v_y_o,
    output logic [block_pkg::BlockBits-1:0] v_z_o,
    input  wire logic [block_pkg::BlockBits-1:0] unit_x_i,
    input  wire logic [block_pkg::BlockBits-1:0] unit_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] unit_z_i,
    input  wire logic unit_done_i
);
  localparam int Bits = block_pkg::BlockBits;

  typedef enum logic [3:0] {
    StepPoint = 4'd0,  // and idle
    StepNormal = 4'd1,
    StepLight = 4'd2,
    StepDiffuse = 4'd3,
    StepTwice = 4'd4,
    StepAway = 4'd5,
    StepSpecular = 4'd6,
    StepSquare = 4'd7,
    StepColour = 4'd8,
    StepAlong = 4'd9,
    StepDouble = 4'd10,
    StepLast = 4'd11
  } step;

  logic [3:0] step_q, step_d;
  logic [2:0] square_q;  // squarings that are over
  block_pkg::axes point_q, normal_q, lit_q, colour_q;
  block_pkg::number diffuse_q, twice_q, s_q;

  wire block_pkg::axes position = {position_x_i, position_y_i, position_z_i};
  wire block_pkg::axes dir = {dir_x_i, dir_y_i, dir_z_i};
  wire block_pkg::axes centre = {centre_x_i, centre_y_i, centre_z_i};
  wire block_pkg::axes light = {light_x_i, light_y_i, light_z_i};
  wire block_pkg::axes base = {base_red_i, base_green_i, base_blue_i};
  wire block_pkg::axes unit_in = {unit_x_i, unit_y_i, unit_z_i};

  function automatic block_pkg::number positive(input block_pkg::number value);
    positive = value[Bits-1] ? '0 : value;
  endfunction

  // --- Three multipliers -----------------------------------------------------------------------
  block_pkg::axes left, right;
  always_comb begin
    left = normal_q;
    right = {3{twice_q}};
    unique case (step_q)
      StepPoint: begin
        left = dir;
        right = {3{distance_i}};
      end
      StepDiffuse: right = lit_q;
      StepSpecular: begin
        left = dir;
        right = lit_q;
      end
      StepSquare: begin
        left = {3{s_q}};
        right = {3{s_q}};
      end
      StepColour: begin
        left = base;
        right = {3{diffuse_q}};
      end
      StepAlong: right = dir;
      default: ;
    endcase
  end

  wire block_pkg::product product_x = $signed(left[2*Bits+:Bits]) * $signed(right[2*Bits+:Bits]);
  wire block_pkg::product product_y = $signed(left[Bits+:Bits]) * $signed(right[Bits+:Bits]);
  wire block_pkg::product product_z = $signed(left[0+:Bits]) * $signed(right[0+:Bits]);
  wire block_pkg::number dot = block_pkg::fixed_of(product_x + product_y + product_z);
  wire block_pkg::axes scaled = {block_pkg::fixed_of(product_x), block_pkg::fixed_of(product_y),
                                 block_pkg::fixed_of(product_z)};

  // --- Steps -----------------------------------------------------------------------------------
  always_comb begin
    step_d = step_q + 1'b1;
    unique case (step_q)
      StepPoint: step_d = start_i ? StepNormal : StepPoint;
      StepNormal, StepLight: if (!unit_done_i) step_d = step_q;
      StepSpecular: if (SpecularSquarings == 0) step_d = StepColour;
      StepSquare: if (32'(square_q) + 1 < SpecularSquarings) step_d = StepSquare;
      StepLast: step_d = StepPoint;
      default: ;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) step_q <= StepPoint;
    else step_q <= step_d;
    unique case (step_q)
      StepPoint: if (start_i) point_q <= block_pkg::sum_of(position, scaled);
      StepNormal: normal_q <= unit_in;
      StepLight: lit_q <= unit_in;
      StepDiffuse: diffuse_q <= positive(dot);
      StepTwice: twice_q <= diffuse_q << 1;
      StepAway: lit_q <= block_pkg::difference_of(lit_q, scaled);
      StepSpecular: begin
        s_q <= positive(dot);
        square_q <= '0;
      end
      StepSquare: begin
        s_q <= block_pkg::fixed_of(product_x);
        square_q <= square_q + 1'b1;
      end
      StepColour: colour_q <= block_pkg::sum_of(scaled, {3{s_q}});
      StepAlong: twice_q <= dot;
      StepDouble: twice_q <= twice_q << 1;
      default: ;
    endcase
  end

  assign normalise_o = step_q == StepNormal || step_q == StepLight;
  assign {v_x_o, v_y_o, v_z_o} = step_q == StepNormal ? block_pkg::difference_of(point_q, centre)
                                 : block_pkg::difference_of(light, point_q);

  assign done_o = step_q == StepLast;
  assign {point_x_o, point_y_o, point_z_o} = point_q;
  assign {direction_x_o, direction_y_o, direction_z_o} =
      done_o ? block_pkg::difference_of(dir, scaled) : '0;
  assign {colour_red_o, colour_green_o, colour_blue_o} = colour_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni && step_q > StepDiffuse)
      light_is_not_below_0 : assert (!diffuse_q[Bits-1]);
`endif
endmodule

`default_nettype wire
