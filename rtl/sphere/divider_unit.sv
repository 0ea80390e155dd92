// divider_unit: three divisions by one denominator, restoring, on magnitudes.
// Contract: sc/sphere/divider_unit.h
//
// Every clock that divides takes as many bits: the numerator has zeros before it to fill them. If
// the bits are taken before the last clock, those left are idle. The registers of the division are
// without reset.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module divider_unit #(
    parameter int DivideClocks = 5
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // sphere_tracer
    input  wire logic start_i,
    input  wire logic [sphere_pkg::NumeratorBits-1:0] numerator_x_i,  // signed
    input  wire logic [sphere_pkg::NumeratorBits-1:0] numerator_y_i,
    input  wire logic [sphere_pkg::NumeratorBits-1:0] numerator_z_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] denominator_i,  // signed
    output logic [sphere_pkg::SphereBits-1:0] quotient_x_o,  // signed
    output logic [sphere_pkg::SphereBits-1:0] quotient_y_o,
    output logic [sphere_pkg::SphereBits-1:0] quotient_z_o,
    output logic done_o
);
  localparam int Bits = sphere_pkg::SphereBits;
  localparam int StepBits = (sphere_pkg::NumeratorBits + DivideClocks - 1) / DivideClocks;
  localparam int BusyClocks = (sphere_pkg::NumeratorBits + StepBits - 1) / StepBits;
  localparam int RestBits = StepBits * BusyClocks;
  localparam logic [5:0] LastStep = 6'(DivideClocks - 1);
  localparam logic [Bits-1:0] Huge = {1'b0, {(Bits - 1) {1'b1}}};  // of a division by 0

  typedef logic [Bits-1:0] number;
  typedef logic [RestBits-1:0] rest;  // the numerator's bits to come
  typedef logic [RestBits+2*Bits-1:0] lane;  // {rest, remainder, found: the quotient}

  logic done_q, done_d;
  logic [5:0] step_q, step_d;  // clocks of the division that are over; 0: idle too
  rest rest_x_q, rest_y_q, rest_z_q;
  number remainder_x_q, remainder_y_q, remainder_z_q, found_x_q, found_y_q, found_z_q;
  number denominator_q;
  logic [2:0] minus_q;  // z, y, x
  number quotient_x_q, quotient_y_q, quotient_z_q;

  function automatic lane loaded(input logic [sphere_pkg::NumeratorBits-1:0] numerator);
    logic [sphere_pkg::NumeratorBits-1:0] magnitude;
    magnitude = numerator[sphere_pkg::NumeratorBits-1] ? -numerator : numerator;
    loaded = {RestBits'(magnitude), {2 * Bits{1'b0}}};
  endfunction

  function automatic lane divided(input lane from, input number denominator);
    rest bits;
    number remainder, found;  // the remainder is less than 2^23, or divided by 0
    {bits, remainder, found} = from;
    for (int n = 0; n < StepBits; n++) begin
      remainder = {remainder[Bits-2:0], bits[RestBits-1]};
      bits = bits << 1;
      found = found << 1;
      if (remainder >= denominator) begin
        remainder = remainder - denominator;
        found[0] = 1'b1;
      end
    end
    divided = {bits, remainder, found};
  endfunction

  function automatic number result(input number magnitude, input logic minus, input logic by_zero);
    number value;
    value = by_zero ? Huge : magnitude;
    result = minus ? -value : value;
  endfunction

  wire logic running = start_i && !done_q;
  wire logic rises = running && step_q == '0;
  wire logic divides = BusyClocks == DivideClocks || 32'(step_q) < BusyClocks;
  wire logic ends = running && step_q == LastStep;
  wire logic minus_below = denominator_i[Bits-1];
  wire number magnitude = minus_below ? -denominator_i : denominator_i;
  wire logic [2:0] signs = {
      numerator_z_i[sphere_pkg::NumeratorBits-1] ^ minus_below,
      numerator_y_i[sphere_pkg::NumeratorBits-1] ^ minus_below,
      numerator_x_i[sphere_pkg::NumeratorBits-1] ^ minus_below};
  wire number denominator = rises ? magnitude : denominator_q;
  wire logic [2:0] minus = rises ? signs : minus_q;

  wire lane from_x = rises ? loaded(numerator_x_i) : {rest_x_q, remainder_x_q, found_x_q};
  wire lane from_y = rises ? loaded(numerator_y_i) : {rest_y_q, remainder_y_q, found_y_q};
  wire lane from_z = rises ? loaded(numerator_z_i) : {rest_z_q, remainder_z_q, found_z_q};
  wire lane lane_x = divides ? divided(from_x, denominator) : from_x;
  wire lane lane_y = divides ? divided(from_y, denominator) : from_y;
  wire lane lane_z = divides ? divided(from_z, denominator) : from_z;

  assign step_d = running ? step_q + 1'b1 : '0;
  assign done_d = start_i && (ends || done_q);

  wire logic by_zero = denominator == '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      step_q <= '0;
      done_q <= 1'b0;
      quotient_x_q <= '0;
      quotient_y_q <= '0;
      quotient_z_q <= '0;
    end else begin
      step_q <= step_d;
      done_q <= done_d;
      if (ends) begin
        quotient_x_q <= result(lane_x[Bits-1:0], minus[0], by_zero);
        quotient_y_q <= result(lane_y[Bits-1:0], minus[1], by_zero);
        quotient_z_q <= result(lane_z[Bits-1:0], minus[2], by_zero);
      end
    end
    if (running) begin
      {rest_x_q, remainder_x_q, found_x_q} <= lane_x;
      {rest_y_q, remainder_y_q, found_y_q} <= lane_y;
      {rest_z_q, remainder_z_q, found_z_q} <= lane_z;
    end
    if (rises) begin
      denominator_q <= magnitude;
      minus_q <= signs;
    end
  end

  assign quotient_x_o = quotient_x_q;
  assign quotient_y_o = quotient_y_q;
  assign quotient_z_o = quotient_z_q;
  assign done_o = done_q;

