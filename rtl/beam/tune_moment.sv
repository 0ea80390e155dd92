// tune_moment: what a track plays at one moment, and for how long it has and will.
// Contract: sc/beam/tune.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

(* keep_hierarchy *)  // flattened, the SHARE pass of yosys finds no end
module tune_moment (
    input wire logic [6:0] bar_i,
    input wire logic [3:0] step_i,  // sixteenth of the bar, 8400 samples
    input wire logic [13:0] in_step_i,  // samples since the step began
    output logic [7:0] note_o,  // 0: silence
    output logic [17:0] since_o,  // samples since the note began
    output logic [17:0] left_o  // samples of the note that follow
);
  localparam logic [17:0] StepSamples = 18'd8400;
  localparam logic [7:0] GoesOn = 8'hff;

  wire logic [127:0] steps;
  tune_bars u_tune_bars (
      .bar_i(bar_i),
      .steps_o(steps)
  );

  logic [7:0] text;
  logic [3:0] age;  // steps since the note began
  logic [3:0] rest;  // steps of it that follow
  logic ended;
  always_comb begin
    note_o = '0;
    age = '0;
    rest = '0;
    ended = 1'b0;
    for (int i = 0; i < 16; i++) begin
      text = steps[8*(15-i)+:8];
      if (4'(i) <= step_i) begin
        age = age + 4'd1;
        if (text != GoesOn) begin
          note_o = text;
          age = '0;
        end
      end else begin
        if (text != GoesOn) ended = 1'b1;
        if (!ended) rest = rest + 4'd1;
      end
    end
  end

  assign since_o = 18'(age) * StepSamples + 18'(in_step_i);
  assign left_o = 18'(rest) * StepSamples + StepSamples - 18'd1 - 18'(in_step_i);
endmodule

`default_nettype wire
