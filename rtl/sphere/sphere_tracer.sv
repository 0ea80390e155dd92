// sphere_tracer: the state machine that draws a picture, sub-ray by sub-ray.
// Contract: sc/sphere/sphere_tracer.h
//
// Vectors of three axes stand in one word, x on top. What a clock computes anew has a name without
// _q: ray and eye in RAY, towards in CENTRE, t and at in HIT and PLANE_T, to_light in LRAY.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sphere_tracer #(
    parameter int FractionBits = 12,  // of directions and positions
    parameter int WriteEachPass = 0,
    parameter int ShadowRays = 1,
    parameter int PlaneShadows = 0,
    parameter int MinWeight = 40,  // of 4096
    parameter int Wide = 0
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // sphere_inputs
    input  wire logic [sphere_pkg::SphereBits-1:0] origin_x_i,  // signed, the eye
    input  wire logic [sphere_pkg::SphereBits-1:0] origin_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] origin_z_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] light_x_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] light_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] light_z_i,
    input  wire logic [1:0] max_reflections_i,
    input  wire logic [1:0] alias_i,
    input  wire logic narrow_i,
    input  wire logic planes_i,
    output logic picture_done_o,  // the last clock of a picture
    // sphere_host_link
    output logic done_o,  // waits for the table
    input  wire logic loaded_i,
    // sphere_raygen
    output logic [racebeam_pkg::PixelBits-1:0] x_o,
    output logic [racebeam_pkg::PixelBits-1:0] y_o,
    output logic [3:0] sub_o,
    input  wire logic [sphere_pkg::SphereBits-1:0] direction_x_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] direction_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] direction_z_i,
    // sphere_table
    output logic [sphere_pkg::SphereIndexBits-1:0] sphere_index_o,
    input  wire logic [sphere_pkg::SphereBits-1:0] centre_x_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] centre_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] centre_z_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] radius2_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] inverse_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] sphere_reflect_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] sphere_red_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] sphere_green_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] sphere_blue_i,
    input  wire logic is_light_i,
    input  wire logic [sphere_pkg::SphereIndexBits-1:0] sphere_last_i,
    // plane_table
    output logic [sphere_pkg::PlaneIndexBits-1:0] plane_index_o,
    input  wire logic [sphere_pkg::SphereBits-1:0] normal_x_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] normal_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] normal_z_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] distance_i,  // signed
    input  wire logic [sphere_pkg::SphereColourBits-1:0] plane_red_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] plane_green_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] plane_blue_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] plane_reflect_i,
    input  wire logic [3:0] checker_i,
    input  wire logic limited_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] limit_x_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] limit_y_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] limit_z_i,
    input  wire logic [sphere_pkg::PlaneIndexBits-1:0] plane_last_i,
    input  wire logic plane_empty_i,
    // vector_unit
    output logic [1:0] op_o,  // vector_op
    output logic [sphere_pkg::SphereBits-1:0] a_x_o,
    output logic [sphere_pkg::SphereBits-1:0] a_y_o,
    output logic [sphere_pkg::SphereBits-1:0] a_z_o,
    output logic [sphere_pkg::SphereBits-1:0] b_x_o,
    output logic [sphere_pkg::SphereBits-1:0] b_y_o,
    output logic [sphere_pkg::SphereBits-1:0] b_z_o,
    output logic [sphere_pkg::SphereBits-1:0] s_o,
    input  wire logic [sphere_pkg::SphereBits-1:0] product_x_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] product_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] product_z_i,
    input  wire logic [sphere_pkg::SphereSumBits-1:0] sum_i,
    input  wire logic [sphere_pkg::SphereSumBits-1:0] square_i,
    // root_unit
    output logic root_start_o,
    output logic [sphere_pkg::SphereBits-1:0] radicand_o,
    input  wire logic [sphere_pkg::SphereBits-1:0] root_i,
    input  wire logic root_done_i,
    // divider_unit
    output logic divider_start_o,
    output logic [sphere_pkg::NumeratorBits-1:0] numerator_x_o,
    output logic [sphere_pkg::NumeratorBits-1:0] numerator_y_o,
    output logic [sphere_pkg::NumeratorBits-1:0] numerator_z_o,
    output logic [sphere_pkg::SphereBits-1:0] denominator_o,
    input  wire logic [sphere_pkg::SphereBits-1:0] quotient_x_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] quotient_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] quotient_z_i,
    input  wire logic divider_done_i,
    // sphere_shader
    output logic [2:0] shader_op_o,  // shader_op
    output logic [sphere_pkg::SphereColourBits-1:0] base_red_o,
    output logic [sphere_pkg::SphereColourBits-1:0] base_green_o,
    output logic [sphere_pkg::SphereColourBits-1:0] base_blue_o,
    output logic dark_o,
    output logic [sphere_pkg::UnitBits-1:0] fraction_o,
    output logic [sphere_pkg::UnitBits-1:0] reflect_o,
    output logic direct_o,
    input  wire logic [sphere_pkg::UnitBits-1:0] weight_i,  // after ShadeAdd
    // write_buffer; the word is sphere_shader's
    output logic word_valid_o,
    output logic [19:0] word_address_o,
    input  wire logic word_ready_i,
    // Waves and counters
    output logic [sphere_pkg::SphereStateBits-1:0] state_o  // sphere_state
);
  localparam int Bits = sphere_pkg::SphereBits;
  localparam int SumBits = sphere_pkg::SphereSumBits;
  localparam int Fraction = sphere_pkg::SphereFraction;
  localparam int Unit = sphere_pkg::UnitBits;

  typedef logic [Bits-1:0] number;
  typedef logic [3*Bits-1:0] axes;  // {x, y, z}
  typedef logic [SumBits-1:0] sum;
  typedef logic [racebeam_pkg::PixelBits-1:0] pixel;

  localparam number Kept = Bits'(-(1 << (Fraction - FractionBits)));
  localparam pixel WideLastColumn = Wide != 0 ? 10'd639 : 10'd511;

  sphere_pkg::sphere_state state_q, state_d;
  pixel x_q, x_d, y_q, y_d;
  logic [3:0] sub_q, sub_d;
  logic [1:0] nref_q, nref_d;  // reflections of this sub-ray so far
  // The ray, and the ray to the light; what a test of an object found
  number dir_x_q, dir_y_q, dir_z_q, org_x_q, org_y_q, org_z_q;
  number lray_x_q, lray_y_q, lray_z_q, length_q, length_d;
  number c_x_q, c_y_q, c_z_q, tca_q, tca_d, vd_q, vd_d, vo_q, vo_d;
  sum c2_q, c2_d;
  /* verilator lint_off UNUSEDSIGNAL */  // its sign, and what a root is taken of
  sum d_q, d_d;
  /* verilator lint_on UNUSEDSIGNAL */
  logic behind_q, behind_d, inside_q, inside_d, shadow_q, shadow_d;
  logic [3:0] object_q, object_d;
  // The nearest hit
  logic hit_q, hit_d, hit_plane_q, hit_plane_d, is_light_q, is_light_d, dark_q, dark_d;
  logic [3:0] hit_index_q, hit_index_d;
  number t_q, t_d, point_x_q, point_y_q, point_z_q;
  logic [14:0] base_q, base_d;  // {red, green, blue}
  logic [Unit-1:0] reflect_q, reflect_d, fraction_q, fraction_d;
  number normal_x_q, normal_y_q, normal_z_q, n2_q, n2_d;
  logic away_q, away_d;
  // Roots and divisions
  logic root_start_q, root_start_d, divider_start_q, divider_start_d;
  number radicand_q, radicand_d;

  wire axes dir = {dir_x_q, dir_y_q, dir_z_q};
  wire axes org = {org_x_q, org_y_q, org_z_q};
  wire axes lray = {lray_x_q, lray_y_q, lray_z_q};
  wire axes c = {c_x_q, c_y_q, c_z_q};
  wire axes point = {point_x_q, point_y_q, point_z_q};
  wire axes normal = {normal_x_q, normal_y_q, normal_z_q};
  axes dir_d, org_d, lray_d, c_d, point_d, normal_d;

  wire axes centre_in = {centre_x_i, centre_y_i, centre_z_i};
  wire axes normal_in = {normal_x_i, normal_y_i, normal_z_i};
  wire axes product = {product_x_i, product_y_i, product_z_i};
  wire axes quotient = {quotient_x_i, quotient_y_i, quotient_z_i};

  function automatic axes plus(input axes a, input axes b);
    plus = {a[2*Bits+:Bits] + b[2*Bits+:Bits], a[Bits+:Bits] + b[Bits+:Bits],
            a[0+:Bits] + b[0+:Bits]};
  endfunction

  function automatic axes minus(input axes a, input axes b);
    minus = {a[2*Bits+:Bits] - b[2*Bits+:Bits], a[Bits+:Bits] - b[Bits+:Bits],
             a[0+:Bits] - b[0+:Bits]};
  endfunction

  function automatic axes coarse(input axes a);
    coarse = a & {3{Kept}};
  endfunction

  // (to - from) / 16, without a carry lost.
  function automatic number sixteenth(input number to, input number from);
    logic [Bits:0] way;
    way = {to[Bits-1], to} - {from[Bits-1], from};
    sixteenth = {{3{way[Bits]}}, way[Bits:4]};
  endfunction

  /* verilator lint_off UNUSEDSIGNAL */  // what is below a fraction, or above a number
  function automatic number floor_of(input sum value);
    floor_of = value[Fraction+:Bits];
  endfunction

  // A squared length as a radicand: at most the longest.
  function automatic number length2(input sum value);
    length2 = value[SumBits-1:Fraction+Bits] != '0 ? '1 : value[Fraction+:Bits];
  endfunction

  function automatic logic in_limit(input number place, input logic [Unit-1:0] limit);
    number magnitude;
    magnitude = place[Bits-1] ? -place : place;
    in_limit = magnitude[Bits-1:Fraction] < limit;
  endfunction
  /* verilator lint_on UNUSEDSIGNAL */

  // --- Operands: what this clock multiplies ----------------------------------------------------
  wire logic primary = nref_q == '0;
  wire axes ray = coarse(primary ? {direction_x_i, direction_y_i, direction_z_i} : dir);
  wire axes eye = primary ? {origin_x_i, origin_y_i, origin_z_i} : org;
  wire logic to_shadow = state_q == sphere_pkg::SphereShadowCentre;
  wire axes towards = minus(centre_in, to_shadow ? point : org);
  wire axes to_light = coarse({sixteenth(light_x_i, point_x_q), sixteenth(light_y_i, point_y_q),
                               sixteenth(light_z_i, point_z_q)});
  wire number t = state_q == sphere_pkg::SpherePlaneT ? quotient_x_i
                  : inside_q ? tca_q + root_i : tca_q - root_i;
  // Planes are tested by both kinds of rays.
  wire axes plane_ray = shadow_q ? lray : dir;
  wire axes plane_from = shadow_q ? point : org;

  axes a, b;

  always_comb begin
    op_o = sphere_pkg::VectorDot;
    a = '0;
    b = '0;
    s_o = '0;
    unique case (state_q)
      sphere_pkg::SphereRay: {a, b} = {ray, ray};
      sphere_pkg::SphereCentre, sphere_pkg::SphereShadowCentre: {a, b} = {towards, towards};
      sphere_pkg::SphereAlong: {a, b} = {dir, c};
      sphere_pkg::SphereShadowAlong: {a, b} = {lray, c};
      sphere_pkg::SphereFront, sphere_pkg::SphereShadowFront: begin
        op_o = sphere_pkg::VectorSquare;
        s_o = tca_q;
      end
      sphere_pkg::SphereHit: begin
        op_o = sphere_pkg::VectorScale;
        a = dir;
        s_o = t;
      end
      sphere_pkg::SpherePlane: {a, b} = {normal_in, plane_ray};
      sphere_pkg::SpherePlaneD: {a, b} = {normal_in, plane_from};
      sphere_pkg::SpherePlaneT: begin
        op_o = sphere_pkg::VectorScale;
        a = plane_ray;
        s_o = t;
      end
      sphere_pkg::SphereLray: {a, b} = {to_light, to_light};
      sphere_pkg::SphereNormal:
      if (!hit_plane_q) begin
        op_o = sphere_pkg::VectorScale;
        a = minus(point, centre_in);
        s_o = Bits'(inverse_i);
      end
      sphere_pkg::SphereLambert: {a, b} = {normal, lray};
      sphere_pkg::SphereReflect: {a, b} = {dir, normal};
      sphere_pkg::SphereReflectTwo: begin
        op_o = sphere_pkg::VectorScale;
        a = normal;
        s_o = n2_q;
      end
      default: ;
    endcase
  end
  assign {a_x_o, a_y_o, a_z_o} = a;
  assign {b_x_o, b_y_o, b_z_o} = b;

  always_comb begin
    {numerator_x_o, numerator_y_o, numerator_z_o} = '0;
    denominator_o = '0;
    unique case (state_q)
      sphere_pkg::SphereDivide: begin
        numerator_x_o = {dir_x_q, 12'd0};
        numerator_y_o = {dir_y_q, 12'd0};
        numerator_z_o = {dir_z_q, 12'd0};
        denominator_o = length_q;
      end
      sphere_pkg::SphereLdivide: begin
        numerator_x_o = {lray_x_q, 12'd0};
        numerator_y_o = {lray_y_q, 12'd0};
        numerator_z_o = {lray_z_q, 12'd0};
        denominator_o = length_q;
      end
      sphere_pkg::SpherePlaneT: begin
        numerator_x_o = {vo_q, 12'd0};
        denominator_o = vd_q;
      end
      default: ;
    endcase
  end

  // --- Tests -----------------------------------------------------------------------------------
  wire sum radius2 = {radius2_i, 24'd0};
  wire logic in_sphere = $signed(c2_q) < $signed(radius2);
  wire sum d = square_i - c2_q + radius2;
  wire number distance = {length_q[Bits-5:0], 4'd0};
  wire logic nearer = !hit_q || t < t_q;

  wire axes at = plus(state_q == sphere_pkg::SpherePlaneT ? plane_from : org, product);
  wire logic in_limits = !limited_i
      || (in_limit(at[2*Bits+:Bits], limit_x_i) && in_limit(at[Bits+:Bits], limit_y_i)
          && in_limit(at[0+:Bits], limit_z_i));
  wire logic kept = $signed(t) > $signed(Bits'(sphere_pkg::NearestPlane)) && in_limits
      && (shadow_q ? $signed(t) <= $signed(distance) : nearer);
  wire logic [3:0] square_x = at[2*Bits+Fraction+:4] & checker_i;
  wire logic [3:0] square_z = at[Fraction+:4] & checker_i;

  wire logic dark_place = inside_q || (!hit_plane_q && object_q == hit_index_q);
  wire logic beyond = $signed(tca_q) > $signed(distance);
  wire logic no_planes = !planes_i || plane_empty_i;
  wire logic last_sphere = object_q == sphere_last_i;
  wire logic last_plane = object_q[2:0] == plane_last_i;
  wire logic stop = nref_q == max_reflections_i || 32'(weight_i) < MinWeight || is_light_q;

  wire logic last_sub = sub_q == (alias_i[1] ? 4'd8 : alias_i[0] ? 4'd4 : 4'd0);
  wire logic last_column = x_q == (narrow_i ? 10'd319 : WideLastColumn);
  wire logic last_row = y_q == (narrow_i ? 10'd239 : 10'd479);

  assign word_valid_o = (state_q == sphere_pkg::SphereNext && (last_sub || WriteEachPass != 0))
      || (state_q == sphere_pkg::SphereReflect && WriteEachPass != 0);
  wire logic stall = word_valid_o && !word_ready_i;
  wire logic picture_done = state_q == sphere_pkg::SphereNext && !stall && last_sub && last_column
      && last_row;

  // --- What the shader does --------------------------------------------------------------------
  always_comb begin
    shader_op_o = sphere_pkg::ShadeHold;
    unique case (state_q)
      sphere_pkg::SphereHost: shader_op_o = sphere_pkg::ShadeStart;
      sphere_pkg::SphereLight: if (is_light_q) shader_op_o = sphere_pkg::ShadeLight;
      sphere_pkg::SphereLambert: if (hit_plane_q) shader_op_o = sphere_pkg::ShadePlain;
      sphere_pkg::SphereShade:
      shader_op_o = away_q ? sphere_pkg::ShadeHalf : sphere_pkg::ShadeLit;
      sphere_pkg::SphereShadowFront:
      if (!behind_q && dark_place) shader_op_o = sphere_pkg::ShadeHalf;
      sphere_pkg::SphereShadowChord:
      if (!d_q[SumBits-1]) shader_op_o = sphere_pkg::ShadeHalf;
      sphere_pkg::SpherePlaneT:
      if (shadow_q && divider_done_i && kept) shader_op_o = sphere_pkg::ShadeHalf;
      sphere_pkg::SphereAdd: shader_op_o = sphere_pkg::ShadeAdd;
      sphere_pkg::SphereNext: if (!stall) shader_op_o = sphere_pkg::ShadeStore;
      default: ;
    endcase
  end

  // --- The states ------------------------------------------------------------------------------
  logic next_object, next_plane, next_sphere;  // the test of this one is over

  always_comb begin
    state_d = state_q;
    {x_d, y_d, sub_d, nref_d} = {x_q, y_q, sub_q, nref_q};
    {dir_d, org_d, lray_d, c_d, point_d, normal_d} = {dir, org, lray, c, point, normal};
    {length_d, tca_d, vd_d, vo_d, n2_d} = {length_q, tca_q, vd_q, vo_q, n2_q};
    {c2_d, d_d} = {c2_q, d_q};
    {behind_d, inside_d, shadow_d, away_d} = {behind_q, inside_q, shadow_q, away_q};
    object_d = object_q;
    {hit_d, hit_plane_d, hit_index_d} = {hit_q, hit_plane_q, hit_index_q};
    {is_light_d, dark_d, t_d} = {is_light_q, dark_q, t_q};
    {base_d, reflect_d, fraction_d} = {base_q, reflect_q, fraction_q};
    {root_start_d, divider_start_d, radicand_d} = {root_start_q, divider_start_q, radicand_q};
    {next_object, next_plane, next_sphere} = '0;

    unique case (state_q)
      sphere_pkg::SphereHost:
      if (loaded_i) begin
        {x_d, y_d, sub_d, nref_d} = '0;
        state_d = sphere_pkg::SphereRay;
      end

      sphere_pkg::SphereRay: begin
        dir_d = ray;
        org_d = eye;
        radicand_d = length2(sum_i);
        root_start_d = 1'b1;
        state_d = sphere_pkg::SphereRoot;
      end
      sphere_pkg::SphereLray: begin
        lray_d = to_light;
        radicand_d = length2(sum_i);
        root_start_d = 1'b1;
        state_d = sphere_pkg::SphereLroot;
      end
      sphere_pkg::SphereRoot, sphere_pkg::SphereLroot:
      if (root_done_i) begin
        length_d = root_i;
        root_start_d = 1'b0;
        divider_start_d = 1'b1;
        state_d = state_q == sphere_pkg::SphereRoot ? sphere_pkg::SphereDivide
                                                    : sphere_pkg::SphereLdivide;
      end
      sphere_pkg::SphereDivide:
      if (divider_done_i) begin
        dir_d = coarse(quotient);
        divider_start_d = 1'b0;
        object_d = '0;
        hit_d = 1'b0;
        state_d = sphere_pkg::SphereCentre;
      end
      sphere_pkg::SphereLdivide:
      if (divider_done_i) begin
        lray_d = coarse(quotient);
        divider_start_d = 1'b0;
        object_d = '0;
        state_d = sphere_pkg::SphereNormal;
      end

      // A sphere
      sphere_pkg::SphereCentre: begin
        c_d = towards;
        c2_d = sum_i;
        state_d = sphere_pkg::SphereAlong;
      end
      sphere_pkg::SphereAlong: begin
        tca_d = floor_of(sum_i);
        behind_d = sum_i[SumBits-1];
        inside_d = in_sphere;
        state_d = in_sphere && primary ? sphere_pkg::SphereNext : sphere_pkg::SphereFront;
      end
      sphere_pkg::SphereFront: begin
        d_d = d;
        next_object = behind_q;
        state_d = sphere_pkg::SphereChord;
      end
      sphere_pkg::SphereChord: begin
        next_object = d_q[SumBits-1];
        if (!next_object) begin
          radicand_d = floor_of(d_q);
          root_start_d = 1'b1;
        end
        state_d = sphere_pkg::SphereWait;
      end
      sphere_pkg::SphereWait: state_d = sphere_pkg::SphereHit;
      sphere_pkg::SphereHit:
      if (root_done_i) begin
        root_start_d = 1'b0;
        next_object = 1'b1;
        if (nearer) begin
          {hit_d, hit_plane_d, hit_index_d} = {2'b10, object_q};
          {is_light_d, dark_d, t_d} = {is_light_i, 1'b0, t};
          point_d = coarse(at);
          base_d = {sphere_red_i, sphere_green_i, sphere_blue_i};
          reflect_d = sphere_reflect_i;
        end
      end

      // A plane
      sphere_pkg::SpherePlane: begin
        vd_d = floor_of(sum_i);
        next_plane = !sum_i[SumBits-1];
        state_d = sphere_pkg::SpherePlaneD;
      end
      sphere_pkg::SpherePlaneD: begin
        vo_d = -floor_of(sum_i) - distance_i;
        divider_start_d = 1'b1;
        state_d = sphere_pkg::SpherePlaneT;
      end
      sphere_pkg::SpherePlaneT:
      if (divider_done_i) begin
        divider_start_d = 1'b0;
        next_plane = 1'b1;
        if (kept && !shadow_q) begin
          {hit_d, hit_plane_d, hit_index_d} = {2'b11, object_q};
          {is_light_d, dark_d, t_d} = {1'b0, square_x != square_z, t};
          point_d = coarse(at);
          base_d = {plane_red_i, plane_green_i, plane_blue_i};
          reflect_d = plane_reflect_i;
        end
      end

      // The hit
      sphere_pkg::SphereLight:
      state_d = is_light_q ? sphere_pkg::SphereAdd : sphere_pkg::SphereLray;
      sphere_pkg::SphereNormal: begin
        normal_d = hit_plane_q ? normal_in : product;
        state_d = sphere_pkg::SphereLambert;
      end
      sphere_pkg::SphereLambert: begin
        away_d = sum_i[SumBits-1];
        fraction_d = !away_d && sum_i[SumBits-1:Fraction+Unit] != '0 ? '1
                                                                      : sum_i[Fraction+:Unit];
        state_d = hit_plane_q ? sphere_pkg::SphereShadowCentre : sphere_pkg::SphereShade;
      end
      sphere_pkg::SphereShade:
      state_d = away_q ? sphere_pkg::SphereAdd : sphere_pkg::SphereShadowCentre;

      // Is a sphere between it and the light?
      sphere_pkg::SphereShadowCentre: begin
        c_d = towards;
        c2_d = sum_i;
        state_d = sphere_pkg::SphereShadowAlong;
        if (ShadowRays == 0 || last_sphere) begin
          state_d = sphere_pkg::SphereAdd;
          if (PlaneShadows != 0 && !no_planes) begin
            object_d = '0;
            shadow_d = 1'b1;
            state_d = sphere_pkg::SpherePlane;
          end
        end
      end
      sphere_pkg::SphereShadowAlong: begin
        tca_d = floor_of(sum_i);
        behind_d = sum_i[SumBits-1];
        inside_d = in_sphere;
        state_d = sphere_pkg::SphereShadowFront;
      end
      sphere_pkg::SphereShadowFront: begin
        d_d = d;
        next_sphere = behind_q || (beyond && !dark_place);
        state_d = dark_place ? sphere_pkg::SphereAdd : sphere_pkg::SphereShadowChord;
      end
      sphere_pkg::SphereShadowChord: begin
        next_sphere = d_q[SumBits-1];
        state_d = sphere_pkg::SphereAdd;
      end

      // The end of a ray, of a sub-ray, of a pixel, of a picture
      sphere_pkg::SphereAdd:
      state_d = stop ? sphere_pkg::SphereNext : sphere_pkg::SphereReflect;
      sphere_pkg::SphereReflect:
      if (!stall) begin
        n2_d = sum_i[Fraction-1+:Bits];
        state_d = sphere_pkg::SphereReflectTwo;
      end
      sphere_pkg::SphereReflectTwo: begin
        dir_d = coarse(minus(dir, product));
        org_d = point;
        nref_d = nref_q + 1'b1;
        state_d = sphere_pkg::SphereRay;
      end
      sphere_pkg::SphereNext:
      if (!stall) begin
        nref_d = '0;
        sub_d = last_sub ? '0 : sub_q + 1'b1;
        if (last_sub) x_d = last_column ? '0 : x_q + 1'b1;
        if (last_sub && last_column) y_d = last_row ? '0 : y_q + 1'b1;
        state_d = picture_done ? sphere_pkg::SphereHost : sphere_pkg::SphereRay;
      end
      default: state_d = sphere_pkg::SphereRay;
    endcase

    if (next_object) begin
      if (!last_sphere) begin
        object_d = object_q + 1'b1;
        state_d = sphere_pkg::SphereCentre;
      end else if (hit_d) begin
        state_d = sphere_pkg::SphereLight;
      end else if (no_planes) begin
        state_d = sphere_pkg::SphereNext;
      end else begin
        object_d = '0;
        shadow_d = 1'b0;
        state_d = sphere_pkg::SpherePlane;
      end
    end
    if (next_plane) begin
      if (shadow_q && kept && state_q == sphere_pkg::SpherePlaneT) begin
        state_d = sphere_pkg::SphereAdd;
      end else if (!last_plane) begin
        object_d = object_q + 1'b1;
        state_d = sphere_pkg::SpherePlane;
      end else if (shadow_q) begin
        state_d = sphere_pkg::SphereAdd;
      end else begin
        state_d = hit_d ? sphere_pkg::SphereLray : sphere_pkg::SphereNext;
      end
    end
    if (next_sphere) begin
      object_d = object_q + 1'b1;
      state_d = sphere_pkg::SphereShadowCentre;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= sphere_pkg::SphereHost;
      {x_q, y_q, sub_q, nref_q} <= '0;
      {dir_x_q, dir_y_q, dir_z_q, org_x_q, org_y_q, org_z_q} <= '0;
      {lray_x_q, lray_y_q, lray_z_q, c_x_q, c_y_q, c_z_q} <= '0;
      {point_x_q, point_y_q, point_z_q, normal_x_q, normal_y_q, normal_z_q} <= '0;
      {length_q, tca_q, vd_q, vo_q, n2_q, c2_q, d_q} <= '0;
      {behind_q, inside_q, shadow_q, away_q, object_q} <= '0;
      {hit_q, hit_plane_q, hit_index_q, is_light_q, dark_q, t_q} <= '0;
      {base_q, reflect_q, fraction_q} <= '0;
      {root_start_q, divider_start_q, radicand_q} <= '0;
    end else begin
      state_q <= state_d;
      {x_q, y_q, sub_q, nref_q} <= {x_d, y_d, sub_d, nref_d};
      {dir_x_q, dir_y_q, dir_z_q, org_x_q, org_y_q, org_z_q} <= {dir_d, org_d};
      {lray_x_q, lray_y_q, lray_z_q, c_x_q, c_y_q, c_z_q} <= {lray_d, c_d};
      {point_x_q, point_y_q, point_z_q, normal_x_q, normal_y_q, normal_z_q} <=
          {point_d, normal_d};
      {length_q, tca_q, vd_q, vo_q, n2_q, c2_q, d_q} <=
          {length_d, tca_d, vd_d, vo_d, n2_d, c2_d, d_d};
      {behind_q, inside_q, shadow_q, away_q, object_q} <=
          {behind_d, inside_d, shadow_d, away_d, object_d};
      {hit_q, hit_plane_q, hit_index_q, is_light_q, dark_q, t_q} <=
          {hit_d, hit_plane_d, hit_index_d, is_light_d, dark_d, t_d};
      {base_q, reflect_q, fraction_q} <= {base_d, reflect_d, fraction_d};
      {root_start_q, divider_start_q, radicand_q} <=
          {root_start_d, divider_start_d, radicand_d};
    end
  end

  // --- Outputs that are registers --------------------------------------------------------------
  wire logic by_object = state_q == sphere_pkg::SphereCentre || state_q == sphere_pkg::SphereAlong
      || state_q == sphere_pkg::SphereFront || state_q == sphere_pkg::SphereHit
      || state_q == sphere_pkg::SphereShadowCentre || state_q == sphere_pkg::SphereShadowAlong
      || state_q == sphere_pkg::SphereShadowFront;
  wire logic by_plane = state_q == sphere_pkg::SpherePlane || state_q == sphere_pkg::SpherePlaneD
      || state_q == sphere_pkg::SpherePlaneT;

  assign state_o = state_q;
  assign done_o = state_q == sphere_pkg::SphereHost;
  assign picture_done_o = picture_done;
  assign x_o = x_q;
  assign y_o = y_q;
  assign sub_o = sub_q;
  assign sphere_index_o = by_object ? object_q : hit_index_q;
  assign plane_index_o = by_plane ? object_q[2:0] : hit_index_q[2:0];
  assign root_start_o = root_start_q;
  assign divider_start_o = divider_start_q;
  assign radicand_o = radicand_q;
  assign {base_red_o, base_green_o, base_blue_o} = base_q;
  assign dark_o = dark_q;
  assign fraction_o = fraction_q;
  assign reflect_o = reflect_q;
  assign direct_o = primary;
  assign word_address_o = Wide != 0 ? {1'b0, y_q[8:0], x_q} : {2'b0, y_q[8:0], x_q[8:0]};
endmodule

`default_nettype wire
