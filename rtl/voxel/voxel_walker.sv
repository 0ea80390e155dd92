// voxel_walker: takes a ray through the octree, from voxel to voxel.
// Contract: sc/voxel/voxel_walker.h
//
// The borders of DOWN are middles and those of EXIT far sides of voxels: both are found in half
// voxels, so that one shifter an axis makes units of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_walker #(
    parameter int SizeZ = 32,
    parameter int VoxelX = 1,
    parameter int VoxelY = 4,
    parameter int VoxelZ = 1,
    parameter int Levels = 5,
    parameter int Leaf = 0,  // 0: march, 1: voxel
    parameter int LeafSteps = 1,
    parameter int Raise = 0,  // 0: one, 1: all
    parameter int GroupFetch = 0,
    parameter int MemoryClocks = 1
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // voxel_scan
    input  wire logic start_i,
    input  wire logic shadow_i,
    // Host
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_y_i,
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_z_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] light_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] light_y_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] light_z_i,
    // voxel_camera
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_y_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_z_i,
    // voxel_setup
    output logic setup_o,
    input  wire logic [voxel_pkg::VoxelInverseBits-1:0] inverse_x_i,
    input  wire logic [voxel_pkg::VoxelInverseBits-1:0] inverse_y_i,
    input  wire logic [voxel_pkg::VoxelInverseBits-1:0] inverse_z_i,
    // voxel_setup, voxel_leaf
    output logic [voxel_pkg::VoxelDirectionBits-1:0] ray_x_o,  // signed
    output logic [voxel_pkg::VoxelDirectionBits-1:0] ray_y_o,
    output logic [voxel_pkg::VoxelDirectionBits-1:0] ray_z_o,
    output logic [voxel_pkg::VoxelPositionBits-1:0] from_x_o,  // signed
    output logic [voxel_pkg::VoxelPositionBits-1:0] from_y_o,
    output logic [voxel_pkg::VoxelPositionBits-1:0] from_z_o,
    // voxel_address
    output logic [voxel_pkg::VoxelCoordinateBits-1:0] x_o,  // signed
    output logic [voxel_pkg::VoxelCoordinateBits-1:0] y_o,
    output logic [voxel_pkg::VoxelCoordinateBits-1:0] z_o,
    output logic [voxel_pkg::VoxelLevelBits-1:0] level_o,
    input  wire logic inside_i,
    input  wire logic [voxel_pkg::VoxelBitBits-1:0] bit_i,
    // occupancy_memory
    output logic read_o,
    input  wire logic [voxel_pkg::VoxelMemoryBits-1:0] data_i,
    // voxel_leaf
    output logic leaf_o,
    output logic at_o,
    output logic column_o,
    output logic [voxel_pkg::VoxelTBits-1:0] t_o,
    output logic [voxel_pkg::VoxelTBits-1:0] t_out_o,
    output logic [voxel_pkg::VoxelTBits-1:0] step_o,
    input  wire logic some_i,
    input  wire logic sample_i,
    input  wire logic hit_i,
    input  wire logic done_i,
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] position_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] position_y_i,
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] position_z_i,
    // voxel_limits
    output logic outer_o,
    output logic inner_o,
    input  wire logic reached_i,
    // voxel_scan, voxel_shade
    output logic ray_done_o,
    output logic [voxel_pkg::VoxelKindBits-1:0] kind_o,
    output logic [voxel_pkg::VoxelPositionBits-1:0] hit_x_o,  // signed
    output logic [voxel_pkg::VoxelPositionBits-1:0] hit_y_o,
    output logic [voxel_pkg::VoxelPositionBits-1:0] hit_z_o,
    // For counters
    output logic [voxel_pkg::VoxelStateBits-1:0] state_o
);
  localparam int Bits = voxel_pkg::VoxelCoordinateBits;
  localparam int PositionBits = voxel_pkg::VoxelPositionBits;
  localparam int Fraction = voxel_pkg::VoxelPositionFraction;
  localparam int DirectionBits = voxel_pkg::VoxelDirectionBits;
  localparam int LiftCut = voxel_pkg::VoxelDirectionFraction - Fraction + 1;  // and halved
  localparam int TBits = voxel_pkg::VoxelTBits;
  localparam int LevelBits = voxel_pkg::VoxelLevelBits;
  localparam int ShiftBits = 4;  // of a side of a voxel, at most 16 * 2^8
  localparam int BorderBits = Bits + 1;
  localparam int FirstX = $clog2(VoxelX), FirstY = $clog2(VoxelY), FirstZ = $clog2(VoxelZ);
  localparam logic [LevelBits-1:0] Top = LevelBits'(Levels - 1);
  localparam logic signed [Bits-1:0] Highest = Bits'(((SizeZ / VoxelZ) >> (Levels - 1)) - 1);
  localparam logic [4:0] LastSetup = 5'd17;
  localparam logic [4:0] LastFetch = 5'(MemoryClocks);
  localparam logic [4:0] LastLimit = 5'(MemoryClocks + 1);

  typedef logic [PositionBits-1:0] position;
  typedef logic [DirectionBits-1:0] direction;
  typedef logic [TBits-1:0] ray_t;  // unsigned 24.8

  logic [voxel_pkg::VoxelStateBits-1:0] state_q, state_d;
  logic [4:0] step_q, step_d;  // clocks of the state that are over
  logic [LevelBits-1:0] level_q, level_d;
  logic [1:0] axis_q;  // that the voxel is left along
  ray_t t_q, t_d, t_out_q, leaf_step_q;
  logic signed [Bits-1:0] voxel_x_q, voxel_y_q, voxel_z_q, voxel_x_d, voxel_y_d, voxel_z_d;
  position origin_x_q, origin_y_q, origin_z_q, hit_x_q, hit_y_q, hit_z_q;
  direction direction_x_q, direction_y_q, direction_z_q;
  logic shadow_q;
  logic occupied_q;
  logic inner_q;  // which limit it was
  logic known_q;  // children_q has the voxel
  logic [7:0] children_q;

  wire logic setup = state_q == voxel_pkg::VoxelSetup;
  wire logic fetch = state_q == voxel_pkg::VoxelFetch;
  wire logic down = state_q == voxel_pkg::VoxelDown;
  wire logic leave = state_q == voxel_pkg::VoxelExit;
  wire logic leaf = state_q == voxel_pkg::VoxelLeaf;
  wire logic move = state_q == voxel_pkg::VoxelMove;
  wire logic limit = state_q == voxel_pkg::VoxelLimit;
  wire logic takes = setup && step_q == '0;
  wire logic enters = setup && step_q == LastSetup;

  wire logic plus_x = !direction_x_q[DirectionBits-1];
  wire logic plus_y = !direction_y_q[DirectionBits-1];
  wire logic plus_z = !direction_z_q[DirectionBits-1];

  // --- Borders ---------------------------------------------------------------------------------
  // That of a voxel in units; sides are shifts.
  function automatic logic [BorderBits-1:0] border_of(
      input logic signed [Bits-1:0] voxel, input logic plus, input logic middle,
      input logic [ShiftBits-1:0] shift);
    logic [BorderBits:0] halves;
    halves = {voxel[Bits-1], voxel, middle} + {{Bits{1'b0}}, plus && !middle, 1'b0};
    halves = halves << shift;
    border_of = halves[BorderBits:1];
  endfunction

  wire logic [BorderBits-1:0] border_x, border_y, border_z;
  assign border_x = border_of(voxel_x_q, plus_x, down, level_q + ShiftBits'(FirstX));
  assign border_y = border_of(voxel_y_q, plus_y, down, level_q + ShiftBits'(FirstY));
  assign border_z = setup ? BorderBits'(SizeZ)
      : border_of(voxel_z_q, plus_z, down, level_q + ShiftBits'(FirstZ));

  wire ray_t t_x, t_y, t_z;
  wire logic parallel_x, parallel_y, parallel_z, beyond_x, beyond_y, beyond_z;
  voxel_border #(
      .BorderBits(BorderBits)
  ) u_voxel_border_x (
      .border_i(border_x),
      .origin_i(origin_x_q),
      .direction_i(direction_x_q),
      .inverse_i(inverse_x_i),
      .t_o(t_x),
      .parallel_o(parallel_x),
      .beyond_o(beyond_x)
  );
  voxel_border #(
      .BorderBits(BorderBits)
  ) u_voxel_border_y (
      .border_i(border_y),
      .origin_i(origin_y_q),
      .direction_i(direction_y_q),
      .inverse_i(inverse_y_i),
      .t_o(t_y),
      .parallel_o(parallel_y),
      .beyond_o(beyond_y)
  );
  voxel_border #(
      .BorderBits(BorderBits)
  ) u_voxel_border_z (
      .border_i(border_z),
      .origin_i(origin_z_q),
      .direction_i(direction_z_q),
      .inverse_i(inverse_z_i),
      .t_o(t_z),
      .parallel_o(parallel_z),
      .beyond_o(beyond_z)
  );

  // --- SETUP: where a shadow's ray begins -------------------------------------------------------
  // 1.5 units towards the light.
  function automatic position lifted(input position hit, input direction light);
    /* verilator lint_off UNUSEDSIGNAL */  // it is rounded down
    logic [DirectionBits+1:0] thrice;
    /* verilator lint_on UNUSEDSIGNAL */
    thrice = {{2{light[DirectionBits-1]}}, light} + {light[DirectionBits-1], light, 1'b0};
    lifted = hit + PositionBits'(signed'(thrice[DirectionBits+1:LiftCut]));
  endfunction
  wire position shadow_x = lifted(hit_x_q, light_x_i);
  wire position shadow_y = lifted(hit_y_q, light_y_i);
  wire position shadow_z = lifted(hit_z_q, light_z_i);

  // --- SETUP: entry, and what lies between samples ---------------------------------------------
  wire logic from_above = beyond_z;
  wire ray_t t_in = from_above ? t_z : '0;

  // The voxels of the highest level there.
  wire logic signed [Bits-1:0] unit_x = position_x_i[PositionBits-1:Fraction];
  wire logic signed [Bits-1:0] unit_y = position_y_i[PositionBits-1:Fraction];
  wire logic signed [Bits-1:0] unit_z = position_z_i[PositionBits-1:Fraction];
  wire logic signed [Bits-1:0] in_x = unit_x >>> (FirstX + Levels - 1);
  wire logic signed [Bits-1:0] in_y = unit_y >>> (FirstY + Levels - 1);
  wire logic signed [Bits-1:0] in_z = unit_z >>> (FirstZ + Levels - 1);
  wire logic too_high = from_above && in_z > Highest;

  wire ray_t leaf_step;
  voxel_step #(
      .LeafSteps(LeafSteps)
  ) u_voxel_step (
      .inverse_x_i(inverse_x_i),
      .inverse_y_i(inverse_y_i),
      .inverse_z_i(inverse_z_i),
      .parallel_i({parallel_z, parallel_y, parallel_x}),
      .step_o(leaf_step)
  );

  // --- FETCH -----------------------------------------------------------------------------------
  wire logic group = GroupFetch != 0 && fetch && !known_q && level_q != '0;
  assign x_o = group ? voxel_x_q << 1 : voxel_x_q;
  assign y_o = group ? voxel_y_q << 1 : voxel_y_q;
  assign z_o = group ? voxel_z_q << 1 : voxel_z_q;
  assign level_o = group ? level_q - 1'b1 : level_q;
  assign read_o = fetch && step_q == '0 && !known_q;

  wire logic fetched = fetch && (known_q || step_q == LastFetch);
  wire logic [7:0] children = data_i[{bit_i[4:3], 3'b0}+:8];
  logic occupied;
  always_comb begin
    occupied = inside_i && (group ? children != '0 : children[bit_i[2:0]]);
    if (known_q) occupied = children_q[{voxel_z_q[0], voxel_y_q[0], voxel_x_q[0]}];
  end

  // --- DOWN: halves that are the far ones ------------------------------------------------------
  wire logic far_x = parallel_x ? beyond_x : (t_x <= t_q) == plus_x;
  wire logic far_y = parallel_y ? beyond_y : (t_y <= t_q) == plus_y;
  wire logic far_z = parallel_z ? beyond_z : (t_z <= t_q) == plus_z;

  // --- EXIT: x before y before z ---------------------------------------------------------------
  logic [1:0] axis;
  ray_t nearest;
  always_comb begin
    {axis, nearest} = {2'd0, t_x};
    if (t_y < nearest) {axis, nearest} = {2'd1, t_y};
    if (t_z < nearest) {axis, nearest} = {2'd2, t_z};
  end
  wire logic has_length = nearest > t_q;
  wire ray_t t_out = has_length ? nearest : t_q;

  // --- MOVE ------------------------------------------------------------------------------------
  wire logic [Bits-1:0] moved_x, moved_y, moved_z;
  wire logic [LevelBits-1:0] moved_level;
  wire logic above, outside;
  voxel_move #(
      .SizeZ(SizeZ),
      .VoxelX(VoxelX),
      .VoxelY(VoxelY),
      .VoxelZ(VoxelZ),
      .Levels(Levels),
      .Raise(Raise)
  ) u_voxel_move (
      .x_i(voxel_x_q),
      .y_i(voxel_y_q),
      .z_i(voxel_z_q),
      .level_i(level_q),
      .axis_i(axis_q),
      .plus_i(axis_q == 2'd0 ? plus_x : axis_q == 2'd1 ? plus_y : plus_z),
      .x_o(moved_x),
      .y_o(moved_y),
      .z_o(moved_z),
      .level_o(moved_level),
      .above_o(above),
      .outside_o(outside)
  );

  // --- How the ray ends ------------------------------------------------------------------------
  wire logic leaves_world = move && above && plus_z;
  assign outer_o = move && !leaves_world && !outside;
  assign inner_o = leaf && sample_i && !hit_i;
  wire logic stops = move && !leaves_world && outside || (outer_o || inner_o) && reached_i;
  wire logic is_sky = enters && from_above && plus_z || leaves_world || stops && plus_z;
  wire logic is_voxel = Leaf == 1 && leave && occupied_q;
  wire logic is_hit = leaf && hit_i || is_voxel && has_length;
  wire logic limited = limit && step_q == LastLimit;
  assign ray_done_o = is_sky || is_hit || limited;
  always_comb begin
    kind_o = voxel_pkg::VoxelSky;
    if (is_hit) kind_o = voxel_pkg::VoxelHit;
    if (limited) kind_o = inner_q ? voxel_pkg::VoxelInnerLimit : voxel_pkg::VoxelOuterLimit;
  end

  // A point in the voxel, whose side is a unit: t is rounded, so the point may be beside it.
  function automatic position kept_in(input position place, input logic signed [Bits-1:0] unit,
                                      input logic signed [Bits-1:0] voxel);
    kept_in = place;
    if (unit < voxel) kept_in = {voxel, {Fraction{1'b0}}};
    if (unit > voxel) kept_in = {voxel, {Fraction{1'b1}}};
  endfunction
  assign hit_x_o = is_voxel ? kept_in(position_x_i, unit_x, voxel_x_q) : position_x_i;
  assign hit_y_o = is_voxel ? kept_in(position_y_i, unit_y, voxel_y_q) : position_y_i;
  assign hit_z_o = position_z_i;

  // --- States ----------------------------------------------------------------------------------
  always_comb begin
    state_d = state_q;
    case (state_q)
      voxel_pkg::VoxelSetup: if (enters) state_d = voxel_pkg::VoxelFetch;
      voxel_pkg::VoxelFetch:
        if (fetched)
          state_d = occupied && level_q != '0 ? voxel_pkg::VoxelDown : voxel_pkg::VoxelExit;
      voxel_pkg::VoxelDown: state_d = voxel_pkg::VoxelFetch;
      voxel_pkg::VoxelExit:
        state_d = leaf_o && some_i ? voxel_pkg::VoxelLeaf : voxel_pkg::VoxelMove;
      voxel_pkg::VoxelLeaf: if (done_i) state_d = voxel_pkg::VoxelMove;
      voxel_pkg::VoxelMove: state_d = voxel_pkg::VoxelFetch;
      default: ;
    endcase
    if (stops) state_d = voxel_pkg::VoxelLimit;
    if (ray_done_o) state_d = voxel_pkg::VoxelIdle;
    if ((ray_done_o || state_q == voxel_pkg::VoxelIdle) && start_i) state_d = voxel_pkg::VoxelSetup;

    step_d = '0;
    if ((setup || fetch || limit) && state_d == state_q && !ray_done_o) step_d = step_q + 1'b1;
  end

  always_comb begin
    {level_d, t_d} = {level_q, t_q};
    {voxel_x_d, voxel_y_d, voxel_z_d} = {voxel_x_q, voxel_y_q, voxel_z_q};
    if (enters) begin
      {level_d, t_d} = {Top, t_in};
      {voxel_x_d, voxel_y_d, voxel_z_d} = {in_x, in_y, too_high ? Highest : in_z};
    end
    if (down) begin
      level_d = level_q - 1'b1;
      voxel_x_d = {voxel_x_q[Bits-2:0], far_x};
      voxel_y_d = {voxel_y_q[Bits-2:0], far_y};
      voxel_z_d = {voxel_z_q[Bits-2:0], far_z};
    end
    if (move) begin
      {level_d, t_d} = {moved_level, t_out_q};
      {voxel_x_d, voxel_y_d, voxel_z_d} = {moved_x, moved_y, moved_z};
    end
  end

  always_ff @(posedge clk_i) begin
    {state_q, step_q} <= rst_ni ? {state_d, step_d} : {voxel_pkg::VoxelIdle, 5'd0};
    {level_q, t_q} <= {level_d, t_d};
    {voxel_x_q, voxel_y_q, voxel_z_q} <= {voxel_x_d, voxel_y_d, voxel_z_d};
    if (start_i && (ray_done_o || state_q == voxel_pkg::VoxelIdle)) shadow_q <= shadow_i;
    if (takes) begin
      {origin_x_q, origin_y_q, origin_z_q} <=
          shadow_q ? {shadow_x, shadow_y, shadow_z} : {origin_x_i, origin_y_i, origin_z_i};
      {direction_x_q, direction_y_q, direction_z_q} <=
          shadow_q ? {light_x_i, light_y_i, light_z_i}
                   : {direction_x_i, direction_y_i, direction_z_i};
    end
    if (enters) leaf_step_q <= leaf_step;
    if (fetched) begin
      occupied_q <= occupied;
      known_q <= group;
      if (group) children_q <= children;
    end
    if (enters || leave) known_q <= 1'b0;
    if (leave) {axis_q, t_out_q} <= {axis, t_out};
    if (leaf || move) inner_q <= leaf;
    if (ray_done_o && !shadow_q) {hit_x_q, hit_y_q, hit_z_q} <= {hit_x_o, hit_y_o, hit_z_o};
  end

  // --- Outputs ---------------------------------------------------------------------------------
  assign setup_o = setup && step_q == 5'd1;
  assign {ray_x_o, ray_y_o, ray_z_o} = {direction_x_q, direction_y_q, direction_z_q};
  assign {from_x_o, from_y_o, from_z_o} = {origin_x_q, origin_y_q, origin_z_q};
  assign leaf_o = Leaf == 0 && leave && occupied_q;
  assign at_o = enters || leave || limit;
  assign column_o = limit && step_q == '0;
  assign t_o = enters ? t_in : t_q;
  assign t_out_o = leave ? t_out : t_out_q;
  assign step_o = leaf_step_q;
  assign state_o = state_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni && state_q != voxel_pkg::VoxelIdle && !setup) begin
      level_is_known : assert (level_q <= Top);
      it_is_not_the_lowest : assert (!down || level_q != '0);
    end
`endif
endmodule

`default_nettype wire
