// block_scheduler: deals the blocks of a picture, row by row, to the cores that are free.
// Contract: sc/block/block_scheduler.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_scheduler #(
    parameter int Cores = 4
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Host
    input  wire logic start_i,
    input  wire logic [block_pkg::BlockPlaceBits-1:0] width_i,
    input  wire logic [block_pkg::BlockPlaceBits-1:0] height_i,
    output logic done_o,  // all blocks are dealt and drawn
    // block_core: a bit each; one job for the core whose bit is set
    output logic [block_pkg::BlockCores-1:0] job_valid_o,
    output logic [block_pkg::BlockPlaceBits-1:0] job_x_o,
    output logic [block_pkg::BlockPlaceBits-1:0] job_y_o,
    /* verilator lint_off UNUSEDSIGNAL */  // of cores that there are not
    input  wire logic [block_pkg::BlockCores-1:0] job_ready_i,
    input  wire logic [block_pkg::BlockCores-1:0] busy_i
    /* verilator lint_on UNUSEDSIGNAL */
);
  localparam int PlaceBits = block_pkg::BlockPlaceBits;
  localparam int Side = block_pkg::BlockSide;

  logic deals_q, deals_d;
  logic [PlaceBits-1:0] x_q, x_d, y_q, y_d;

  wire logic [Cores-1:0] ready = job_ready_i[Cores-1:0];
  wire logic [Cores-1:0] lowest = ready & (~ready + 1'b1);
  wire logic deals = deals_q && ready != '0;
  wire logic last_of_row = 32'(x_q) + Side >= 32'(width_i);
  wire logic last_row = 32'(y_q) + Side >= 32'(height_i);

  always_comb begin
    {deals_d, x_d, y_d} = {deals_q, x_q, y_q};
    if (!deals_q) {deals_d, x_d, y_d} = {start_i, {2 * PlaceBits{1'b0}}};
    else if (deals) begin
      x_d = last_of_row ? '0 : x_q + PlaceBits'(Side);
      if (last_of_row) y_d = y_q + PlaceBits'(Side);
      if (last_of_row && last_row) deals_d = 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) {deals_q, x_q, y_q} <= '0;
    else {deals_q, x_q, y_q} <= {deals_d, x_d, y_d};
  end

  assign job_valid_o = deals_q ? block_pkg::BlockCores'(lowest) : '0;
  assign job_x_o = x_q;
  assign job_y_o = y_q;
  assign done_o = !deals_q && busy_i[Cores-1:0] == '0;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni)
      assert ($onehot0(job_valid_o))
      else $error("a job is dealt to several cores");
`endif
endmodule

`default_nettype wire
