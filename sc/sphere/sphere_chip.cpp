// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_chip.h"

#include "sc/sphere/sphere_parameters.h"
#include "sc/swap/rtl_twin.h"

namespace racebeam {

namespace {

/// Units in the place of others, as RTL or model.
struct maker {
  const sphere_knobs& k;
  const sphere_tables& tables;
  const unit_choices& choices;

  /// `settings`: what the model's constructor takes.
  template <class Unit, class... Settings>
  std::unique_ptr<typename Unit::pins> make(const Settings&... settings) const {
    const std::string name = std::string("u_") + Unit::unit_name;
    const unit_choice& choice = choices.of(Unit::unit_name);
    if (choice.driver == unit_choice::Rtl)
      return std::make_unique<rtl_twin<Unit>>(name.c_str(), sphere_parameters(k, tables),
                                              choice.plugin);
    return std::make_unique<Unit>(name.c_str(), settings...);
  }
};

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

sphere_chip::sphere_chip(const sc_core::sc_module_name& name, const sphere_knobs& knobs,
                         const sphere_tables& tables, const unit_choices& choices)
    : wired_chip(name),
      knobs_(knobs.resolved()),
      tables_(tables),
      u_vga_timing(maker{knobs_, tables, choices}.make<vga_timing>(knobs.clocks_per_pixel)),
      u_sphere_inputs(maker{knobs_, tables, choices}.make<sphere_inputs>(tables)),
      u_sphere_host_link(maker{knobs_, tables, choices}.make<sphere_host_link>(knobs_)),
      u_sphere_table(maker{knobs_, tables, choices}.make<sphere_table>(knobs_)),
      u_plane_table(maker{knobs_, tables, choices}.make<plane_table>(tables)),
      u_sphere_raygen(maker{knobs_, tables, choices}.make<sphere_raygen>(knobs_)),
      u_vector_unit(maker{knobs_, tables, choices}.make<vector_unit>()),
      u_root_unit(maker{knobs_, tables, choices}.make<root_unit>(knobs_)),
      u_divider_unit(maker{knobs_, tables, choices}.make<divider_unit>(knobs_)),
      u_sphere_tracer(maker{knobs_, tables, choices}.make<sphere_tracer>(knobs_)),
      u_sphere_shader(maker{knobs_, tables, choices}.make<sphere_shader>(knobs_)),
      u_write_buffer(maker{knobs_, tables, choices}.make<write_buffer>(knobs_.store())),
      u_store_arbiter(maker{knobs_, tables, choices}.make<store_arbiter>(knobs_.store())),
      u_frame_memory("u_frame_memory", knobs_.store()),
      u_frame_scanout(maker{knobs_, tables, choices}.make<frame_scanout>(knobs_.store())),
      collector_(knobs_) {
  bind_inputs();
  bind_tables();
  bind_arithmetic();
  bind_tracer();
  bind_store();
  SC_HAS_PROCESS(sphere_chip);
  SC_METHOD(follow_raster);
  sensitive << hsync_n << vsync_n << active;
}

sphere_chip::~sphere_chip() = default;

void sphere_chip::connect(const wired_chip::pins& bench) {
  board_ = std::make_unique<board_wires>(tables_.board);
  clk_i(bench.clk);
  rst_ni(bench.rst_n);
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
  hsync_no(bench.hsync_n);
  vsync_no(bench.vsync_n);
  red_o(bench.red);
  green_o(bench.green);
  blue_o(bench.blue);
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
  u_frame_memory.clear();
  collector_.begin();
}

frame_counts sphere_chip::take_counts() { return counted(collector_.last()); }

void sphere_chip::follow_raster() {
  sync.write(!hsync_n.read() || !vsync_n.read());
  blank.write(!active.read());
}

sphere_view sphere_chip::view() const {
  const auto number = [](const auto& w) { return static_cast<int>(w.read()); };
  return {number(state),      direct.read(),     signed_bits(sum.read().to_uint64(), SphereSumBits),
          number(shader_op),  word_valid.read(), put_ready.read(),
          take_ready.read(),  number(fill),      read.read(),
          mem_write.read(),   fault.read(),      frame_end.read(),
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
