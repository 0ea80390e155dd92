// channel_delay: registers in a channel between two units, as a pipeline would have them.
// Contract: sc/base/channel_delay.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module channel_delay #(
    parameter int Latency = 1,   // 1..63
    parameter int Capacity = 2,  // Latency or more
    parameter int Width = 64     // 1 or more
) (
    input wire logic clk_i,
    input wire logic clear_i,
    input wire logic offer_valid_i,
    input wire logic [Width-1:0] offer_data_i,
    output logic offer_ready_o,
    output logic offer_ack_o,
    output logic take_valid_o,
    output logic [Width-1:0] take_data_o,
    input wire logic take_ready_i
);
  localparam int CountBits = $clog2(Capacity + 1);
  localparam int PlaceBits = Capacity > 1 ? $clog2(Capacity) : 1;

  logic [Width-1:0] entries_q[Capacity];
  logic [CountBits-1:0] count_q, arrived_q;
  logic [PlaceBits-1:0] write_q, read_q;

  localparam logic [PlaceBits-1:0] LastPlace = PlaceBits'(Capacity - 1);
  wire logic [PlaceBits-1:0] after_write = write_q == LastPlace ? '0 : write_q + 1'b1;
  wire logic [PlaceBits-1:0] after_read = read_q == LastPlace ? '0 : read_q + 1'b1;

  wire logic put = offer_valid_i && offer_ready_o;
  wire logic take = take_ready_i && take_valid_o;
  assign offer_ready_o = count_q != CountBits'(Capacity);
  assign offer_ack_o = put;
  assign take_valid_o = arrived_q != '0;
  assign take_data_o = entries_q[read_q];

  wire logic arrives;
  if (Latency > 1) begin : g_way
    logic [Latency-2:0] on_the_way_q;
    always_ff @(posedge clk_i)
      if (clear_i) on_the_way_q <= '0;
      else on_the_way_q <= (Latency - 1)'({on_the_way_q, put});
    assign arrives = on_the_way_q[Latency-2];
  end else begin : g_no_way
    assign arrives = put;
  end

  always_ff @(posedge clk_i) begin
    if (clear_i) begin
      count_q <= '0;
      arrived_q <= '0;
      write_q <= '0;
      read_q <= '0;
    end else begin
      count_q <= count_q + CountBits'(put) - CountBits'(take);
      arrived_q <= arrived_q + CountBits'(arrives) - CountBits'(take);
      if (put) begin
        entries_q[write_q] <= offer_data_i;
        write_q <= after_write;
      end
      if (take) read_q <= after_read;
    end
  end
endmodule

`default_nettype wire
