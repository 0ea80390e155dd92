// block_bus: whose word goes to the frame store, in turn.
// Contract: sc/block/block_bus.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_bus #(
    parameter int Cores = 4
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // block_core: a bit each
    /* verilator lint_off UNUSEDSIGNAL */  // of cores that there are not
    input  wire logic [block_pkg::BlockCores-1:0] word_valid_i,
    /* verilator lint_on UNUSEDSIGNAL */
    output logic [block_pkg::BlockCores-1:0] word_ready_o,
    // write_buffer; the word is that of this core
    output logic bus_valid_o,
    output logic [block_pkg::BlockIndexBits-1:0] core_o,
    input  wire logic bus_ready_i
);
  logic [Cores-1:0] later_q;  // the cores after the one that was served last

  wire logic [Cores-1:0] asks = word_valid_i[Cores-1:0];
  wire logic [Cores-1:0] first = (asks & later_q) != '0 ? asks & later_q : asks;
  wire logic [Cores-1:0] served = first & (~first + 1'b1);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) later_q <= '0;
    else if (bus_valid_o && bus_ready_i) later_q <= ~(served | (served - 1'b1));
  end

  always_comb begin
    core_o = '0;
    for (int n = 0; n < Cores; n++) if (served[n]) core_o = block_pkg::BlockIndexBits'(n);
  end

  assign bus_valid_o = asks != '0;
  assign word_ready_o = bus_ready_i ? block_pkg::BlockCores'(served) : '0;
endmodule

`default_nettype wire
