// decision_datapath: where the tracer is in the decision tree, and the decision it takes there.
// Contract: sc/beam/decision_datapath.h
//
// One adder per axis serves descent, climb and navigator: -corner, half sizes and distance are
// chosen by masks, bit a for axis a. Registers start at 0 in a 2-state simulation.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module decision_datapath #(
    parameter int DrBits = 10,
    parameter int CornerBits = 12,
    parameter int CornerFactorBits = 8,
    parameter int PartialProductsCut = 5,
    parameter int CornerRounding = 0,
    parameter int MaxRoomDepth = 8,
    parameter int FaceStackDepth = 9,
    parameter int SkipSharedEdges = 0,
    parameter int FreeFlight = 0,
    parameter int PortalsPerFace = 1
) (
    /* verilator lint_off UNUSEDSIGNAL */  // ports are as wide as the widest parameters need
    // Clock; phase of the line
    input  wire logic clk_i,
    input  wire logic tracer_reset_i,
    input  wire logic nav_line_i,
    input  wire logic active_start_i,
    input  wire logic [9:0] y_i,  // bit 0: odd line
    // Pins of the chip, sequencer
    input  wire logic no_interlace_i,
    input  wire logic scene_interlace_i,
    input  wire logic signed [racebeam_pkg::VelocityPortBits-1:0] velocity_x_i,
    input  wire logic signed [racebeam_pkg::VelocityPortBits-1:0] velocity_y_i,
    input  wire logic signed [racebeam_pkg::VelocityPortBits-1:0] velocity_z_i,
    // navigator
    input  wire logic signed [racebeam_pkg::NavigatorPortBits-1:0] nav_position_x_i,
    input  wire logic signed [racebeam_pkg::NavigatorPortBits-1:0] nav_position_y_i,
    input  wire logic signed [racebeam_pkg::NavigatorPortBits-1:0] nav_position_z_i,
    input  wire logic [racebeam_pkg::RoomPortBits-1:0] nav_room_i,
    input  wire logic [1:0] nav_axis_i,
    input  wire logic [racebeam_pkg::PortalBits-1:0] nav_portal_i,
    input  wire logic nav_negative_i,
    input  wire logic [2:0] nav_op_i,
    input  wire logic nav_move_i,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] corner_x_o,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] corner_y_o,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] corner_z_o,
    // ray_stepper
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr1_x_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr1_y_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr1_z_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_x_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_y_i,
    input  wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_z_i,
    // subdivider: the decision
    input  wire logic [1:0] state_i,
    output logic [3:0] dec_o,
    output logic [3:0] mask_o,
    output logic [racebeam_pkg::TagPortBits-1:0] tag_o,  // {portal, depth, level}
    output logic wall_o,
    output logic second_o,
    // subdivider: the move
    input  wire logic descend_i,
    input  wire logic climb_i,
    input  wire logic [3:0] cur_i,
    input  wire logic [1:0] leave_i,
    input  wire logic [2:0] ray_signs_i,
    input  wire logic restart_i,
    // stacks
    input  wire logic [racebeam_pkg::TagPortBits-1:0] top_tag_i,
    input  wire logic [racebeam_pkg::FacePortBits-1:0] fread_i,
    output logic fwrite_o,
    output logic [racebeam_pkg::FacePortBits-1:0] fdata_o,
    // scene
    output logic [racebeam_pkg::RoomPortBits-1:0] room_o,
    output logic [1:0] look_axis_o,
    output logic [2:0] look_signs_o,
    output logic [racebeam_pkg::PortalBits-1:0] look_portal_o,
    output logic [1:0] look_way_o,
    input  wire logic [racebeam_pkg::CornerPortBits-1:0] half_size_x_i,
    input  wire logic [racebeam_pkg::CornerPortBits-1:0] half_size_y_i,
    input  wire logic [racebeam_pkg::CornerPortBits-1:0] half_size_z_i,
    input  wire logic signed [racebeam_pkg::CornerPortBits-1:0] position_x_i,
    input  wire logic signed [racebeam_pkg::CornerPortBits-1:0] position_y_i,
    input  wire logic signed [racebeam_pkg::CornerPortBits-1:0] position_z_i,
    input  wire logic [racebeam_pkg::RoomPortBits-1:0] neighbour_i,
    input  wire logic [racebeam_pkg::PortalBits-1:0] back_i,
    input  wire logic [3:0] edges_i,
    // pixel_output
    output logic [1:0] hit_face_o
    /* verilator lint_on UNUSEDSIGNAL */
);
  localparam bit SeveralPortals = PortalsPerFace > 1;
  localparam int RoomBits =
      FreeFlight != 0 || SeveralPortals ? racebeam_pkg::RoomPortBits : racebeam_pkg::RoomBits;
  localparam int DeepestRoom = MaxRoomDepth < FaceStackDepth ? MaxRoomDepth : FaceStackDepth - 1;
  localparam int FactorBits = CornerFactorBits;
  localparam int RayFactorBits = DrBits - 1;
  localparam int ProductBits = FactorBits + RayFactorBits - PartialProductsCut;
  localparam int LargestShift =
      CornerBits - 1 > CornerFactorBits ? CornerBits - 1 - CornerFactorBits : 0;

  logic [racebeam_pkg::DepthBits-1:0] depth_q;
  logic [racebeam_pkg::LevelBits-1:0] level_q;
  logic [RoomBits-1:0] room_q;
  logic [CornerBits-1:0] corner_q[3];
  logic [1:0] face_q, hit_face_q;
  logic dom_q, dom_prev_q, wall_q, second_q, descend_q;
  logic [racebeam_pkg::PortalBits-1:0] portal_q, back_q;  // 0: one portal a face
  logic [3:0] shared, shared_entered;  // levels that need no decision, of this and the new room

  function automatic logic [1:0] axis_after(input logic [1:0] axis);
    axis_after = axis == 2'd2 ? 2'd0 : axis == 2'd3 ? 2'd1 : axis + 2'd1;
  endfunction
  function automatic logic [1:0] axis_before(input logic [1:0] axis);
    axis_before = axis == 2'd0 ? 2'd2 : axis - 2'd1;
  endfunction

  // Per axis; 1: the level tests the near corner, 0: the far one.
  function automatic logic [2:0] near(input logic [1:0] level_pair, input logic [2:0] face_axis);
    near = level_pair[1] ? 3'b000 : level_pair[0] ? 3'b111 : face_axis;
  endfunction

  // The first level from `level` on that needs a decision.
  function automatic logic [racebeam_pkg::LevelBits-1:0] next_test(
      input logic [racebeam_pkg::LevelBits-1:0] level, input logic [3:0] no_test);
    next_test = 3'd6;
    for (int n = 3; n >= 0; n--)
      if (3'(n) >= level && !no_test[n]) next_test = 3'(n);
  endfunction

  // The face a ray leaves by: the second decision of levels 6 and 7.
  function automatic logic [1:0] left_face(input logic dom, input logic bit_7);
    left_face = dom ? (bit_7 ? 2'd2 : 2'd1) : (bit_7 ? 2'd0 : 2'd2);
  endfunction

  // Sum of the partial products that weigh 2^PartialProductsCut or more.
  function automatic logic [ProductBits-1:0] product(input logic [FactorBits-1:0] x,
                                                     input logic [RayFactorBits-1:0] m);
    product = '0;
    for (int i = 0; i < FactorBits; i++)
      if (x[i])
        product += ProductBits'(((FactorBits + RayFactorBits)'(m) << i) >> PartialProductsCut);
  endfunction

  // A corner coordinate without its lowest `by` bits; rounded, but for the largest one.
  function automatic logic [FactorBits-1:0] factor(logic [CornerBits-2:0] c, logic [3:0] by);
    factor = FactorBits'(c >> by);
    if (CornerRounding != 0 && by != 4'd0 && factor != '1)
      factor += FactorBits'(c[by-4'd1]);
  endfunction

  // The decision: which axis, its two corner coordinates, its two ray magnitudes.
  logic [DrBits-1:0] dr[3];
  logic [RayFactorBits-1:0] magnitude[3];
  logic [1:0] axis;
  logic inverted, at_least;
  logic [CornerBits-1:0] corner_a, corner_b;
  logic [CornerBits-2:0] either;
  logic [3:0] shift;
  logic [FactorBits-1:0] factor_a, factor_b;
  logic [RayFactorBits-1:0] ray_a, ray_b;

  wire logic left = state_i == racebeam_pkg::StateLeft;
  always_comb begin
    dr[0] = DrBits'(left ? dr1_x_i : dr2_x_i);
    dr[1] = DrBits'(left ? dr1_y_i : dr2_y_i);
    dr[2] = DrBits'(left ? dr1_z_i : dr2_z_i);
    for (int a = 0; a < 3; a++)
      magnitude[a] = dr[a][DrBits-2:0] ^ {RayFactorBits{dr[a][DrBits-1]}};

    if (level_q[2]) axis = !level_q[0] ? 2'd2 : dom_q ? 2'd0 : 2'd1;
    else axis = level_q[0] ? axis_before(face_q) : axis_after(face_q);
    inverted = (!level_q[2] && level_q[1] == level_q[0]) ^ (axis == 2'd1);

    corner_a = axis == 2'd0 ? corner_q[1] : corner_q[0];
    corner_b = axis == 2'd2 ? corner_q[1] : corner_q[2];
    ray_a = axis == 2'd0 ? magnitude[1] : magnitude[0];
    ray_b = axis == 2'd2 ? magnitude[1] : magnitude[2];

    either = corner_a[CornerBits-2:0] | corner_b[CornerBits-2:0];
    shift = '0;
    for (int n = 1; n <= LargestShift; n++) if (either[FactorBits+n-1]) shift = 4'(n);
    factor_a = factor(corner_a[CornerBits-2:0], shift);
    factor_b = factor(corner_b[CornerBits-2:0], shift);

    if (corner_b[CornerBits-1]) at_least = 1'b1;
    else if (corner_a[CornerBits-1]) at_least = 1'b0;
    else at_least = product(factor_a, ray_b) >= product(factor_b, ray_a);
  end

  assign dec_o = {dr[2][DrBits-1], dr[1][DrBits-1], dr[0][DrBits-1], at_least ^ inverted};
  assign mask_o = depth_q == '0 && !level_q[2] ? 4'b1110 : 4'b0001;

  // What scene is asked for.
  wire logic [racebeam_pkg::DepthBits-1:0] target_depth =
      top_tag_i[racebeam_pkg::LevelBits+:racebeam_pkg::DepthBits];
  wire logic [racebeam_pkg::PortalBits-1:0] target_portal =
      top_tag_i[racebeam_pkg::TagBits+:racebeam_pkg::PortalBits];
  wire logic solid = neighbour_i[RoomBits-1:0] == '1;

  wire logic leaves = leave_i != '0;
  wire logic aside = SeveralPortals && leaves && !level_q[2];  // to the next portal
  wire logic asks_edges = SkipSharedEdges == 2 && (!level_q[2] || second_q);
  wire logic to_previous = SeveralPortals && target_depth == depth_q && target_portal != portal_q;

  always_comb begin
    look_axis_o = left_face(dom_q, leave_i[0]);
    look_signs_o = ray_signs_i;
    look_portal_o = '0;
    look_way_o = racebeam_pkg::LookThrough;
    if (climb_i || aside || asks_edges) begin
      look_axis_o = face_q;
      look_signs_o = ~ray_signs_i;
      look_portal_o = back_q;
      if (climb_i && to_previous) look_way_o = racebeam_pkg::LookPrevious;
      else if (!climb_i && aside) look_way_o = racebeam_pkg::LookNext;
    end
    if (nav_line_i) begin
      look_axis_o = nav_axis_i;
      look_signs_o = {3{nav_negative_i}};
      look_portal_o = SeveralPortals ? nav_portal_i : '0;
      look_way_o = racebeam_pkg::LookThrough;
    end
  end
  assign fwrite_o = leaves && level_q == 3'd7 && !solid;
  assign fdata_o = {back_q, portal_q, face_q[1], face_q[0] | dom_prev_q};

  // The move.
  wire logic go_down = descend_i || (second_q && descend_q);
  wire logic interlace_on = !no_interlace_i && scene_interlace_i && y_i[0] && !nav_line_i;
  wire logic deepest = depth_q == racebeam_pkg::DepthBits'(DeepestRoom);
  wire logic root = tracer_reset_i || (nav_line_i ? active_start_i : restart_i);
  wire logic [1:0] new_face = left_face(dom_q, cur_i[0]);
  wire logic [1:0] popped_face = fread_i[1:0] == 2'd3 ? 2'd2 : fread_i[1:0];
  wire logic [racebeam_pkg::LevelBits-1:0] target = top_tag_i[racebeam_pkg::LevelBits-1:0];
  wire logic [2:0] even_level = {level_q[2:1], 1'b0};
  wire logic [2:0] rounded = target_depth == depth_q && target == even_level ? level_q : even_level;
  wire logic [2:0] face_axis = 3'b001 << face_q;

  wire logic at_camera = root || (nav_line_i && nav_op_i == racebeam_pkg::CornerCamera);
  wire logic add_velocity = nav_line_i && nav_op_i == racebeam_pkg::CornerAddVelocity;
  wire logic forget_wall = state_i == racebeam_pkg::StateReturn && !go_down;

  // All that follows counts at the edge only, and is written so that a simulator need not look at
  // it before.
  always_ff @(posedge clk_i) begin : move
    logic [racebeam_pkg::DepthBits-1:0] depth_d;
    logic [racebeam_pkg::LevelBits-1:0] level_d;
    logic [CornerBits-1:0] corner_d[3];
    logic [1:0] face_d, hit_face_d;
    logic dom_d, dom_prev_d, wall_d, second_d;
    logic [racebeam_pkg::PortalBits-1:0] portal_d, back_d;
    logic [2:0] negate, add_s, subtract_s, add_r, subtract_r, near_axes, near_next;
    logic leave_room, arrive, change_corner, corner_down, corner_up, twice, to_neighbour;
    logic [CornerBits-1:0] camera[3], velocity[3], half_size[3], position[3];
    logic [CornerBits-1:0] size_term[3], position_term[3], nudge[3];

    descend_q <= descend_i;
    second_q <= 1'b0;
    if (forget_wall) wall_q <= 1'b0;
    if (!SeveralPortals) {portal_q, back_q} <= '0;
    if (root || nav_line_i || go_down || climb_i) begin
      {negate, add_s, subtract_s, add_r, subtract_r} = '0;
      {leave_room, arrive, change_corner, corner_down, corner_up, to_neighbour} = '0;
      depth_d = depth_q;
      level_d = level_q;
      {face_d, dom_d, dom_prev_d} = {face_q, dom_q, dom_prev_q};
      {portal_d, back_d} = {portal_q, back_q};
      second_d = 1'b0;
      wall_d = wall_q && !forget_wall;
      hit_face_d = hit_face_q;

      if (go_down) begin
        if (level_q == 3'd7 && second_q) begin  // a room is entered: second half
          level_d = next_test(3'd0, shared_entered);
          depth_d = depth_q + 1'b1;
          arrive = 1'b1;
          if (deepest) wall_d = 1'b1;
        end else if (level_q == 3'd7) begin  // first half
          if (!solid) begin
            second_d = 1'b1;
            face_d = new_face;
            portal_d = '0;
            back_d = back_i;
            leave_room = 1'b1;
            to_neighbour = 1'b1;
          end
          if (solid || deepest) wall_d = 1'b1;
        end else if (level_q == 3'd6) begin
          {dom_prev_d, dom_d} = {dom_q, cur_i[0]};
          level_d = 3'd7;
        end else if (depth_q == '0 && level_q == 3'd2) begin
          level_d = 3'd6;
          {negate, add_s} = {cur_i[3:1], 3'b111};
          {corner_up, corner_down} = {!cur_i[3], cur_i[3]};
        end else if (depth_q == '0 || level_q[2]) begin
          level_d = level_q + 1'b1;
        end else if (SeveralPortals && second_q) begin  // behind the next portal
          arrive = 1'b1;
        end else if (SeveralPortals && cur_i[0] && !solid) begin  // past the edge of a portal
          level_d = 3'd0;
          second_d = 1'b1;
          portal_d = portal_q + 1'b1;
          back_d = back_i;
          leave_room = 1'b1;
          to_neighbour = 1'b1;
        end else begin
          level_d = next_test(level_q + 1'b1, shared);
          wall_d = cur_i[0];
          change_corner = 1'b1;
        end
        if (wall_d && !wall_q) hit_face_d = level_q == 3'd7 && !second_q ? new_face : face_q;
      end else if (climb_i) begin
        if (level_q == 3'd7 && (target_depth != depth_q || !second_q || to_previous))
          dom_d = dom_prev_q;
        if (target_depth != depth_q) begin  // leave a room
          depth_d = depth_q - 1'b1;
          level_d = 3'd7;
          second_d = 1'b1;
          to_neighbour = 1'b1;
          {face_d, dom_prev_d} = {popped_face, fread_i[0]};
          {back_d, portal_d} = fread_i[racebeam_pkg::FaceBits+:2*racebeam_pkg::PortalBits];
          leave_room = !second_q;
        end else if (to_previous) begin  // for the one behind the portal before
          level_d = 3'd0;
          second_d = 1'b1;
          portal_d = portal_q - 1'b1;
          back_d = back_i;
          to_neighbour = 1'b1;
          leave_room = !second_q;
        end else if (second_q) begin
          level_d = target;
          if (level_q == 3'd7 && target != 3'd7) dom_d = dom_prev_q;
          if (depth_q == '0 && !target[2]) {negate, add_r} = {ray_signs_i, 3'b111};
          else arrive = 1'b1;
        end else if (depth_q == '0 && rounded == 3'd6) begin  // to the root
          level_d = 3'd2;
          {negate, add_s, subtract_s} = {ray_signs_i, ray_signs_i, ~ray_signs_i};
          {corner_up, corner_down} = {ray_signs_i[2], !ray_signs_i[2]};
        end else begin  // within the room
          level_d = rounded - 1'b1;
          if (rounded == 3'd6) level_d = target[2:1] == 2'd1 ? 3'd3 : 3'd1;
          if (!target[0]) level_d[0] = 1'b0;
          change_corner = depth_q != '0 && (rounded == 3'd2 || rounded == 3'd6);
        end
      end

      // Corners: far ones are a half size beyond the centre, near ones before it.
      near_axes = near(level_q[2:1], face_axis);
      near_next = near(level_d[2:1], face_axis);
      twice = change_corner;
      if (leave_room) begin
        {add_r, subtract_r} = {ray_signs_i, ~ray_signs_i};
        {add_s, subtract_s} = {near_axes, ~near_axes};
      end
      if (arrive) begin
        {add_r, subtract_r} = {~ray_signs_i, ray_signs_i};
        {add_s, subtract_s} = {~near_next, near_next};
      end
      if (change_corner) {add_s, subtract_s} = {near_axes & ~near_next, near_next & ~near_axes};

      if (nav_line_i) begin  // the navigator's
        {negate, add_s, subtract_s, add_r, subtract_r} = '0;
        twice = nav_op_i == racebeam_pkg::CornerSubtract2S;
        to_neighbour = nav_move_i;
        case (nav_op_i)
          racebeam_pkg::CornerAddS: add_s = '1;
          racebeam_pkg::CornerSubtract2S: subtract_s = '1;
          racebeam_pkg::CornerLeavePlus: {subtract_s, subtract_r} = '1;
          racebeam_pkg::CornerLeaveMinus: {add_s, subtract_r} = '1;
          racebeam_pkg::CornerAddR: add_r = '1;
          default: ;
        endcase
      end

      if (root) begin
        depth_d = '0;
        level_d = 3'd2;
        {face_d, dom_d, dom_prev_d} = {face_q, dom_q, dom_prev_q};
        {wall_d, second_d, portal_d, back_d} = '0;
        hit_face_d = hit_face_q;
      end

      // The corner adders.
      camera[0] = CornerBits'(nav_position_x_i);
      camera[1] = CornerBits'(nav_position_y_i);
      camera[2] = CornerBits'(nav_position_z_i);
      velocity[0] = CornerBits'(velocity_x_i);
      velocity[1] = CornerBits'(velocity_y_i);
      velocity[2] = CornerBits'(velocity_z_i);
      half_size[0] = CornerBits'(half_size_x_i);
      half_size[1] = CornerBits'(half_size_y_i);
      half_size[2] = CornerBits'(half_size_z_i);
      position[0] = CornerBits'(position_x_i);
      position[1] = CornerBits'(position_y_i);
      position[2] = CornerBits'(position_z_i);

      nudge[0] = '0;
      nudge[1] = '0;
      nudge[2] = interlace_on ? CornerBits'(corner_up) - CornerBits'(corner_down) : '0;

      for (int a = 0; a < 3; a++) begin
        size_term[a] = twice ? half_size[a] << 1 : half_size[a];
        if (add_velocity) size_term[a] = velocity[a];
        else if (subtract_s[a]) size_term[a] = -size_term[a];
        else if (!add_s[a]) size_term[a] = '0;
        position_term[a] = add_r[a] ? position[a] : subtract_r[a] ? -position[a] : '0;
        corner_d[a] = (negate[a] ? -corner_q[a] : corner_q[a]) + size_term[a] + position_term[a]
            + nudge[a];
        corner_q[a] <= at_camera ? camera[a] : corner_d[a];
      end

      if (root || (at_camera && !to_neighbour)) room_q <= nav_room_i[RoomBits-1:0];
      else if (to_neighbour) room_q <= neighbour_i[RoomBits-1:0];

      depth_q <= depth_d;
      level_q <= level_d;
      face_q <= face_d;
      hit_face_q <= hit_face_d;
      dom_q <= dom_d;
      dom_prev_q <= dom_prev_d;
      wall_q <= wall_d;
      second_q <= second_d;
      if (SeveralPortals) {portal_q, back_q} <= {portal_d, back_d};
    end
  end

  // Edges of the room being entered that do not narrow the face it is entered by.
  if (SkipSharedEdges == 1) begin : g_shared_edges
    logic [CornerBits-1:0] left_far_q[3], left_near_q[3], far[3], near_side[3];
    logic [CornerBits-1:0] half_size[3], position[3];
    logic [3:0] shared_q[1 << racebeam_pkg::DepthBits];

    // A difference that is not negative.
    function automatic logic reaches(input logic [CornerBits-1:0] difference);
      reaches = !difference[CornerBits-1];
    endfunction

    always_comb begin
      position[0] = CornerBits'(position_x_i);
      position[1] = CornerBits'(position_y_i);
      position[2] = CornerBits'(position_z_i);
      half_size[0] = CornerBits'(half_size_x_i);
      half_size[1] = CornerBits'(half_size_y_i);
      half_size[2] = CornerBits'(half_size_z_i);
      for (int a = 0; a < 3; a++) begin  // in the mirrored world
        far[a] = (ray_signs_i[a] ? -position[a] : position[a]) + half_size[a];
        near_side[a] = far[a] - (half_size[a] << 1);
      end
      shared_entered = '0;
      for (int a = 0; a < 3; a++) begin
        if (axis_before(face_q) == 2'(a)) begin
          shared_entered[0] = reaches(far[a] - left_far_q[a]);
          shared_entered[2] = reaches(left_near_q[a] - near_side[a]);
        end
        if (axis_after(face_q) == 2'(a)) begin
          shared_entered[1] = reaches(far[a] - left_far_q[a]);
          shared_entered[3] = reaches(left_near_q[a] - near_side[a]);
        end
      end
      shared = shared_q[depth_q];
    end

    always_ff @(posedge clk_i)
      if (!root && go_down) begin
        if (level_q == 3'd7 && !second_q && !solid)
          for (int a = 0; a < 3; a++) begin
            left_far_q[a] <= far[a];
            left_near_q[a] <= near_side[a];
          end
        if (level_q == 3'd7 && second_q) shared_q[depth_q+1'b1] <= shared_entered;
        else if (SeveralPortals && second_q && !level_q[2] && depth_q != '0) shared_q[depth_q] <= '0;
      end
  end else if (SkipSharedEdges == 2) begin : g_table_edges
    // The scene's, in the mirrored world; bit 0 of a level chooses the axis.
    wire logic [1:0] mirrored = {ray_signs_i[axis_after(face_q)], ray_signs_i[axis_before(face_q)]};
    always_comb
      for (int n = 0; n < 4; n++) shared[n] = edges_i[2'(n) ^ {mirrored[n[0]], 1'b0}];
    assign shared_entered = shared;
  end else begin : g_all_edges
    assign {shared, shared_entered} = '0;
  end

  assign corner_x_o = racebeam_pkg::CornerPortBits'(signed'(corner_q[0]));
  assign corner_y_o = racebeam_pkg::CornerPortBits'(signed'(corner_q[1]));
  assign corner_z_o = racebeam_pkg::CornerPortBits'(signed'(corner_q[2]));
  assign tag_o = {portal_q, depth_q, level_q};
  assign wall_o = wall_q;
  assign second_o = second_q;
  assign hit_face_o = hit_face_q;
  // The room that is none has all bits set.
  assign room_o = room_q == '1 ? '1 : racebeam_pkg::RoomPortBits'(room_q);
endmodule

`default_nettype wire
