// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_chip.h"

#include "sc/sphere/sphere_parameters.h"

namespace racebeam {

namespace {

/// RTL of sphere_inputs gets there from its reset as a chip would: switch by switch.
void put_inputs(rtl_instance& rtl, const sphere_inputs_core& to, const sphere_tables& tables) {
  const auto held = [](int key) { return 15 & ~(1 << key); };
  rtl.private_edges({{"rst_ni", 0}, {"key_ni", to.planes_q ? held(2) : 15}}, 1);
  sphere_inputs_core now;
  now.origin_q = tables.start.origin;
  now.light_q = tables.start.light;
  now.screen_q = tables.start.screen;
  const int modes = !to.narrow_q << 5 | to.scene_q << 4 | to.max_reflections_q << 2 | to.alias_q;
  bool there = false;
  while (!there) {
    int sw = modes, key_n = 15;
    for (int axis = 0; axis < 3; ++axis) {
      const int light = wrap24(to.light_q[axis] - now.light_q[axis]),
                origin = wrap24(to.origin_q[axis] - now.origin_q[axis]);
      if (light) sw |= 1 << ((light > 0 ? 17 : 16) - 2 * axis);
      if (origin) sw |= 1 << ((origin > 0 ? 11 : 10) - 2 * axis);
    }
    const int screen = wrap24(to.screen_q - now.screen_q);
    if (screen) key_n = held(screen > 0 ? 0 : 1);
    there = sw == modes && key_n == 15;
    for (int pair = 0; there && pair < 6; ++pair)
      if (bit_of(to.rotz_q, pair)) sw |= 3 << (6 + 2 * pair);
    now.clock({true, sw, key_n, true}, tables.start);
    rtl.private_edges({{"rst_ni", 1}, {"picture_done_i", 1}, {"sw_i", sw}, {"key_ni", key_n}}, 1);
  }
}

}  // namespace

sphere_chip::sphere_chip(const sc_core::sc_module_name& name, const sphere_knobs& k,
                         const sphere_tables& tables, const unit_choices& choices)
    : sphere_chip(name, k.resolved(), tables,
                  unit_maker(choices, sphere_parameters(k.resolved(), tables))) {}

sphere_chip::sphere_chip(const sc_core::sc_module_name& name, const sphere_knobs& k,
                         const sphere_tables& tables, const unit_maker& units)
    : picture_chip(name, k.store(), k.clocks_per_pixel, units),
      knobs_(k),
      tables_(tables),
      u_sphere_inputs(units.make<sphere_inputs>(tables)),
      u_sphere_host_link(units.make<sphere_host_link>(k)),
      u_sphere_table(units.make<sphere_table>(k)),
      u_plane_table(units.make<plane_table>(tables)),
      u_sphere_raygen(units.make<sphere_raygen>(k)),
      u_vector_unit(units.make<vector_unit>()),
      u_root_unit(units.make<root_unit>(k)),
      u_divider_unit(units.make<divider_unit>(k)),
      u_sphere_tracer(units.make<sphere_tracer>(k)),
      u_sphere_shader(units.make<sphere_shader>(k)),
      collector_(k) {
  bind_inputs();
  bind_tables();
  bind_arithmetic();
  bind_tracer();
  bind_buffer();
}

sphere_chip::~sphere_chip() = default;

void sphere_chip::connect(const wired_chip::pins& bench) {
  picture_chip::connect(bench);
  board_ = std::make_unique<board_wires>(tables_.board);
  sw_i(board_->sw);
  key_ni(board_->key_n);
  sphere_i(board_->sphere);
  color_i(board_->color);
  x1_i(board_->x1);
  y1_i(board_->y1);
  z1_i(board_->z1);
  reflect_i(board_->cpu_reflect);
  radius_i(board_->cpu_radius);
  r2_i(board_->r2);
  r_inv_i(board_->r_inv);
  valid_i(board_->valid);
  rotz_o(board_->rotz);
  done_o(board_->done);
}

void sphere_chip::deposit(int picture) {
  const sphere_inputs_core to = inputs_(picture);
  if (auto* model = dynamic_cast<sphere_inputs*>(u_sphere_inputs.get())) return model->deposit(to);
  dynamic_cast<rtl_twin<sphere_inputs>&>(*u_sphere_inputs).put([&](rtl_instance& rtl) {
    put_inputs(rtl, to, tables_);
  });
}

void sphere_chip::deposit_beside(const std::string& unit, rtl_instance& rtl, int picture) const {
  if (unit == sphere_inputs::unit_name) put_inputs(rtl, inputs_(picture), tables_);
}

void sphere_chip::begin_picture() {
  picture_chip::begin_picture();
  collector_.begin();
}

frame_counts sphere_chip::take_counts() { return counted(collector_.last()); }

sphere_view sphere_chip::view() const {
  const auto number = [](const auto& w) { return static_cast<int>(w.read()); };
  return {number(state),
          direct.read(),
          signed_bits(sum.read().to_uint64(), SphereSumBits),
          number(shader_op),
          stored(word_valid.read()),
          fault.read(),
          picture_done.read()};
}

std::unique_ptr<wired_chip> make_sphere_chip(const char* name, const knob_values& k,
                                             const scene_tables* scene,
                                             const unit_choices& choices) {
  static const sphere_tables none;
  const auto* tables = static_cast<const sphere_tables*>(scene);
  return std::make_unique<sphere_chip>(name, k, tables ? *tables : none, choices);
}

}  // namespace racebeam
