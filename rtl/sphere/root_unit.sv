// root_unit: square root of a 12.12 number, digit by digit.
// Contract: sc/sphere/root_unit.h
//
// The registers of the digits are without reset.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module root_unit #(
    parameter int RootBitsPerClock = 6
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // sphere_tracer
    input  wire logic start_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] radicand_i,
    output logic [sphere_pkg::SphereBits-1:0] root_o,
    output logic done_o
);
  localparam int Digits = 22;  // 4 zeros, 12 of a 12.12 number, and 6 more
  localparam int Rounds = (Digits + RootBitsPerClock - 1) / RootBitsPerClock;
  localparam int RootBits = 18;  // a digit each; the others are 0
  localparam int Zeros = Rounds * RootBitsPerClock - RootBits;  // digits before those
  localparam int RestBits = sphere_pkg::SphereBits + 2 * Zeros;
  // Of what the last round adds to.
  localparam int FoundBits = RootBitsPerClock < RootBits ? RootBits - RootBitsPerClock : 1;
  localparam int RemainderBits = FoundBits + 1;
  localparam logic [4:0] LastStep = 5'(Rounds + 1);

  logic start_q, done_q, done_d;
  logic [4:0] step_q, step_d;  // 0: idle, 1: loads, from 2 on: rounds
  logic [RestBits-1:0] rest_q, rest_d;  // of the radicand: the next two bits on top
  logic [RemainderBits-1:0] remainder_q;
  logic [RootBits+1:0] remainder_d, trial;
  logic [FoundBits-1:0] found_q;
  logic [RootBits-1:0] found_d, root_q, root_d;

  always_comb begin
    rest_d = rest_q;
    remainder_d = (RootBits + 2)'(remainder_q);
    found_d = RootBits'(found_q);
    trial = '0;
    for (int n = 0; n < RootBitsPerClock; n++) begin
      remainder_d = {remainder_d[RootBits-1:0], rest_d[RestBits-1-:2]};
      rest_d = rest_d << 2;
      trial = {found_d, 2'b01};
      found_d = {found_d[RootBits-2:0], remainder_d >= trial};
      if (found_d[0]) remainder_d = remainder_d - trial;
    end
    if (step_q == 5'd1) begin
      rest_d = RestBits'(radicand_i);
      remainder_d = '0;
      found_d = '0;
    end
  end

  always_comb begin
    step_d = step_q;
    done_d = done_q;
    root_d = root_q;
    if (!start_i) begin
      step_d = '0;
      done_d = 1'b0;
    end else if (step_q == '0) begin
      if (!start_q) step_d = 5'd1;
    end else if (step_q == LastStep) begin
      step_d = '0;
      done_d = 1'b1;
      root_d = found_d;
    end else begin
      step_d = step_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      start_q <= 1'b0;
      step_q <= '0;
      done_q <= 1'b0;
      root_q <= '0;
    end else begin
      start_q <= start_i;
      step_q <= step_d;
      done_q <= done_d;
      root_q <= root_d;
    end
    if (start_i && step_q != '0) begin
      rest_q <= rest_d;
      remainder_q <= remainder_d[RemainderBits-1:0];
      found_q <= found_d[FoundBits-1:0];
    end
  end

  assign root_o = sphere_pkg::SphereBits'(root_q);
  assign done_o = done_q;

`ifndef SYNTHESIS
  // Digits are zeros first, then those of what is found.
  function automatic logic [7:0] taken(input logic [4:0] step);
    taken = 8'(RootBitsPerClock) * (8'(step) - 8'd2);
  endfunction
  function automatic logic [7:0] zeros(input logic [4:0] step);
    zeros = taken(step) < 8'(Zeros) ? 8'(Zeros) - taken(step) : '0;
  endfunction
  function automatic logic [7:0] digits(input logic [4:0] step);
    digits = taken(step) < 8'(Zeros) ? '0 : taken(step) - 8'(Zeros);
  endfunction

  always_ff @(posedge clk_i)
    if (rst_ni && step_q > 5'd1) begin
      it_ends : assert (step_q <= LastStep);
      zeros_are_first : assert (rest_q >> (8'(RestBits) - (zeros(step_q) << 1)) == '0);
      found_is_short : assert (found_q >> digits(step_q) == '0);
      remainder_is_small : assert (remainder_q <= {found_q, 1'b0});
    end
`endif
endmodule

`default_nettype wire
