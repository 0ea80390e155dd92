// sphere_shader: colour of a hit, of a ray with its reflections, and of a pixel of several
// sub-rays.
// Contract: sc/sphere/sphere_shader.h
//
// The four multipliers: three channels, and the weight.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sphere_shader #(
    parameter int ColourBits = 5  // a channel of the word
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // sphere_tracer
    input  wire logic [2:0] op_i,  // shader_op
    input  wire logic [sphere_pkg::SphereColourBits-1:0] base_red_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] base_green_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] base_blue_i,
    input  wire logic dark_i,  // the dark squares of a checkerboard
    input  wire logic [sphere_pkg::UnitBits-1:0] fraction_i,  // of the light, of 4096
    input  wire logic [sphere_pkg::UnitBits-1:0] reflect_i,  // of 4096
    input  wire logic direct_i,  // not in a mirror
    input  wire logic [3:0] sub_i,
    output logic [sphere_pkg::UnitBits-1:0] weight_o,
    // sphere_inputs
    input  wire logic [1:0] alias_i,
    // write_buffer
    output logic [63:0] word_o  // {light, red, green, blue}
);
  localparam int Unit = sphere_pkg::UnitBits;
  localparam int Channel = sphere_pkg::ChannelBits;
  localparam int Last = sphere_pkg::SubRays - 1;

  typedef logic [Channel-1:0] channel;
  typedef logic [Channel:0] bright;  // a hit in full light is half as bright again
  typedef logic [3*Channel-1:0] colour;  // {red, green, blue}

  bright colour_red_q, colour_red_d, colour_green_q, colour_green_d;
  bright colour_blue_q, colour_blue_d;
  channel sum_red_q, sum_red_d, sum_green_q, sum_green_d, sum_blue_q, sum_blue_d;
  logic [Unit-1:0] weight_q, weight_d;
  logic light_q, light_d;
  colour buffer_q[sphere_pkg::SubRays];

  wire logic eight = alias_i[1];
  wire logic [3:0] last_sub = eight ? 4'd8 : alias_i[0] ? 4'd4 : 4'd0;
  wire logic lit = op_i == sphere_pkg::ShadeLit;

  // --- One multiplication a channel, one of the weight -----------------------------------------
  function automatic channel base_of(input logic [sphere_pkg::SphereColourBits-1:0] base,
                                     input logic dark);
    base_of = dark ? {2'b0, base, 3'b0} : {base, 5'b0};
  endfunction

  /* verilator lint_off UNUSEDSIGNAL */  // what is below a bit
  function automatic logic [Unit-1:0] scaled(input logic [Unit-1:0] value,
                                             input logic [Unit-1:0] by);
    logic [2*Unit-1:0] product;
    product = value * by;
    scaled = product[2*Unit-1:Unit];
  endfunction
  /* verilator lint_on UNUSEDSIGNAL */

  wire channel red = base_of(base_red_i, dark_i);
  wire channel green = base_of(base_green_i, dark_i);
  wire channel blue = base_of(base_blue_i, dark_i);
  wire logic [Unit-1:0] factor = lit ? fraction_i : weight_q;
  wire logic [Unit-1:0] part_red = scaled(lit ? Unit'(red) : Unit'(colour_red_q), factor);
  wire logic [Unit-1:0] part_green = scaled(lit ? Unit'(green) : Unit'(colour_green_q), factor);
  wire logic [Unit-1:0] part_blue = scaled(lit ? Unit'(blue) : Unit'(colour_blue_q), factor);
  assign weight_o = scaled(weight_q, reflect_i);

  // --- What an operation does ------------------------------------------------------------------
  function automatic bright shaded(input logic [2:0] op, input bright old, input channel base,
                                   input bright part);
    unique case (op)
      sphere_pkg::ShadeLight: shaded = 11'h3ff;
      sphere_pkg::ShadeHalf: shaded = {2'b0, base[Channel-1:1]};
      sphere_pkg::ShadeLit: shaded = part + {2'b0, base[Channel-1:1]};
      sphere_pkg::ShadePlain: shaded = {1'b0, base};
      default: shaded = old;
    endcase
  endfunction

  function automatic channel added(input channel sum, input logic [Unit-1:0] part);
    logic [Unit-1:0] whole;
    whole = Unit'(sum) + part;
    added = whole > 12'h3ff ? 10'h3ff : whole[Channel-1:0];
  endfunction

  always_comb begin
    colour_red_d = shaded(op_i, colour_red_q, red, part_red[Channel:0]);
    colour_green_d = shaded(op_i, colour_green_q, green, part_green[Channel:0]);
    colour_blue_d = shaded(op_i, colour_blue_q, blue, part_blue[Channel:0]);
  end

  always_comb begin
    {sum_red_d, sum_green_d, sum_blue_d} = {sum_red_q, sum_green_q, sum_blue_q};
    weight_d = weight_q;
    light_d = light_q;
    unique case (op_i)
      sphere_pkg::ShadeStart, sphere_pkg::ShadeStore: begin
        {sum_red_d, sum_green_d, sum_blue_d} = '0;
        weight_d = '1;
        if (op_i == sphere_pkg::ShadeStart || sub_i == last_sub) light_d = 1'b0;
      end
      sphere_pkg::ShadeLight: if (direct_i && sub_i == '0) light_d = 1'b1;
      sphere_pkg::ShadeAdd: begin
        sum_red_d = added(sum_red_q, part_red);
        sum_green_d = added(sum_green_q, part_green);
        sum_blue_d = added(sum_blue_q, part_blue);
        weight_d = weight_o;
      end
      default: ;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {colour_red_q, colour_green_q, colour_blue_q} <= '0;
      {sum_red_q, sum_green_q, sum_blue_q} <= '0;
      weight_q <= '1;
      light_q <= 1'b0;
      for (int n = 0; n <= Last; n++) buffer_q[n] <= '0;
    end else begin
      {colour_red_q, colour_green_q, colour_blue_q} <=
          {colour_red_d, colour_green_d, colour_blue_d};
      {sum_red_q, sum_green_q, sum_blue_q} <= {sum_red_d, sum_green_d, sum_blue_d};
      weight_q <= weight_d;
      light_q <= light_d;
      for (int n = 0; n <= Last; n++)
        if (op_i == sphere_pkg::ShadeStore && sub_i == 4'(n))
          buffer_q[n] <= {sum_red_q, sum_green_q, sum_blue_q};
    end
  end

  // --- The word: sub-rays by weight ------------------------------------------------------------
  logic [2:0] shift;
  colour part;
  channel word_red, word_green, word_blue;
  always_comb begin
    {word_red, word_green, word_blue} = '0;
    for (int n = 0; n <= Last; n++) begin
      if (eight) shift = n == 0 ? 3'd2 : n <= 4 ? 3'd4 : 3'd3;
      else if (alias_i[0]) shift = n == 0 ? 3'd1 : 3'd3;
      else shift = 3'd0;
      part = sub_i == 4'(n) ? {sum_red_q, sum_green_q, sum_blue_q} : buffer_q[n];
      if (sub_i >= 4'(n)) begin
        word_red = word_red + (part[2*Channel+:Channel] >> shift);
        word_green = word_green + (part[Channel+:Channel] >> shift);
        word_blue = word_blue + (part[0+:Channel] >> shift);
      end
    end
    word_o = 64'({light_q, word_red[Channel-1-:ColourBits], word_green[Channel-1-:ColourBits],
                  word_blue[Channel-1-:ColourBits]});
  end
endmodule

`default_nettype wire
