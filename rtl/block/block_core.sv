// block_core: draws blocks of 16 x 16 pixels, one after the other.
// Contract: sc/block/block_core.h
//
// Vectors of three axes stand in one word, x on top; those of all lanes in one word, lane 0 at the
// bottom. Only the state is reset: each job, pixel and pass begins with fresh numbers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_core #(
    parameter int Lanes = 4,
    parameter int NewtonSteps = 2,
    parameter int SpecularSquarings = 4,
    parameter int MaxPasses = 3,
    parameter int Root = 0,
    parameter int ShadowRays = 0,
    parameter int Cull = 0,  // 0: corners, 1: cone, 2: off
    parameter int Background = 0,  // {red, green, blue}
    parameter int PictureWidth = 640,
    parameter int PictureHeight = 480
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // block_scheduler
    input  wire logic job_valid_i,
    input  wire logic [block_pkg::BlockPlaceBits-1:0] job_x_i,
    input  wire logic [block_pkg::BlockPlaceBits-1:0] job_y_i,
    output logic job_ready_o,
    output logic busy_o,
    // block_convert
    input  wire logic write_i,
    input  wire logic [block_pkg::BlockFieldBits-1:0] field_i,  // block_field
    input  wire logic [block_pkg::BlockIndexBits-1:0] index_i,
    input  wire logic [block_pkg::BlockBits-1:0] value_i,
    input  wire logic [block_pkg::BlockBits-1:0] eye_k_i,
    // The world
    input  wire logic [block_pkg::BlockCountBits-1:0] spheres_i,
    input  wire logic [block_pkg::BlockBits-1:0] eye_x_i,  // signed
    input  wire logic [block_pkg::BlockBits-1:0] eye_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] eye_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] light_x_i,  // signed
    input  wire logic [block_pkg::BlockBits-1:0] light_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] light_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] start_x_i,  // signed, of block (0, 0)
    input  wire logic [block_pkg::BlockBits-1:0] start_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] start_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] ax_i,  // from pixel to pixel
    input  wire logic [block_pkg::BlockBits-1:0] ay_i,
    /* verilator lint_off UNUSEDSIGNAL */  // of cull = cone
    input  wire logic [block_pkg::BlockBits-1:0] cone_sine_i,
    input  wire logic [block_pkg::BlockBits-1:0] cone_cosine2_i,
    /* verilator lint_on UNUSEDSIGNAL */
    // block_bus
    output logic word_valid_o,
    output logic [19:0] word_address_o,
    output logic [63:0] word_o,
    input  wire logic word_ready_i,
    // Waves and counters
    output logic [block_pkg::BlockStateBits-1:0] state_o,  // block_state
    output logic [block_pkg::BlockEventBits-1:0] event_o  // block_event, of the clock before
);
  localparam int Bits = block_pkg::BlockBits;
  localparam int RootBits = block_pkg::BlockRootBits;
  localparam int LongBits = block_pkg::BlockDistanceBits;
  localparam int IndexBits = block_pkg::BlockIndexBits;
  localparam int PlaceBits = block_pkg::BlockPlaceBits;
  localparam int LaneBits = $clog2(Lanes);
  localparam int Corners = 4;
  localparam int CornerLanes = Lanes < Corners ? Lanes : Corners;  // that test corners
  localparam int RowWords = PictureWidth / 8;
  localparam int PlaneWords = RowWords * PictureHeight;
  localparam logic [1:0] LastQuarter = 2'(Corners / CornerLanes - 1);
  localparam logic [3:0] AllPasses = 4'(MaxPasses);
  localparam logic [3:0] ClippedRow = 4'(PictureHeight - 1);  // last row of the last blocks

  typedef logic [IndexBits-1:0] index;

  localparam block_pkg::number Far = Bits'(block_pkg::BlockFar << block_pkg::BlockFraction);

  block_pkg::block_state state_q, state_d;
  block_pkg::block_event event_q, event_d;
  logic step_q, step_d;  // JOB, groups of later passes: the second clock; SHADOW: the last
  logic [PlaceBits-1:0] job_x_q, job_y_q;
  logic [3:0] column_q, column_d, row_q, row_d;
  logic [1:0] plane_q, plane_d;
  logic [1:0] corner_q, corner_d;  // CORNER; CULL: the first of those that are tested
  block_pkg::number left_q, at_x_q, at_x_d, at_y_q, at_y_d;  // on the screen
  logic [Corners*3*Bits-1:0] corners_q;
  index index_q, index_d;  // CULL: a sphere; groups and what follows them: a group
  logic [3:0] pass_q, pass_d;  // passes that were shaded
  block_pkg::axes position_q, position_d, dir_q, dir_d, colour_q, colour_d;
  block_pkg::axes lit_q;  // to the light
  logic [Lanes-1:0] pending_q, pending_d;
  logic [Lanes-1:0] over_q;  // whose d is 8.0 and above
  logic [Lanes*Bits-1:0] b_q;
  logic [Lanes*RootBits-1:0] d_q;
  logic hit_q, hit_d;
  index nearest_q, nearest_d;
  block_pkg::number best_q, best_d;

  wire block_pkg::axes eye = {eye_x_i, eye_y_i, eye_z_i};

  wire logic in_corner = state_q == block_pkg::BlockCorner;
  wire logic in_cull = state_q == block_pkg::BlockCull;
  wire logic in_shade = state_q == block_pkg::BlockShade;
  wire logic in_shadow = state_q == block_pkg::BlockShadow;
  wire logic meets_light = ShadowRays != 0 && state_q >= block_pkg::BlockShadow;
  wire logic in_group = state_q == block_pkg::BlockGroup || state_q == block_pkg::BlockShadowGroup;
  wire logic in_near = state_q == block_pkg::BlockNear || state_q == block_pkg::BlockShadowNear;
  wire block_pkg::axes to_light =
      block_pkg::difference_of({light_x_i, light_y_i, light_z_i}, position_q);

  // --- The block on the screen -----------------------------------------------------------------
  wire logic [PlaceBits-1:0] pixels = step_q ? job_y_q : job_x_q;
  wire block_pkg::number steps = Bits'(pixels) * (step_q ? ay_i : ax_i);
  wire block_pkg::number right = (ax_i << 4) - ax_i;  // to the last pixel
  wire block_pkg::number down = (ay_i << 4) - ay_i;
  wire block_pkg::number half_right = right >>> 1;  // to the middle
  wire block_pkg::number half_down = down >>> 1;
  wire logic [PlaceBits-1:0] y = job_y_q + PlaceBits'(row_q);
  wire logic clipped = 32'(job_y_q) + block_pkg::BlockSide > PictureHeight;
  wire logic last_row = row_q == (clipped ? ClippedRow : 4'd15);
  wire logic first_pass = pass_q == '0;

  // --- Spheres, one lane each ------------------------------------------------------------------
  wire index group = in_cull ? index_q >> LaneBits : in_shade ? nearest_q >> LaneBits : index_q;
  wire index chosen = (in_cull ? index_q : nearest_q) & IndexBits'(Lanes - 1);
  wire logic secondary = in_group && step_q;
  wire logic [Lanes*Bits-1:0] b;
  wire logic [Lanes*LongBits-1:0] d;
  wire logic [Lanes-1:0] crossed;  // d > 0
  wire block_pkg::axes centre, base;
  /* verilator lint_off UNUSEDSIGNAL */  // of cull = cone
  wire block_pkg::number radius, radius2;
  /* verilator lint_on UNUSEDSIGNAL */

  block_lanes #(
      .Lanes(Lanes)
  ) u_block_lanes (
      .clk_i(clk_i),
      .write_i(write_i),
      .field_i(field_i),
      .index_i(index_i),
      .value_i(value_i),
      .eye_k_i(eye_k_i),
      .group_i(group),
      .chosen_i(chosen),
      .culls_i(in_cull),
      .measures_i(in_shadow),
      .first_pass_i(first_pass),
      .secondary_i(secondary),
      .corner_i(corner_q),
      .corners_i(corners_q),
      .to_light_i(to_light),
      .position_i(position_q),
      .dir_i(meets_light ? lit_q : dir_q),
      .b_o(b),
      .d_o(d),
      .crossed_o(crossed),
      .centre_o(centre),
      .base_o(base),
      .radius_o(radius),
      .radius2_o(radius2)
  );

  logic [Lanes-1:0] exists;
  for (genvar n = 0; n < Lanes; n++) begin : g_exists
    assign exists[n] = (32'(index_q) << LaneBits) + n < 32'(spheres_i);
  end

  logic keeps;
  if (Cull == 1) begin : g_cone
    wire block_pkg::number ahead = -b[0+:Bits];
    wire block_pkg::product ahead_sine = ahead * $signed(cone_sine_i);
    wire block_pkg::number reach =
        radius + block_pkg::BlockConeSlack + block_pkg::fixed_of(ahead_sine);
    wire block_pkg::number beside2 = radius2 - d[0+:Bits];
    wire block_pkg::product beside_cosine = beside2 * $signed(cone_cosine2_i);
    wire block_pkg::product reach2 = reach * reach;
    assign keeps = !reach[Bits-1]
        && block_pkg::fixed_of(beside_cosine) <= block_pkg::fixed_of(reach2);
  end else begin : g_corners
    assign keeps = crossed[CornerLanes-1:0] != '0;
  end
  wire logic [Lanes-1:0] own =  // of a ray to the light
      meets_light && index_q == nearest_q >> LaneBits ? Lanes'(1) << chosen : '0;
  wire logic [Lanes-1:0] hits = crossed & exists & ~own;
  wire logic last_sphere = 32'(index_q) + 1 >= 32'(spheres_i);
  wire logic last_group = (32'(index_q) + 1) << LaneBits >= 32'(spheres_i);
  wire logic none = spheres_i == '0;

  // --- The nearest: the lowest lane that waits --------------------------------------------------
  block_pkg::number near_b;
  logic [RootBits-1:0] near_d;
  index near_lane;
  logic near_over;
  logic [Lanes-1:0] others;  // that wait too
  always_comb begin
    near_b = '0;
    near_d = '0;
    near_lane = '0;
    near_over = 1'b0;
    for (int n = Lanes - 1; n >= 0; n--)
      if (pending_q[n]) begin
        near_b = b_q[n*Bits+:Bits];
        near_d = d_q[n*RootBits+:RootBits];
        near_lane = IndexBits'(n);
        near_over = over_q[n];
      end
    others = pending_q & (pending_q - 1'b1);
  end

  wire logic [RootBits-1:0] root;
  wire logic root_done;
  block_root #(
      .Root(Root)
  ) u_block_root (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(in_near),
      .d_i(near_d),
      .root_o(root),
      .done_o(root_done)
  );
  wire block_pkg::number t = -near_b - Bits'(root);
  wire logic nearer = t > 0 && t < best_q;

  // --- Unit vectors and light ------------------------------------------------------------------
  wire block_pkg::axes v, v_shade, unit_vector, point, direction, light_of_hit;
  wire logic unit_done, small_vector, normalise, shade_done;
  wire block_pkg::number corner_x =
      at_x_q + (Cull == 1 ? half_right : corner_q[1] ? right : '0);
  wire block_pkg::number corner_y =
      at_y_q - (Cull == 1 ? half_down : corner_q[1] ^ corner_q[0] ? down : '0);
  assign v = in_shade ? v_shade : in_shadow ? to_light
             : {in_corner ? corner_x : at_x_q, in_corner ? corner_y : at_y_q, start_z_i};

  block_normalise #(
      .NewtonSteps(NewtonSteps)
  ) u_block_normalise (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(in_corner || state_q == block_pkg::BlockPixel || in_shadow && !step_q || normalise),
      .v_x_i(v[2*Bits+:Bits]),
      .v_y_i(v[Bits+:Bits]),
      .v_z_i(v[0+:Bits]),
      .unit_x_o(unit_vector[2*Bits+:Bits]),
      .unit_y_o(unit_vector[Bits+:Bits]),
      .unit_z_o(unit_vector[0+:Bits]),
      .done_o(unit_done),
      .small_o(small_vector)
  );

  block_shade #(
      .SpecularSquarings(SpecularSquarings)
  ) u_block_shade (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(in_shade),
      .position_x_i(position_q[2*Bits+:Bits]),
      .position_y_i(position_q[Bits+:Bits]),
      .position_z_i(position_q[0+:Bits]),
      .dir_x_i(dir_q[2*Bits+:Bits]),
      .dir_y_i(dir_q[Bits+:Bits]),
      .dir_z_i(dir_q[0+:Bits]),
      .distance_i(best_q),
      .centre_x_i(centre[2*Bits+:Bits]),
      .centre_y_i(centre[Bits+:Bits]),
      .centre_z_i(centre[0+:Bits]),
      .light_x_i(light_x_i),
      .light_y_i(light_y_i),
      .light_z_i(light_z_i),
      .base_red_i(base[2*Bits+:Bits]),
      .base_green_i(base[Bits+:Bits]),
      .base_blue_i(base[0+:Bits]),
      .point_x_o(point[2*Bits+:Bits]),
      .point_y_o(point[Bits+:Bits]),
      .point_z_o(point[0+:Bits]),
      .direction_x_o(direction[2*Bits+:Bits]),
      .direction_y_o(direction[Bits+:Bits]),
      .direction_z_o(direction[0+:Bits]),
      .colour_red_o(light_of_hit[2*Bits+:Bits]),
      .colour_green_o(light_of_hit[Bits+:Bits]),
      .colour_blue_o(light_of_hit[0+:Bits]),
      .done_o(shade_done),
      .normalise_o(normalise),
      .v_x_o(v_shade[2*Bits+:Bits]),
      .v_y_o(v_shade[Bits+:Bits]),
      .v_z_o(v_shade[0+:Bits]),
      .unit_x_i(unit_vector[2*Bits+:Bits]),
      .unit_y_i(unit_vector[Bits+:Bits]),
      .unit_z_i(unit_vector[0+:Bits]),
      .unit_done_i(unit_done)
  );

  // --- Words -----------------------------------------------------------------------------------
  localparam logic [23:0] Behind = 24'(Background);
  /* verilator lint_off UNUSEDSIGNAL */  // what is below 1/256, and the sign
  function automatic logic [7:0] channel(input block_pkg::number value);
    channel = value[28:20] != '0 ? 8'hff : value[19:12];
  endfunction
  /* verilator lint_on UNUSEDSIGNAL */

  wire logic [63:0] red, green, blue;
  wire logic full;
  block_pack u_block_pack (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .valid_i(state_q == block_pkg::BlockStore),
      .red_i(first_pass ? Behind[16+:8] : channel(colour_q[2*Bits+:Bits])),
      .green_i(first_pass ? Behind[8+:8] : channel(colour_q[Bits+:Bits])),
      .blue_i(first_pass ? Behind[0+:8] : channel(colour_q[0+:Bits])),
      .red_o(red),
      .green_o(green),
      .blue_o(blue),
      .full_o(full)
  );

  wire logic clears = state_q == block_pkg::BlockClear;
  wire logic accepted = word_valid_o && word_ready_i;
  assign word_valid_o = clears || state_q == block_pkg::BlockWords;
  assign word_address_o = 20'(plane_q) * 20'(PlaneWords) + 20'(y) * 20'(RowWords)
      + 20'(job_x_q[PlaceBits-1:3]) + 20'(column_q[3]);
  always_comb begin
    unique case (plane_q)
      2'd0: word_o = clears ? {8{Behind[16+:8]}} : red;
      2'd1: word_o = clears ? {8{Behind[8+:8]}} : green;
      default: word_o = clears ? {8{Behind[0+:8]}} : blue;
    endcase
  end

  // --- What counters are told ------------------------------------------------------------------
  always_comb begin
    event_d = small_vector ? block_pkg::BlockSmallVector : block_pkg::BlockNoEvent;
    if (in_near && root_done && near_over) event_d = block_pkg::BlockRootOver;
    if (in_cull && Cull == 0)
      for (int n = CornerLanes - 1; n >= 0; n--)
        if (crossed[n])
          unique case (corner_q + 2'(n))
            2'd0: event_d = block_pkg::BlockKept0;
            2'd1: event_d = block_pkg::BlockKept1;
            2'd2: event_d = block_pkg::BlockKept2;
            default: event_d = block_pkg::BlockKept3;
          endcase
  end

  // --- States ----------------------------------------------------------------------------------
  logic pass_ends, dark;  // dark: in the shadow, its light does not count
  always_comb begin
    state_d = state_q;
    step_d = step_q;
    {column_d, row_d, plane_d} = {column_q, row_q, plane_q};
    corner_d = corner_q;
    {at_x_d, at_y_d} = {at_x_q, at_y_q};
    index_d = index_q;
    pass_d = pass_q;
    {position_d, dir_d, colour_d} = {position_q, dir_q, colour_q};
    pending_d = pending_q;
    {hit_d, nearest_d, best_d} = {hit_q, nearest_q, best_q};
    pass_ends = 1'b0;
    dark = 1'b0;
    unique case (state_q)
      block_pkg::BlockIdle: begin
        step_d = 1'b0;
        {column_d, row_d, plane_d, corner_d, index_d} = '0;
        if (job_valid_i) state_d = block_pkg::BlockJob;
      end
      block_pkg::BlockJob: begin
        step_d = !step_q;
        if (step_q) begin
          at_y_d = start_y_i - steps;
          state_d = Cull == 2 ? block_pkg::BlockPixel : block_pkg::BlockCorner;
        end else begin
          at_x_d = start_x_i + steps;
        end
      end
      block_pkg::BlockCorner:
      if (unit_done) begin
        corner_d = Cull == 1 ? '0 : corner_q + 1'b1;
        if (Cull == 1 || corner_q == 2'd3) state_d = none ? block_pkg::BlockClear : block_pkg::BlockCull;
      end
      block_pkg::BlockCull: begin
        if (Cull == 0 && LastQuarter != '0) corner_d = corner_q + 2'(CornerLanes);
        if (keeps) state_d = block_pkg::BlockPixel;
        else if (Cull == 1 || LastQuarter == '0 || corner_q == 2'(Corners - CornerLanes)) begin
          index_d = index_q + 1'b1;
          if (last_sphere) state_d = block_pkg::BlockClear;
        end
      end
      block_pkg::BlockClear:
      if (accepted) begin
        column_d[3] = !column_q[3];
        if (column_q[3]) begin
          plane_d = plane_q == 2'd2 ? 2'd0 : plane_q + 1'b1;
          if (plane_q == 2'd2) begin
            row_d = row_q + 1'b1;
            if (last_row) state_d = block_pkg::BlockIdle;
          end
        end
      end
      block_pkg::BlockPixel:
      if (unit_done) begin
        dir_d = unit_vector;
        position_d = eye;
        colour_d = '0;
        pass_d = '0;
        index_d = '0;
        hit_d = 1'b0;
        best_d = Far;
        state_d = none ? block_pkg::BlockDecide : block_pkg::BlockGroup;
      end
      block_pkg::BlockGroup, block_pkg::BlockShadowGroup: begin
        step_d = !first_pass && !step_q;
        if (first_pass || step_q) begin
          pending_d = hits;
          if (hits != '0) state_d = meets_light ? block_pkg::BlockShadowNear : block_pkg::BlockNear;
          else if (!last_group) index_d = index_q + 1'b1;
          else if (meets_light) pass_ends = 1'b1;
          else state_d = block_pkg::BlockDecide;
        end
      end
      block_pkg::BlockNear, block_pkg::BlockShadowNear:
      if (root_done) begin
        pending_d = others;
        if (nearer) begin
          hit_d = 1'b1;
          best_d = t;
          nearest_d = index_q << LaneBits | near_lane;
        end
        dark = nearer && meets_light;
        if (dark || others == '0 && last_group && meets_light) begin
          pass_ends = 1'b1;
        end else if (others == '0) begin
          state_d = meets_light ? block_pkg::BlockShadowGroup
                    : last_group ? block_pkg::BlockDecide : block_pkg::BlockGroup;
          index_d = index_q + 1'b1;
        end
      end
      block_pkg::BlockDecide: state_d = hit_q ? block_pkg::BlockShade : block_pkg::BlockStore;
      block_pkg::BlockShade:
      if (shade_done) begin
        position_d = point;
        dir_d = direction;
        pass_d = pass_q + 1'b1;
        if (ShadowRays != 0) state_d = block_pkg::BlockShadow;
        else pass_ends = 1'b1;
      end
      block_pkg::BlockShadow: begin
        step_d = unit_done;
        if (step_q) begin
          index_d = '0;
          hit_d = 1'b0;
          best_d = b[0+:Bits];
          state_d = block_pkg::BlockShadowGroup;
        end
      end
      block_pkg::BlockStore:
      if (full) begin
        state_d = block_pkg::BlockWords;
      end else begin
        column_d = column_q + 1'b1;
        at_x_d = at_x_q + ax_i;
        state_d = block_pkg::BlockPixel;
      end
      block_pkg::BlockWords:
      if (accepted) begin
        plane_d = plane_q == 2'd2 ? 2'd0 : plane_q + 1'b1;
        if (plane_q == 2'd2) begin
          state_d = block_pkg::BlockPixel;
          column_d = column_q + 1'b1;
          at_x_d = at_x_q + ax_i;
          if (column_q == '1) begin
            row_d = row_q + 1'b1;
            at_x_d = left_q;
            at_y_d = at_y_q - ay_i;
            if (last_row) state_d = block_pkg::BlockIdle;
          end
        end
      end
      default: state_d = block_pkg::BlockIdle;
    endcase
    if (pass_ends) begin
      if (!dark) colour_d = block_pkg::sum_of(colour_q, light_of_hit);
      index_d = '0;
      hit_d = 1'b0;
      best_d = Far;
      state_d = pass_d == AllPasses ? block_pkg::BlockStore : block_pkg::BlockGroup;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= block_pkg::BlockIdle;
      event_q <= block_pkg::BlockNoEvent;
    end else begin
      state_q <= state_d;
      event_q <= event_d;
    end
    step_q <= step_d;
    {column_q, row_q, plane_q} <= {column_d, row_d, plane_d};
    corner_q <= corner_d;
    {at_x_q, at_y_q} <= {at_x_d, at_y_d};
    index_q <= index_d;
    pass_q <= pass_d;
    {position_q, dir_q, colour_q} <= {position_d, dir_d, colour_d};
    pending_q <= pending_d;
    {hit_q, nearest_q, best_q} <= {hit_d, nearest_d, best_d};
    if (job_ready_o) {job_x_q, job_y_q} <= {job_x_i, job_y_i};
    if (state_q == block_pkg::BlockJob) left_q <= at_x_d;
    if (in_corner && unit_done) corners_q[32'(corner_q)*3*Bits+:3*Bits] <= unit_vector;
    if (in_shadow && unit_done) lit_q <= unit_vector;
    if (in_group) begin
      b_q <= b;
      for (int n = 0; n < Lanes; n++) begin
        d_q[n*RootBits+:RootBits] <= d[n*LongBits+:RootBits];
        over_q[n] <= d[n*LongBits+RootBits+:LongBits-RootBits] != '0;
      end
    end
  end

  assign job_ready_o = state_q == block_pkg::BlockIdle;
  assign busy_o = !job_ready_o;
  assign state_o = state_q;
  assign event_o = event_q;

`ifndef SYNTHESIS
  wire logic before_store = state_q >= block_pkg::BlockGroup && state_q <= block_pkg::BlockShade;
  always_ff @(posedge clk_i)
    if (rst_ni) begin
      if (in_cull && LastQuarter == '0) culling_is_at_corner_0 : assert (corner_q == '0);
      if (before_store) a_pass_is_left : assert (pass_q < AllPasses);
      if (state_q > block_pkg::BlockShade) passes_are_few : assert (pass_q <= AllPasses);
    end
`endif
endmodule

`default_nettype wire
