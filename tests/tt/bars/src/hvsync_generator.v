// The usual counters from 0, and syncs through a register: they come a clock after the counters.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`include "video.vh"

module hvsync_generator (
    input clk,
    input reset,
    output reg hsync,
    output reg vsync,
    output display_on,
    output reg [9:0] hpos,
    output reg [9:0] vpos
);
  wire last_column = hpos == `H_MAX;
  wire last_row = vpos == `V_MAX;

  always @(posedge clk) begin
    hsync <= hpos >= `H_SYNC_START && hpos <= `H_SYNC_END;
    vsync <= vpos >= `V_SYNC_START && vpos <= `V_SYNC_END;
    hpos <= last_column || reset ? 0 : hpos + 1;
    if (reset) vpos <= 0;
    else if (last_column) vpos <= last_row ? 0 : vpos + 1;
  end

  assign display_on = hpos < `H_DISPLAY && vpos < `V_DISPLAY;
endmodule