`ifndef SYNTHESIS
  // What comes of the bits that were taken has no more bits; the first ones are always 0.
  function automatic logic is_of_taken(input number value);
    is_of_taken = (value >> (32'(step_q) * StepBits - (RestBits - sphere_pkg::NumeratorBits))) == '0;
  endfunction

  function automatic logic is_small(input logic [Bits-2:0] remainder);  // nobody reads its highest
    is_small = denominator_q == '0 || {1'b0, remainder} < denominator_q;
  endfunction

  always_ff @(posedge clk_i)
    if (rst_ni)
      it_ends : assert (step_q <= LastStep || step_q == LastStep + 1'b1 && done_q);
  always_ff @(posedge clk_i)
    if (rst_ni && step_q != '0) begin
      denominator_is_a_magnitude : assert (!denominator_q[Bits-1] || denominator_q[Bits-2:0] == '0);
      remainder_x_is_of_taken : assert (is_of_taken({1'b0, remainder_x_q[Bits-2:0]}));
      found_x_is_of_taken : assert (denominator_q == '0 || is_of_taken(found_x_q));
      remainder_x_is_small : assert (is_small(remainder_x_q[Bits-2:0]));
      remainder_y_is_of_taken : assert (is_of_taken({1'b0, remainder_y_q[Bits-2:0]}));
      found_y_is_of_taken : assert (denominator_q == '0 || is_of_taken(found_y_q));
      remainder_y_is_small : assert (is_small(remainder_y_q[Bits-2:0]));
      remainder_z_is_of_taken : assert (is_of_taken({1'b0, remainder_z_q[Bits-2:0]}));
      found_z_is_of_taken : assert (denominator_q == '0 || is_of_taken(found_z_q));
      remainder_z_is_small : assert (is_small(remainder_z_q[Bits-2:0]));
    end
`endif
endmodule

`default_nettype wire
