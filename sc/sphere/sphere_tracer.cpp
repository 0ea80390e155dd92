// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_tracer.h"

namespace racebeam {

sphere_tracer::sphere_tracer(const sc_core::sc_module_name& name, const sphere_knobs& k)
    : sphere_tracer_pins(name), knobs_(k) {
  SC_HAS_PROCESS(sphere_tracer);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(ask);
  sensitive << direction_i.x << direction_i.y << direction_i.z << centre_i.x << centre_i.y
            << centre_i.z << normal_i.x << normal_i.y << normal_i.z << inverse_i << root_i
            << quotient_i.x << light_i.x << light_i.y << light_i.z;
  SC_METHOD(answer);
  sensitive << alias_i << narrow_i << word_ready_i;
  if (k.plane_shadows)
    sensitive << divider_done_i << quotient_i.x << product_i.x << product_i.y << product_i.z
              << limited_i << limit_i.x << limit_i.y << limit_i.z;
}

void sphere_tracer::seq() {
  in_.rst_n = rst_ni.value() != 0;
  in_.root_done = root_done_i.value() != 0;
  in_.divider_done = divider_done_i.value() != 0;
  in_.loaded = loaded_i.value() != 0;
  if (core_.waits(in_)) return;
  in_.origin = origin_i.signed_value();
  in_.light = light_i.signed_value();
  in_.max_reflections = max_reflections_i.value();
  in_.alias = alias_i.value();
  in_.narrow = narrow_i.value() != 0;
  in_.planes = planes_i.value() != 0;
  in_.direction = direction_i.signed_value();
  in_.sphere = {centre_i.signed_value(),
                0,
                radius2_i.value(),
                inverse_i.value(),
                sphere_reflect_i.value(),
                {sphere_red_i.value(), sphere_green_i.value(), sphere_blue_i.value()},
                is_light_i.value() != 0};
  in_.sphere_last = sphere_last_i.value();
  in_.plane = {normal_i.signed_value(),
               distance_i.signed_value(),
               {plane_red_i.value(), plane_green_i.value(), plane_blue_i.value()},
               plane_reflect_i.value(),
               checker_i.value(),
               limited_i.value() != 0,
               {limit_i.x.value(), limit_i.y.value(), limit_i.z.value()}};
  in_.plane_last = plane_last_i.value();
  in_.plane_empty = plane_empty_i.value() != 0;
  in_.vector = {product_i.signed_value(), sum_i.signed_value(), square_i.signed_value()};
  in_.root = root_i.value();
  in_.quotient = quotient_i.signed_value();
  in_.weight = weight_i.value();
  in_.word_ready = word_ready_i.value() != 0;
  core_.clock(in_, knobs_);

  state_o.drive(core_.state_q);
  done_o.drive(core_.state_q == SphereHost);
  x_o.drive(core_.x_q);
  y_o.drive(core_.y_q);
  sub_o.drive(core_.sub_q);
  sphere_index_o.drive(core_.sphere_index());
  plane_index_o.drive(core_.plane_index());
  op_o.drive(core_.op());
  root_start_o.drive(core_.root_start_q);
  radicand_o.drive(core_.radicand_q);
  divider_start_o.drive(core_.divider_start_q);
  const auto numerator = core_.numerator();
  numerator_o.x.drive(static_cast<std::uint64_t>(numerator[0]));
  numerator_o.y.drive(static_cast<std::uint64_t>(numerator[1]));
  numerator_o.z.drive(static_cast<std::uint64_t>(numerator[2]));
  denominator_o.drive(core_.denominator());
  base_red_o.drive(core_.base_q[0]);
  base_green_o.drive(core_.base_q[1]);
  base_blue_o.drive(core_.base_q[2]);
  dark_o.drive(core_.dark_q);
  fraction_o.drive(core_.fraction_q);
  reflect_o.drive(core_.reflect_q);
  direct_o.drive(core_.nref_q == 0);
  word_address_o.drive(core_.address(knobs_));
  ask();  // with the inputs of before the edge; again when one of them changes
  answer();
}

void sphere_tracer::ask() {
  in_.light = light_i.signed_value();
  in_.direction = direction_i.signed_value();
  in_.sphere.centre = centre_i.signed_value();
  in_.sphere.inverse = inverse_i.value();
  in_.plane.normal = normal_i.signed_value();
  in_.root = root_i.value();
  in_.quotient[0] = quotient_i.x.signed_value();
  const auto asked = core_.asks(in_, knobs_);
  a_o.drive(asked.a);
  b_o.drive(asked.b);
  s_o.drive(asked.s);
}

void sphere_tracer::answer() {
  in_.alias = alias_i.value();
  in_.narrow = narrow_i.value() != 0;
  in_.word_ready = word_ready_i.value() != 0;
  if (knobs_.plane_shadows) {
    in_.divider_done = divider_done_i.value() != 0;
    in_.quotient[0] = quotient_i.x.signed_value();
    in_.vector.product = product_i.signed_value();
    in_.plane.limited = limited_i.value() != 0;
    in_.plane.limit = {limit_i.x.value(), limit_i.y.value(), limit_i.z.value()};
  }
  word_valid_o.drive(core_.word_valid(in_.alias, knobs_));
  shader_op_o.drive(core_.shader(in_, knobs_));
  picture_done_o.drive(core_.picture_done(in_, knobs_));
}

}  // namespace racebeam
