// stacks as somebody else would write it: two small memories, no packages, no parameters.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
module stacks (
    input clk_i,
    input push_en_i,
    input [8:0] tag_i,
    input [9:0] i2_i,
    input [5:0] sp_i,
    output [8:0] top_tag_o,
    output [9:0] top_i2_o,
    input fwrite_i,
    input [5:0] fdata_i,
    output [5:0] fread_o
);
  reg [16:0] intervals[0:3];
  reg [1:0] faces[0:15];
  wire [3:0] depth = tag_i[6:3];

  always @(posedge clk_i) begin
    if (push_en_i) intervals[sp_i[1:0]] <= {tag_i[6:0], i2_i};
    if (fwrite_i) faces[depth] <= fdata_i[1:0];
  end

  wire [1:0] top = sp_i[1:0] - 2'd1;
  assign {top_tag_o, top_i2_o} = {2'd0, intervals[top]};
  assign fread_o = depth == 0 || depth > 9 ? 6'd0 : {4'd0, faces[depth-4'd1]};
endmodule
