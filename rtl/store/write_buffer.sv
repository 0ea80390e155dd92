// write_buffer: words on their way from the tracer to the frame store.
// Contract: sc/store/write_buffer.h
//
// Entries are flip-flops without reset; a 2-state simulation starts them at 0. Any depth from 1 on
// will do: the pointers go back to 0 after the last entry.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module write_buffer #(
    parameter int WriteBufferDepth = 64,
    parameter int WhenFull = 0,  // 0: stall, 1: drop
    parameter int AddressBits = 18,  // stored of the ports' bits
    parameter int DataBits = 16
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Tracer
    input  wire logic put_valid_i,
    /* verilator lint_off UNUSEDSIGNAL */  // upper bits: as the engine has them
    input  wire logic [19:0] put_address_i,
    input  wire logic [63:0] put_data_i,
    /* verilator lint_on UNUSEDSIGNAL */
    output logic put_ready_o,
    // store_arbiter
    output logic take_valid_o,
    output logic [19:0] take_address_o,
    output logic [63:0] take_data_o,
    input  wire logic take_ready_i,
    // For statistics
    output logic [7:0] fill_o  // words in it
);
  localparam int PointerBits = WriteBufferDepth > 1 ? $clog2(WriteBufferDepth) : 1;
  localparam logic [PointerBits-1:0] LastEntry = PointerBits'(WriteBufferDepth - 1);

  logic [AddressBits-1:0] addresses_q[WriteBufferDepth];
  logic [DataBits-1:0] datas_q[WriteBufferDepth];
  logic [PointerBits-1:0] head_q, head_d, tail_q, tail_d;
  logic full_q, full_d;

  wire logic put = put_valid_i && put_ready_o;
  wire logic take = take_valid_o && take_ready_i;

  always_comb begin
    head_d = head_q;
    tail_d = tail_q;
    if (put) head_d = head_q == LastEntry ? '0 : head_q + 1'b1;
    if (take) tail_d = tail_q == LastEntry ? '0 : tail_q + 1'b1;
    // A word that was not waited for runs past the tail: not full any more.
    full_d = put == take ? full_q : put && head_d == tail_d;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      head_q <= '0;
      tail_q <= '0;
      full_q <= 1'b0;
    end else begin
      head_q <= head_d;
      tail_q <= tail_d;
      full_q <= full_d;
      if (put) begin
        addresses_q[head_q] <= put_address_i[AddressBits-1:0];
        datas_q[head_q] <= put_data_i[DataBits-1:0];
      end
    end
  end

  assign put_ready_o = WhenFull == 1 || !full_q || take_ready_i;
  assign take_valid_o = full_q || head_q != tail_q;
  assign take_address_o = 20'(addresses_q[tail_q]);
  assign take_data_o = 64'(datas_q[tail_q]);

  always_comb begin
    fill_o = 8'(head_q) - 8'(tail_q);
    if (full_q || head_q < tail_q) fill_o = fill_o + 8'(WriteBufferDepth);
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni) begin
      assert (32'(head_q) < WriteBufferDepth && 32'(tail_q) < WriteBufferDepth)
      else $error("a pointer is beyond the last entry");
      assert (!full_q || head_q == tail_q)
      else $error("it is full, and the pointers do not meet");
    end
`endif
endmodule

`default_nettype wire
