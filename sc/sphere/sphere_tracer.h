// sphere_tracer: the state machine that draws a picture, sub-ray by sub-ray.
//
// What    All values are signed 12.12 in 24 bits and wrap; `dot` is sum_i, 48 bits, `floor` its
//         bits 35..12; `scale` is product_*_i. Per state, what is done at the end of its last
//         clock:
//   HOST     done_o. loaded_i: x, y, sub, nref := 0; RAY.
//   RAY      primary (nref = 0): dir := direction_i, org := origin_i; reflected: both as they are.
//            dot = dir.dir, of the new dir; radicand := floor, 0xffffff if any of bits 47..36 is
//            set; ROOT.
//   ROOT     waits for root_done_i; length := root_i; DIVIDE.
//   DIVIDE   dir / length; waits for divider_done_i; dir := quotient; object := 0, hit := 0;
//            CENTRE.
//   CENTRE   c := centre_i - org; c2 := dot = c.c, of the new c; ALONG.
//   ALONG    dot = dir.c; tca := floor, behind := dot < 0, inside := c2 < r2, where r2 = radius2_i
//            << 24 and both count as signed 48 bits. Inside and primary: NEXT; else FRONT.
//   FRONT    behind: next object. d := tca * tca - c2 + r2, 48 bits; CHORD.
//   CHORD    d < 0: next object. radicand := bits 35..12 of d; WAIT.
//   WAIT     HIT.
//   HIT      waits for root_done_i. t' = tca - root_i, inside: tca + root_i. If hit = 0 or t' < t,
//            as unsigned: t := t', hit := 1, hit_plane := 0, hit_index := object, is_light :=
//            is_light_i, point := org + scale (dir * t'), base := the sphere's colour, dark := 0,
//            reflect := the sphere's. Next object.
//            Next object: object is not sphere_last_i: object + 1, CENTRE. Else, if hit, as it is
//            after HIT: LIGHT. Else, planes_i and not plane_empty_i: object := 0, shadow := 0,
//            PLANE. Else NEXT.
//   PLANE    dot = normal_i.dir; vd := floor. dot >= 0: next plane; else PLANE_D.
//   PLANE_D  dot = normal_i.org; vo := -floor - distance_i; PLANE_T.
//   PLANE_T  numerator_x = vo << 12, the others 0, by vd; waits for divider_done_i. t' =
//            quotient_x, p = org + scale (dir * t'). Kept if t' > NearestPlane (signed), hit = 0 or
//            t' < t (unsigned), and not limited_i or |p_k| >> 12 < limit_k (magnitudes of 24 bits)
//            for all three k: t := t', point := p, hit := 1, hit_plane := 1, hit_index := object,
//            is_light := 0, base and reflect := the plane's, dark := (p_x[15:12] & checker_i) !=
//            (p_z[15:12] & checker_i). Next plane.
//            Next plane: object[2:0] is not plane_last_i: object + 1, PLANE. Else hit: LRAY, or
//            NEXT.
//   LIGHT    is_light: ShadeLight, ADD; else LRAY.
//   LRAY     lray := (light_i - point) >> 4, arithmetic, of a difference of 25 bits that does not
//            wrap; dot = lray.lray, of the new lray; radicand as in RAY; LROOT.
//   LROOT    as ROOT; LDIVIDE.
//   LDIVIDE  lray / length; waits for divider_done_i; lray := quotient; object := 0; NORMAL.
//   NORMAL   the table's index is hit_index. Sphere: normal := scale ((point - centre_i) *
//            inverse_i); plane: normal := normal_i. LAMBERT.
//   LAMBERT  dot = normal.lray; away := dot < 0; fraction := floor(dot / 4096), at most 0xfff (its
//            low 12 bits if away). Plane: ShadePlain, S_CENTRE; sphere: SHADE.
//   SHADE    away: ShadeHalf, ADD; else ShadeLit, S_CENTRE.
//   S_CENTRE object is sphere_last_i, or shadow_rays is off: plane_shadows is on and planes_i and
//            not plane_empty_i: object := 0, shadow := 1, PLANE; else ADD. Otherwise as CENTRE,
//            from point instead of org; S_ALONG.
//   S_ALONG  as ALONG with lray instead of dir; nobody is black; S_FRONT.
//   S_FRONT  behind: next sphere. Else object is hit_index of a sphere that was hit, or inside:
//            ShadeHalf, ADD. Else tca > distance (signed), where distance = length << 4: next
//            sphere. Else d as in FRONT; S_CHORD.
//   S_CHORD  d < 0: next sphere; else ShadeHalf, ADD.
//            Next sphere: object + 1, S_CENTRE.
//   PLANE*   PLANE, PLANE_D, PLANE_T with shadow = 1: lray and point instead of dir and org. Where
//            PLANE_T would keep a hit, with t' <= distance (signed) instead of "hit = 0 or t' < t":
//            ShadeHalf, ADD, and nothing is kept. After the last plane ADD.
//   ADD      ShadeAdd. nref = max_reflections_i, or weight_i < min_weight, or is_light: NEXT; else
//            REFLECT.
//   REFLECT  two clocks. First: dot = dir.normal; n2 := bits 34..11 of it. Second: dir := dir -
//            scale (normal * n2), org := point, nref + 1; RAY.
//   NEXT     nref := 0. sub is not the last (0, 4, 8 with alias_i = 0, 1, 2; 3 is as 2): sub + 1.
//            Else sub := 0, x + 1; after the last column x := 0, y + 1; after the last row y := 0,
//            picture_done_o, HOST; else RAY. Columns and rows are those of sphere_raygen.
//            ShadeStore.
//   2 3 6 31 RAY, and nothing else.
//         root_start_o, divider_start_o and radicand_o are registers: start is set at the end of
//         RAY, LRAY and CHORD (root), of ROOT, LROOT and PLANE_D (divider), and falls at the end of
//         the clock in which `done` ends the wait. So `done` of a start at the end of clock t is
//         seen in t + 7 (ROOT 7 clocks, WAIT 1 and HIT 6) and in t + 6 (DIVIDE, PLANE_T 6).
//         Outputs that a state does not name are 0, but for x_o, y_o, sub_o, base, dark_o,
//         fraction_o, reflect_o, radicand_o: registers, always. sphere_index_o = object in CENTRE,
//         ALONG, FRONT, HIT, S_CENTRE, S_ALONG, S_FRONT, else hit_index. plane_index_o =
//         object[2:0] in PLANE, PLANE_D, PLANE_T, else hit_index[2:0]. direct_o = (nref = 0),
//         always. word_address_o = {y[8:0], x[8:0]}, with the knob wide {y[8:0], x[9:0]}, always.
//         The vector unit, op: a, b or s:
//   RAY Dot: dir, dir. CENTRE, S_CENTRE Dot: c, c (S_CENTRE drives it even if no sphere is left).
//   ALONG, S_ALONG Dot: dir or lray, c. FRONT, S_FRONT Square: s = tca. HIT Scale: dir, s = t', in
//   all its clocks. PLANE Dot: normal_i, dir. PLANE_D Dot: normal_i, org. PLANE_T Scale: dir, s =
//   quotient_x_i, in all its clocks. LRAY Dot: lray, lray. NORMAL of a sphere Scale: point -
//   centre_i, s = inverse_i. LAMBERT Dot: normal, lray. REFLECT Dot: dir, normal, then Scale:
//   normal, s = n2. Others, NORMAL of a plane too: Dot of 0.
//         The divider: numerator_*_o = dir << 12 in DIVIDE, lray << 12 in LDIVIDE, vo << 12 in lane
//         x of PLANE_T; denominator_o = length, in PLANE_T vd.
// Size    with fraction_bits below 12, the low 12 - fraction_bits bits of dir, lray and point are 0
//         whenever they are written; what goes to the vector unit in RAY and LRAY is what is
//         written, the checkerboard and the limits of PLANE_T look at p before that.
// Cycles  one clock a state; ROOT and LROOT 7, DIVIDE, LDIVIDE, HIT, PLANE_T 6, REFLECT 2.
// Comb    direction_*_i, centre_*_i, normal_*_i, inverse_i, root_i, quotient_x_i, light_*_i ->
//         a_*_o, b_*_o, s_o. alias_i -> word_valid_o. alias_i, word_ready_i, and in PLANE_T with
//         shadow = 1 divider_done_i, quotient_x_i, product_*_i, limited_i, limit_*_i ->
//         shader_op_o. alias_i, narrow_i, word_ready_i -> picture_done_o. All other outputs:
//         registers only.
// Stall   word_valid_o in NEXT of the last sub-ray; with write_each_pass in every NEXT and in the
//         first clock of REFLECT. While it is 1 and word_ready_i is 0 the state stays, and so do
//         all registers; shader_op_o is ShadeHold, picture_done_o 0.
// Reset   rst_ni = 0: HOST, all other registers 0. shader_op_o is ShadeStart in HOST.
// Knobs   fraction_bits, write_each_pass, shadow_rays, plane_shadows, min_weight, wide: parameters
//         FractionBits, WriteEachPass, ShadowRays, PlaneShadows, MinWeight, Wide. A root or divider
//         of other clocks needs no knob here: the tracer waits for `done`.
// Twin    rtl/sphere/sphere_tracer.sv
// Test    tests/sphere/sphere_tracer_test.cpp
// Source  report "State Machine", and its figure 8.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/sphere/codes.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_tracer_core.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

