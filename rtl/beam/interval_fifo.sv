// interval_fifo: run-length queue between the ray tracer and the beam.
// Contract: sc/beam/interval_fifo.h
//
// Only the head and the pointer are reset (contract section 14); the pointer tells which of the
// rest is valid.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module interval_fifo #(
    parameter int FifoEntries = 10,
    parameter int FifoShortLengthBits = 6,
    parameter int FifoMerge = 1,
    parameter int Dithering = 1
) (
    // Clock; phase of the line
    input wire logic clk_i,
    input wire logic tracer_reset_i,
    // subdivider and pixel_output: the interval on offer
    input wire logic emit_i,
    input wire logic [racebeam_pkg::PixelBits-1:0] len_m1_i,  // pixels minus one
    input wire logic [1:0] value_i,  // colour index
    /* verilator lint_off UNUSEDSIGNAL */
    input wire logic half_i,  // checkered: half a tone more
    /* verilator lint_on UNUSEDSIGNAL */
    output logic ack_o,  // taken in this clock
    output logic starving_o,  // nothing left to show
    // Beam
    input wire logic consume_i,  // last clock of a column
    output logic [1:0] display_o,  // colour index on show
    output logic display_half_o,
    // For statistics
    output logic [6:0] fill_o  // entries in use
);
  localparam int HeadBits = racebeam_pkg::PixelBits + 1;
  localparam int ShortBits = FifoShortLengthBits;
  localparam int ValueBits = Dithering == 2 ? 3 : 2;  // {half, index}, or the index
  localparam int QueueSize = FifoEntries - 2;
  localparam int PointerBits = $clog2(FifoEntries);
  localparam logic [PointerBits-1:0] OnlyHead = PointerBits'(QueueSize + 1);
  localparam logic [HeadBits-1:0] ShortSize = HeadBits'(1 << ShortBits);

  // Lengths are stored minus one; an entry is {length, value}.
  logic signed [HeadBits-1:0] head_len_q, head_len_d;
  logic [ValueBits-1:0] head_value_q, head_value_d;
  logic [ShortBits-1:0] tail_len_q, tail_len_d;
  logic [ValueBits-1:0] tail_value_q, tail_value_d;
  logic [ShortBits+ValueBits-1:0] queue_q[QueueSize];  // youngest last
  logic [PointerBits-1:0] tail_ptr_q, tail_ptr_d;  // free entries

  // --- What the head does: the first of these that applies -----------------------------------
  wire logic head_only = tail_ptr_q == OnlyHead;
  wire logic full = tail_ptr_q == '0;
  wire logic starving = head_only & (head_len_q < 0);
  wire logic too_long = (head_len_q >>> ShortBits) > 0;

  wire logic eat_head = head_only & consume_i;
  wire logic split = ~eat_head & too_long & ~full;
  wire logic listen = ~eat_head & ~split & emit_i;

  logic signed [HeadBits-1:0] sum;
  always_comb begin
    if (eat_head) sum = head_len_q - HeadBits'(1);
    else if (split) sum = head_len_q - ShortSize;
    else sum = head_len_q + HeadBits'(len_m1_i) + HeadBits'(1);
  end
  wire logic overflow = (head_len_q >= 0) & (sum < 0);
  wire logic [ValueBits-1:0] value = ValueBits'({half_i, value_i});
  wire logic alike = FifoMerge != 0 && value == head_value_q;
  wire logic merge = listen & (alike | starving) & ~overflow;
  wire logic take = listen & ~merge & ~full;

  always_comb begin
    head_len_d = head_len_q;
    head_value_d = head_value_q;
    if (eat_head | split | merge) head_len_d = sum;
    if (take) head_len_d = {1'b0, len_m1_i};
    if (merge | take) head_value_d = value;
    if (tracer_reset_i) begin
      head_len_d = '0;
      head_value_d = '0;
    end
  end

  // --- Entries that leave the head, and the tail ----------------------------------------------
  wire logic add = split | take;
  wire logic eat_entry = (tail_len_q == '0) & consume_i & ~head_only;
  wire logic [ShortBits-1:0] pushed_len = split ? '1 : head_len_q[ShortBits-1:0];
  wire logic [ShortBits+ValueBits-1:0] pushed = {pushed_len, head_value_q};

  logic [ShortBits+ValueBits-1:0] oldest;  // entry behind the tail
  always_comb begin
    oldest = pushed;
    for (int i = 0; i < QueueSize; i++) if (tail_ptr_q == PointerBits'(i)) oldest = queue_q[i];
  end

  always_comb begin
    tail_len_d = tail_len_q - ShortBits'(consume_i);
    tail_value_d = tail_value_q;
    if (eat_entry | (head_only & add)) {tail_len_d, tail_value_d} = oldest;
    tail_ptr_d = tail_ptr_q + PointerBits'(eat_entry) - PointerBits'(add);
    if (tracer_reset_i) tail_ptr_d = OnlyHead;
  end

  always_ff @(posedge clk_i) begin
    head_len_q <= head_len_d;
    head_value_q <= head_value_d;
    tail_len_q <= tail_len_d;
    tail_value_q <= tail_value_d;
    tail_ptr_q <= tail_ptr_d;
    if (add) begin
      for (int i = 0; i < QueueSize - 1; i++) queue_q[i] <= queue_q[i+1];
      queue_q[QueueSize-1] <= pushed;
    end
  end

  assign ack_o = merge | take;
  assign starving_o = starving;
  wire logic [ValueBits-1:0] display = head_only ? head_value_q : tail_value_q;
  assign display_o = display[1:0];
  assign display_half_o = ValueBits > 2 && display[ValueBits-1];
  assign fill_o = 7'(FifoEntries) - 7'(tail_ptr_q);

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (!tracer_reset_i)
      assert (tail_ptr_q <= OnlyHead)
      else $error("it has more entries than there are");
`endif
endmodule

`default_nettype wire
