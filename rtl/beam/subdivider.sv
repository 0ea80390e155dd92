// subdivider: traces a scan line as intervals of pixels through the decision tree.
// Contract: sc/beam/subdivider.h
//
// The two bounds of a step are nlo and nhi; for LEFT and RETURN they are doubled, so that one rule
// finds the power of two. They are stored in lo_q and hi_q in every clock that advances.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module subdivider #(
    parameter int IntervalStackDepth = 4,
    parameter int HurryThreshold = 32,
    parameter int Bisection = 0,  // 0: pow2, 1: midpoint, 2: floor
    parameter int PortalsPerFace = 1
) (
    // Clock; phase of the line
    input  wire logic clk_i,
    input  wire logic tracer_reset_i,
    // camera_unit
    input  wire logic idx_load_i,
    input  wire logic [racebeam_pkg::PixelBits-1:0] idx_start_i,
    input  wire logic [racebeam_pkg::PixelBits-1:0] i2_init_i,
    // decision_datapath: the decision
    output logic [1:0] state_o,
    input  wire logic [3:0] dec_i,
    input  wire logic [3:0] mask_i,
    input  wire logic wall_i,
    input  wire logic second_i,
    /* verilator lint_off UNUSEDSIGNAL */  // upper bits: with several portals in a face only
    input  wire logic [racebeam_pkg::TagPortBits-1:0] tag_i,  // {portal, depth, level}
    /* verilator lint_on UNUSEDSIGNAL */
    // decision_datapath: the move
    output logic descend_o,
    output logic climb_o,
    output logic [3:0] cur_o,
    output logic [1:0] leave_o,
    output logic [2:0] ray_signs_o,
    output logic restart_o,
    // interval_fifo
    output logic emit_o,
    output logic [racebeam_pkg::PixelBits-1:0] len_m1_o,
    input  wire logic ack_i,
    input  wire logic starving_i,
    // ray_stepper
    output logic step_o,
    output logic neg_o,
    output logic [10:0] step_size_o,
    output logic [racebeam_pkg::PixelBits-1:0] idx2_o,
    output logic copy_sub_o,
    // stacks: the entry written is {tag, i2}
    output logic push_en_o,
    output logic [racebeam_pkg::PixelBits-1:0] i2_o,
    output logic [racebeam_pkg::StackPointerPortBits-1:0] sp_o,
    output logic [racebeam_pkg::StackCountPortBits-1:0] sd_o,
    /* verilator lint_off UNUSEDSIGNAL */  // upper bits: with several portals in a face only
    input  wire logic [racebeam_pkg::TagPortBits-1:0] top_tag_i,
    /* verilator lint_on UNUSEDSIGNAL */
    input  wire logic [racebeam_pkg::PixelBits-1:0] top_i2_i,
    // Lock effect
    input  wire logic lock_i,
    input  wire logic consume_i,
    // Line
    output logic line_done_o
);
  localparam int TagWidth = PortalsPerFace > 1 ? racebeam_pkg::TagPortBits : racebeam_pkg::TagBits;
  localparam int PointerBits = IntervalStackDepth > 1 ? $clog2(IntervalStackDepth) : 1;
  localparam int CountBits = $clog2(IntervalStackDepth + 1);
  localparam logic [PointerBits-1:0] LastEntry = PointerBits'(IntervalStackDepth - 1);
  localparam logic [CountBits-1:0] Full = CountBits'(IntervalStackDepth);

  typedef logic [racebeam_pkg::PixelBits-1:0] pixel;

  racebeam_pkg::subdivider_state state_q, state_d, next_state;
  pixel i1_q, i1_d, i2_q, i2_d, next_i2, lo_q, lo_d, hi_q, hi_d, idx2_q, idx2_d;
  logic [3:0] d1_q, d1_d;
  logic emit_done_q, emit_done_d, was_return_q, line_done_q, line_done_d;
  logic [PointerBits-1:0] sp_q, sp_d;
  logic [CountBits-1:0] sd_q, sd_d;

  // Hit, offer, climb.
  wire logic accept = state_q != racebeam_pkg::StateReturn && idx2_q == i2_q && !emit_done_q;
  wire pixel len_m1 = i2_q - i1_q;
  wire logic hurry = starving_i && $signed({22'b0, len_m1}) <= HurryThreshold;
  wire logic hit_now = accept && (wall_i || hurry);
  wire logic returning = !tracer_reset_i && (hit_now || state_q == racebeam_pkg::StateReturn);
  wire logic emit = returning && !emit_done_q && !line_done_q;
  wire logic pending = emit && !ack_i;
  wire logic need_climb =
      returning && (tag_i[TagWidth-1:0] != top_tag_i[TagWidth-1:0] || second_i);
  wire logic enable = !need_climb && !second_i && !pending;
  wire logic restart = sd_q == '0 && state_q == racebeam_pkg::StateReturn && returning && !pending;
  wire logic advance = (enable && !hit_now) || restart;
  wire logic agree = ((d1_q ^ dec_i) & mask_i) == '0;
  wire logic [3:0] cur = state_q == racebeam_pkg::StateLeft ? dec_i : d1_q;

  // The move of this clock.
  logic want_step, force_step, neg, want_descend, push, one_pixel, bisecting;
  logic [10:0] nlo, nhi;
  wire logic [11:0] distance = {1'b0, nhi} - {1'b0, nlo};

  always_comb begin
    next_state = racebeam_pkg::StateLeft;
    next_i2 = i2_q;
    {nlo, nhi} = {1'b0, lo_q, 1'b0, hi_q};
    {want_step, force_step, neg, want_descend, push, one_pixel, bisecting} = '0;
    if (returning) begin
      next_i2 = top_i2_i;
      force_step = 1'b1;
      if (state_q != racebeam_pkg::StateReturn) begin
        want_step = 1'b1;
        one_pixel = 1'b1;
      end else begin
        {nlo, nhi} = {idx2_q, 1'b0, top_i2_i, 1'b0};
        want_step = idx2_q != top_i2_i;
        neg = top_i2_i < idx2_q;
      end
    end else if (tracer_reset_i || state_q == racebeam_pkg::StateLeft) begin
      {nlo, nhi} = {idx2_q, 1'b0, i2_q, 1'b0};
      want_step = idx2_q != i2_q;
      force_step = want_step;
      neg = i2_q < idx2_q;
      if (!want_step) begin
        want_descend = i1_q == i2_q;
        if (!want_descend) next_state = racebeam_pkg::StateRight;
      end
    end else if (state_q == racebeam_pkg::StateRight && agree) begin
      want_descend = 1'b1;
    end else begin
      if (state_q == racebeam_pkg::StateRight) {nlo, nhi} = {1'b0, i1_q, 1'b0, i2_q};
      else if (agree) nlo = {1'b0, idx2_q};
      else nhi = {1'b0, idx2_q};
      neg = !agree;
      next_state = racebeam_pkg::StateBisect;
      want_step = 1'b1;
      bisecting = 1'b1;
      if (nhi - nlo == 11'd1) begin  // found: the left part goes on, the right one waits
        push = 1'b1;
        want_descend = 1'b1;
        next_state = racebeam_pkg::StateLeft;
        next_i2 = nlo[9:0];
        want_step = !agree;
        neg = 1'b1;
        one_pixel = 1'b1;
      end
    end
  end

  // Size of the step: the closest power of two to half the distance, or half of it, or the power
  // below.
  wire logic [10:0] span = distance[11] ? ~distance[10:0] : distance[10:0];
  logic [10:0] power, step_size;
  always_comb begin
    power = 11'd1;
    for (int k = 1; k <= 10; k++) if (32'(span) >= 3 << (k - 1)) power = 11'd1 << k;
    step_size = power;
    if (bisecting && Bisection == 1 && $signed(distance) > 12'sd1)
      step_size = agree ? {1'b0, span[10:1]} : span - {1'b0, span[10:1]};
    if (bisecting && Bisection == 2 && $signed(distance) > 12'sd1)
      for (int k = 0; k <= 9; k++) if (span[k+1]) step_size = 11'd1 << k;
    if (one_pixel) step_size = 11'd1;
  end

  wire logic locked = lock_i && !tracer_reset_i;
  assign step_o = locked ? consume_i : want_step && (advance || force_step) && !restart;
  assign neg_o = !locked && neg;
  assign step_size_o = locked ? 11'd1 : step_size;
  assign copy_sub_o = returning && state_q == racebeam_pkg::StateReturn && !was_return_q;
  assign push_en_o = advance && push;
  assign descend_o = advance && want_descend && !returning;
  assign climb_o = need_climb && !pending;
  assign cur_o = descend_o ? cur : '0;
  wire logic leaves = tag_i[2:0] == 3'd7 || (PortalsPerFace > 1 && !tag_i[2] && cur[0]);
  assign leave_o = descend_o && leaves ? {1'b1, cur[0]} : '0;
  assign restart_o = restart;
  assign emit_o = emit;

  always_comb begin
    state_d = state_q;
    i2_d = i2_q;
    {sp_d, sd_d} = {sp_q, sd_q};
    if (tracer_reset_i || restart) begin
      state_d = racebeam_pkg::StateLeft;
      i2_d = i2_init_i;
      {sp_d, sd_d} = '0;
    end else if (advance) begin
      state_d = next_state;
      i2_d = next_i2;
      if (returning) begin
        sp_d = sp_q == '0 ? LastEntry : sp_q - 1'b1;
        sd_d = sd_q - 1'b1;
      end else if (push) begin
        sp_d = sp_q == LastEntry ? '0 : sp_q + 1'b1;
        if (sd_q != Full) sd_d = sd_q + 1'b1;
      end
    end else if (returning) begin
      state_d = racebeam_pkg::StateReturn;
    end

    i1_d = tracer_reset_i ? '0 : advance && returning ? i2_q + 1'b1 : i1_q;
    {lo_d, hi_d} = advance && !tracer_reset_i ? {nlo[9:0], nhi[9:0]} : {lo_q, hi_q};
    idx2_d = idx2_q;
    if (idx_load_i) idx2_d = idx_start_i;
    else if (step_o) idx2_d = neg_o ? idx2_q - step_size_o[9:0] : idx2_q + step_size_o[9:0];
    d1_d = tracer_reset_i ? '0 : d1_q;
    if (advance && state_q == racebeam_pkg::StateLeft) d1_d = (d1_d & ~mask_i) | (dec_i & mask_i);
    emit_done_d = !tracer_reset_i && ((emit_done_q && !advance) || ack_i);
    line_done_d = !tracer_reset_i
        && (line_done_q || (i2_q == 10'(racebeam_pkg::LastPixel) && returning && ack_i));
  end

  always_ff @(posedge clk_i) begin
    state_q <= state_d;
    i1_q <= i1_d;
    i2_q <= i2_d;
    lo_q <= lo_d;
    hi_q <= hi_d;
    idx2_q <= idx2_d;
    d1_q <= d1_d;
    emit_done_q <= emit_done_d;
    was_return_q <= !tracer_reset_i && state_q == racebeam_pkg::StateReturn;
    line_done_q <= line_done_d;
    sp_q <= sp_d;
    sd_q <= sd_d;
  end

  assign state_o = state_q;
  assign ray_signs_o = d1_q[3:1];
  assign len_m1_o = len_m1;
  assign idx2_o = idx2_q;
  assign i2_o = i2_q;
  assign sp_o = racebeam_pkg::StackPointerPortBits'(sp_q);
  assign sd_o = racebeam_pkg::StackCountPortBits'(sd_q);
  assign line_done_o = line_done_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (!tracer_reset_i)
      assert (32'(sp_q) < IntervalStackDepth)
      else $error("the stack pointer is beyond the stack");
`endif
endmodule

`default_nettype wire
