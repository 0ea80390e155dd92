// store_arbiter: who has the memory in this clock, the beam or the tracer.
// Contract: sc/store/store_arbiter.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module store_arbiter #(
    parameter int WritePolicy = 0  // 0: sync, 1: blanking, 2: free
) (
    // Beam: frame_scanout, and vga_timing in the same clock
    input  wire logic read_i,
    input  wire logic [19:0] read_address_i,
    /* verilator lint_off UNUSEDSIGNAL */  // by the policy, one of them or none
    input  wire logic sync_i,  // hsync or vsync is low
    input  wire logic blank_i,  // no visible pixel
    /* verilator lint_on UNUSEDSIGNAL */
    // write_buffer
    input  wire logic take_valid_i,
    input  wire logic [19:0] take_address_i,
    input  wire logic [63:0] take_data_i,
    output logic take_ready_o,
    // frame_memory
    output logic mem_write_o,
    output logic [19:0] mem_address_o,
    output logic [63:0] mem_data_o
);
  wire logic allowed = WritePolicy == 0 ? sync_i : WritePolicy == 1 ? blank_i : 1'b1;

  assign take_ready_o = allowed && !read_i;
  assign mem_write_o = take_valid_i && take_ready_o;
  assign mem_address_o = mem_write_o ? take_address_i : read_address_i;
  assign mem_data_o = take_data_i;
endmodule

`default_nettype wire
