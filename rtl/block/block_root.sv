// block_root: square root of a 3.20 number, made of the bits that it would have as a float.
// Contract: sc/block/block_root.h
//
// Halving a float's exponent halves what is below the leading one too. Of an even place of the
// leading one the root is 1 + m/2, of an odd one 3/2 + m/2, shifted.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_root (
    // block_core
    input  wire logic [block_pkg::BlockRootBits-1:0] d_i,
    output logic [block_pkg::BlockRootBits-1:0] root_o
);
  localparam int Bits = block_pkg::BlockRootBits;
  localparam int MostShift = 13;  // of place 0

  /* verilator lint_off UNUSEDSIGNAL */  // the leading one itself, and where none is
  logic [4:0] place;  // of the leading one
  logic [Bits-1:0] aligned;  // the leading one on top
  always_comb begin
    place = '0;
    for (int n = 0; n < Bits; n++) if (d_i[n]) place = 5'(n);
    aligned = d_i << (5'(Bits - 1) - place);
  end

  wire logic [3:0] shift = 4'(MostShift) - place[4:1];
  wire logic [Bits:0] root = {1'b1, place[0], aligned[Bits-2:0]};  // 1.23
  wire logic [Bits:0] whole;
  wire logic [MostShift-1:0] below;
  /* verilator lint_on UNUSEDSIGNAL */
  assign {whole, below} = {root, {MostShift{1'b0}}} >> shift;
  wire logic up = below[MostShift-1] && (below[MostShift-2:0] != '0 || whole[0]);  // half: to even

  assign root_o = d_i == '0 ? '0 : whole[Bits-1:0] + Bits'(up);
endmodule

`default_nettype wire