/// Pins of sphere_tracer.
class sphere_tracer_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // sphere_inputs
  axes_in<SphereBits> origin_i{"origin", "_i"};  // signed, the eye
  axes_in<SphereBits> light_i{"light", "_i"};    // signed
  in_port<2> max_reflections_i{"max_reflections_i"};
  in_port<2> alias_i{"alias_i"};
  in_port<1> narrow_i{"narrow_i"};
  in_port<1> planes_i{"planes_i"};
  out_port<1> picture_done_o{"picture_done_o"};  // the last clock of a picture
  // sphere_host_link
  out_port<1> done_o{"done_o"};  // waits for the table
  in_port<1> loaded_i{"loaded_i"};
  // sphere_raygen
  out_port<PixelBits> x_o{"x_o"};
  out_port<PixelBits> y_o{"y_o"};
  out_port<4> sub_o{"sub_o"};
  axes_in<SphereBits> direction_i{"direction", "_i"};  // signed
  // sphere_table
  out_port<SphereIndexBits> sphere_index_o{"sphere_index_o"};
  axes_in<SphereBits> centre_i{"centre", "_i"};  // signed
  in_port<SphereBits> radius2_i{"radius2_i"};
  in_port<UnitBits> inverse_i{"inverse_i"};
  in_port<UnitBits> sphere_reflect_i{"sphere_reflect_i"};
  in_port<SphereColourBits> sphere_red_i{"sphere_red_i"};
  in_port<SphereColourBits> sphere_green_i{"sphere_green_i"};
  in_port<SphereColourBits> sphere_blue_i{"sphere_blue_i"};
  in_port<1> is_light_i{"is_light_i"};
  in_port<SphereIndexBits> sphere_last_i{"sphere_last_i"};
  // plane_table
  out_port<PlaneIndexBits> plane_index_o{"plane_index_o"};
  axes_in<SphereBits> normal_i{"normal", "_i"};  // signed
  in_port<SphereBits> distance_i{"distance_i"};  // signed
  in_port<SphereColourBits> plane_red_i{"plane_red_i"};
  in_port<SphereColourBits> plane_green_i{"plane_green_i"};
  in_port<SphereColourBits> plane_blue_i{"plane_blue_i"};
  in_port<UnitBits> plane_reflect_i{"plane_reflect_i"};
  in_port<4> checker_i{"checker_i"};
  in_port<1> limited_i{"limited_i"};
  axes_in<UnitBits> limit_i{"limit", "_i"};
  in_port<PlaneIndexBits> plane_last_i{"plane_last_i"};
  in_port<1> plane_empty_i{"plane_empty_i"};
  // vector_unit
  out_port<2> op_o{"op_o"};  // vector_op
  axes_out<SphereBits> a_o{"a", "_o"};
  axes_out<SphereBits> b_o{"b", "_o"};
  out_port<SphereBits> s_o{"s_o"};
  axes_in<SphereBits> product_i{"product", "_i"};
  in_port<SphereSumBits> sum_i{"sum_i"};
  in_port<SphereSumBits> square_i{"square_i"};
  // root_unit
  out_port<1> root_start_o{"root_start_o"};
  out_port<SphereBits> radicand_o{"radicand_o"};
  in_port<SphereBits> root_i{"root_i"};
  in_port<1> root_done_i{"root_done_i"};
  // divider_unit
  out_port<1> divider_start_o{"divider_start_o"};
  axes<out_port<NumeratorBits>> numerator_o{"numerator", "_o"};
  out_port<SphereBits> denominator_o{"denominator_o"};
  axes_in<SphereBits> quotient_i{"quotient", "_i"};
  in_port<1> divider_done_i{"divider_done_i"};
  // sphere_shader
  out_port<3> shader_op_o{"shader_op_o"};  // shader_op
  out_port<SphereColourBits> base_red_o{"base_red_o"};
  out_port<SphereColourBits> base_green_o{"base_green_o"};
  out_port<SphereColourBits> base_blue_o{"base_blue_o"};
  out_port<1> dark_o{"dark_o"};
  out_port<UnitBits> fraction_o{"fraction_o"};
  out_port<UnitBits> reflect_o{"reflect_o"};
  out_port<1> direct_o{"direct_o"};
  in_port<UnitBits> weight_i{"weight_i"};  // after ShadeAdd
  // write_buffer; the word is sphere_shader's
  out_port<1> word_valid_o{"word_valid_o"};
  out_port<StoreAddressBits> word_address_o{"word_address_o"};
  in_port<1> word_ready_i{"word_ready_i"};
  // Waves and counters
  out_port<SphereStateBits> state_o{"state_o"};  // sphere_state

  explicit sphere_tracer_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of sphere_tracer: its core behind the pins.
class sphere_tracer : public sphere_tracer_pins, public probed {
 public:
  using pins = sphere_tracer_pins;
  static constexpr const char* unit_name = "sphere_tracer";

  sphere_tracer(const sc_core::sc_module_name& name, const sphere_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void ask();
  void answer();

  const sphere_knobs knobs_;
  sphere_tracer_core core_;
  sphere_tracer_core::inputs in_{};
};

}  // namespace racebeam
