// delayed_interval_fifo: interval_fifo behind the registers of a delayed channel "interval"; its
// pins are those of interval_fifo.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module delayed_interval_fifo #(
    parameter int Latency = 1,
    parameter int Capacity = 2,
    parameter int FifoEntries = 10,
    parameter int FifoShortLengthBits = 6,
    parameter int FifoMerge = 1,
    parameter int Dithering = 1
) (
    input wire logic clk_i,
    input wire logic tracer_reset_i,
    input wire logic emit_i,
    input wire logic [racebeam_pkg::PixelBits-1:0] len_m1_i,
    input wire logic [1:0] value_i,
    input wire logic half_i,
    output logic ack_o,
    output logic starving_o,
    input wire logic consume_i,
    output logic [1:0] display_o,
    output logic display_half_o,
    output logic [6:0] fill_o
);
  localparam int Width = racebeam_pkg::PixelBits + 3;

  wire logic late_emit, late_half, late_ack;
  wire logic [racebeam_pkg::PixelBits-1:0] late_len_m1;
  wire logic [1:0] late_value;

  channel_delay #(
      .Latency(Latency),
      .Capacity(Capacity),
      .Width(Width)
  ) u_channel_delay (
      .clk_i(clk_i),
      .clear_i(tracer_reset_i),
      .offer_valid_i(emit_i),
      .offer_data_i({len_m1_i, value_i, half_i}),
      .offer_ready_o(),
      .offer_ack_o(ack_o),
      .take_valid_o(late_emit),
      .take_data_o({late_len_m1, late_value, late_half}),
      .take_ready_i(late_ack)
  );

  interval_fifo #(
      .FifoEntries(FifoEntries),
      .FifoShortLengthBits(FifoShortLengthBits),
      .FifoMerge(FifoMerge),
      .Dithering(Dithering)
  ) u_interval_fifo (
      .clk_i(clk_i),
      .tracer_reset_i(tracer_reset_i),
      .emit_i(late_emit),
      .len_m1_i(late_len_m1),
      .value_i(late_value),
      .half_i(late_half),
      .ack_o(late_ack),
      .starving_o(starving_o),
      .consume_i(consume_i),
      .display_o(display_o),
      .display_half_o(display_half_o),
      .fill_o(fill_o)
  );
endmodule

`default_nettype wire
