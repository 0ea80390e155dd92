// camera_unit: once per line, the ray direction of pixel 0 and its change per pixel.
// Two state machines: the passes of a line, and the factors of a product of sines.
// Contract: sc/beam/camera_unit.h
//
// The quadrant of an axis that takes no part in a factor is free: it is that of offset 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module camera_unit #(
    parameter int DrBits = 10,
    parameter int HeadStart = 0,
    parameter int DdrFractionBits = 9
) (
    // Clock, reset, line
    input  wire logic clk_i,
    input  wire logic rst_ni,
    input  wire logic line_end_i,
    /* verilator lint_off UNUSEDSIGNAL */  // bit 9: lines count modulo 512
    input  wire logic signed [9:0] y_i,
    /* verilator lint_on UNUSEDSIGNAL */
    // sequencer
    output logic [1:0] src_o,
    input  wire logic [racebeam_pkg::AngleBits-1:0] angle_i,
    // Phase of the line
    output logic run_o,
    output logic tracer_reset_o,
    // ray_stepper
    /* verilator lint_off UNUSEDSIGNAL */  // upper bits: for the widest DrBits only
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_x_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_y_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_z_i,
    /* verilator lint_on UNUSEDSIGNAL */
    output logic load_o,
    output logic load_zero_o,
    output logic ext_o,
    output logic [2:0] ext_sign_o,
    output logic [2:0] axis_mask_o,
    output logic signed [racebeam_pkg::DdrPortBits-1:0] delta_x_o,
    output logic signed [racebeam_pkg::DdrPortBits-1:0] delta_y_o,
    output logic signed [racebeam_pkg::DdrPortBits-1:0] delta_z_o,
    output logic copy_ext_o,
    // subdivider
    input  wire logic step_i,
    output logic idx_load_o,
    output logic [racebeam_pkg::PixelBits-1:0] idx_start_o,
    output logic [racebeam_pkg::PixelBits-1:0] i2_init_o
);
  localparam int PixelBits = racebeam_pkg::PixelBits;
  localparam int DdrBits = DrBits + 1;
  localparam int DdrPortBits = racebeam_pkg::DdrPortBits;
  localparam int WaitBits = 9;
  localparam logic [1:0] Forward = 2'd0, Down = 2'd1, Right = 2'd2;
  localparam logic [1:0] Yaw = 2'd0, Pitch = 2'd1, Fov = 2'd2;
  localparam logic [1:0] Yaw0 = 2'd0, Pitch2 = 2'd2, Sign3 = 2'd3;  // values of pstage_q

  typedef enum logic [1:0] {Product = 2'd0, Load = 2'd1, Scale = 2'd2, Run = 2'd3} phase_e;

  logic [1:0] pass_q, pass_d, pstage_q, pstage_d, pclk_q, pclk_d;
  phase_e phase_q, phase_d;
  logic step_seen_q;
  logic [2:0] psign_q, psign_d;
  logic [DdrBits-1:0] ddr_x_q, ddr_y_q, ddr_z_q;

  logic camera_reset, scaled, waited, finish, preset, in_control, pstage_done, pdone;
  assign camera_reset = line_end_i || !rst_ni;
  assign scaled = phase_q == Scale && !step_i && !step_seen_q;
  assign finish = scaled && (pass_q != Right || waited);
  assign preset = camera_reset || (scaled && pass_q != Right);
  assign in_control = phase_q == Product || preset;
  assign pstage_done = pstage_q != Sign3 && pclk_q == 2'd3 && !step_i;
  assign pdone = pstage_q == Sign3 && pclk_q == 2'd2;

  // --- The factor: which axes are of cosine type, which negative -------------------------------
  logic [8:0] frac, inv;
  logic [5:0] offsets;  // 2 bits an axis, x lowest
  logic [2:0] cosine, negative, one, zero;

  assign frac = angle_i[8:0];
  assign inv = ~frac;

  always_comb begin
    unique case (pass_q)
      Forward: offsets = pstage_q == Yaw0 ? {2'd1, 2'd0, 2'd0} : {2'd1, 2'd0, 2'd1};
      Down: offsets = pstage_q == Yaw0 ? {2'd3, 2'd0, 2'd2} : {2'd0, 2'd1, 2'd0};
      default: offsets = pstage_q == Yaw0 ? {2'd2, 2'd0, 2'd1} : 6'd0;
    endcase
    one = pass_q == Right ? 3'b000 : 3'b010;
    zero = pass_q == Right ? 3'b010 : 3'b000;
    for (int a = 0; a < 3; a++)
      {negative[a], cosine[a]} = angle_i[10:9] + offsets[2*a +: 2];
    if (pstage_q == Yaw0) negative = negative & ~one;
  end

  // --- Controls --------------------------------------------------------------------------------
  logic sum_delta;  // delta is a part of the angle, not ddr
  logic [8:0] part;
  logic full_scale;  // all ones, whatever the width
  logic [2:0] product_mask;
  logic [PixelBits-1:0] product_i2, target;
  logic [DrBits-1:0] part_dr;  // in the scale of dr

  always_comb begin
    product_mask = 3'b111;
    product_i2 = PixelBits'(frac);
    part = inv;
    full_scale = 1'b0;
    unique case (pstage_q)
      Yaw0:
      unique case (pclk_q)
        2'd0: begin
          part = frac;
          product_mask = ~cosine & ~one;
          product_i2 = '0;
        end
        2'd1: begin
          product_mask = cosine & ~one;
          product_i2 = '0;
        end
        2'd2: begin
          part = 9'd511;
          full_scale = 1'b1;
          product_mask = one;
        end
        default: product_mask = ~one;
      endcase
      2'd1: begin
        if (pclk_q == 2'd0) product_mask = ~cosine;
        product_i2 = PixelBits'(inv);
      end
      Pitch2: if (pclk_q == 2'd0) product_mask = cosine;
      default: ;
    endcase
    product_mask = product_mask & ~zero;
    if (preset || pstage_done) product_i2 = '0;
  end

  assign part_dr = DrBits'({1'b0, part, {3{full_scale}}} >> (13 - DrBits));

  always_comb begin
    unique case (pass_q)
      Forward: target = angle_i[PixelBits-1:0];
      Down: target = {1'b0, ~y_i[8], y_i[7:0]};
      default: target = PixelBits'(192);
    endcase
    sum_delta = in_control && pstage_q == Yaw0;
    src_o = !in_control ? Fov : pstage_q == Yaw0 ? Yaw : Pitch;
    load_o = in_control ? preset || pstage_done : phase_q == Load;
    load_zero_o = in_control || phase_q != Load || pass_q == Forward;
    ext_o = in_control && (pstage_q == Sign3 || pclk_q == 2'd0 ||
                           (pstage_q == Yaw0 && pclk_q != 2'd3));
    ext_sign_o = in_control && pstage_q == Sign3 ? psign_q : 3'b000;
    axis_mask_o = in_control ? product_mask : 3'b111;
    copy_ext_o = finish;
    idx_load_o = load_o || (finish && pass_q == Right);
    idx_start_o = '0;
    i2_init_o = product_i2;
    if (!in_control) begin
      if (phase_q == Load) idx_start_o = {pass_q, 8'd0};
      i2_init_o = phase_q == Run || finish ? PixelBits'(racebeam_pkg::LastPixel) : target;
    end
  end
  assign delta_x_o = sum_delta ? DdrPortBits'(part_dr) : DdrPortBits'($signed(ddr_x_q));
  assign delta_y_o = sum_delta ? DdrPortBits'(part_dr) : DdrPortBits'($signed(ddr_y_q));
  assign delta_z_o = sum_delta ? DdrPortBits'(part_dr) : DdrPortBits'($signed(ddr_z_q));
  assign run_o = phase_q == Run;
  assign tracer_reset_o = camera_reset || phase_q != Run;

  // --- Next state ------------------------------------------------------------------------------
  always_comb begin
    pass_d = pass_q;
    phase_d = phase_q;
    unique case (phase_q)
      Product: if (pdone) phase_d = Load;
      Load: phase_d = Scale;
      Scale:
      if (finish) begin
        phase_d = pass_q == Right ? Run : Product;
        if (pass_q != Right) pass_d = pass_q + 2'd1;
      end
      default: ;
    endcase
  end

  always_comb begin
    pstage_d = pstage_q;
    pclk_d = pclk_q;
    psign_d = psign_q;
    if (preset) begin
      pstage_d = Yaw0;
      pclk_d = 2'd0;
      psign_d = 3'b000;
    end else if (pstage_done) begin
      pstage_d = pass_q == Right ? Sign3 : pstage_q + 2'd1;
      pclk_d = 2'd0;
      if (pstage_q == Yaw0 || pstage_q == Pitch2) psign_d = psign_q ^ negative;
    end else begin
      unique case (pstage_q)
        Yaw0: if (pclk_q != 2'd3) pclk_d = pclk_q + 2'd1;
        Sign3: pclk_d = pclk_q < 2'd2 ? 2'd3 : 2'd2;
        default: pclk_d = 2'd3;
      endcase
    end
  end

  if (HeadStart != 0) begin : g_wait
    logic [WaitBits-1:0] wait_q;
    assign waited = wait_q == WaitBits'(HeadStart);
    always_ff @(posedge clk_i)
      if (camera_reset) wait_q <= '0;
      else if (scaled && pass_q == Right && !waited) wait_q <= wait_q + 1'b1;
  end else begin : g_no_wait
    assign waited = 1'b1;
  end

  logic ddr_write, ddr_signed;
  logic [DdrBits-1:0] kept;  // of ddr as the tracer has it
  assign kept = ddr_signed && pass_q == Right
              ? DdrBits'(-1) << (racebeam_pkg::DdrFractionBits - DdrFractionBits) : '1;
  assign ddr_signed = pstage_q == Sign3;
  assign ddr_write = ddr_signed ? pclk_q == 2'd3 : pstage_done;

  always_ff @(posedge clk_i) begin
    if (camera_reset) begin
      pass_q <= Forward;
      phase_q <= Product;
      step_seen_q <= 1'b0;
    end else begin
      pass_q <= pass_d;
      phase_q <= phase_d;
      step_seen_q <= step_i;
    end
    pstage_q <= pstage_d;
    pclk_q <= pclk_d;
    psign_q <= psign_d;
    if (ddr_write) begin
      ddr_x_q <= {ddr_signed && dr2_x_i[DrBits-1], dr2_x_i[DrBits-1:0]} & kept;
      ddr_y_q <= {ddr_signed && dr2_y_i[DrBits-1], dr2_y_i[DrBits-1:0]} & kept;
      ddr_z_q <= {ddr_signed && dr2_z_i[DrBits-1], dr2_z_i[DrBits-1:0]} & kept;
    end
  end
endmodule

`default_nettype wire
