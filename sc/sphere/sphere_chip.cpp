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

void sphere_chip::bind_inputs() {
  {
    auto& u = *u_sphere_inputs;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.rst_no(rst_n);
    u.sw_i(sw_i);
    u.key_ni(key_ni);
    u.rotz_o(rotz_o);
    u.picture_done_i(picture_done);
    u.origin_o.bind(origin);
    u.light_o.bind(light);
    u.max_reflections_o(max_reflections);
    u.alias_o(aliasing);
    u.narrow_o(narrow);
    u.planes_o(planes);
    u.screen_o(screen);
    u.scene_o(scene);
  }
  {
    auto& u = *u_sphere_host_link;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.sphere_i(sphere_i);
    u.color_i(color_i);
    u.x1_i(x1_i);
    u.y1_i(y1_i);
    u.z1_i(z1_i);
    u.reflect_i(reflect_i);
    u.radius_i(radius_i);
    u.r2_i(r2_i);
    u.r_inv_i(r_inv_i);
    u.valid_i(valid_i);
    u.light_i.bind(light);
    u.scene_i(scene);
    u.host_i(done_o);
    u.loaded_o(loaded);
    u.table_write_o(table_write);
    u.table_index_o(table_index);
    u.table_last_o(table_last);
    u.table_centre_o.bind(table_centre);
    u.table_radius_o(table_radius);
    u.table_radius2_o(table_radius2);
    u.table_inverse_o(table_inverse);
    u.table_reflect_o(table_reflect);
    u.table_red_o(table_red);
    u.table_green_o(table_green);
    u.table_blue_o(table_blue);
    u.table_is_light_o(table_is_light);
    u.fault_o(fault);
  }
}

void sphere_chip::bind_tables() {
  {
    auto& u = *u_sphere_table;
    u.clk_i(clk_i);
    u.table_write_i(table_write);
    u.table_index_i(table_index);
    u.table_last_i(table_last);
    u.table_centre_i.bind(table_centre);
    u.table_radius_i(table_radius);
    u.table_radius2_i(table_radius2);
    u.table_inverse_i(table_inverse);
    u.table_reflect_i(table_reflect);
    u.table_red_i(table_red);
    u.table_green_i(table_green);
    u.table_blue_i(table_blue);
    u.table_is_light_i(table_is_light);
    u.index_i(sphere_index);
    u.centre_o.bind(centre);
    u.radius_o(radius);
    u.radius2_o(radius2);
    u.inverse_o(inverse);
    u.reflect_o(sphere_reflect);
    u.red_o(sphere_red);
    u.green_o(sphere_green);
    u.blue_o(sphere_blue);
    u.is_light_o(is_light);
    u.last_o(sphere_last);
  }
  {
    auto& u = *u_plane_table;
    u.index_i(plane_index);
    u.normal_o.bind(normal);
    u.distance_o(distance);
    u.red_o(plane_red);
    u.green_o(plane_green);
    u.blue_o(plane_blue);
    u.reflect_o(plane_reflect);
    u.checker_o(plane_checker);
    u.limited_o(limited);
    u.limit_o.bind(limit);
    u.last_o(plane_last);
    u.empty_o(plane_empty);
  }
}

void sphere_chip::bind_arithmetic() {
  {
    auto& u = *u_sphere_raygen;
    u.x_i(x);
    u.y_i(tracer_y);
    u.sub_i(sub);
    u.direction_o.bind(direction);
    u.origin_i.bind(origin);
    u.screen_i(screen);
    u.narrow_i(narrow);
  }
  {
    auto& u = *u_vector_unit;
    u.op_i(op);
    u.a_i.bind(a);
    u.b_i.bind(b);
    u.s_i(s);
    u.product_o.bind(product);
    u.sum_o(sum);
    u.square_o(square);
  }
  {
    auto& u = *u_root_unit;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.start_i(root_start);
    u.radicand_i(radicand);
    u.root_o(root);
    u.done_o(root_done);
  }
  {
    auto& u = *u_divider_unit;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.start_i(divider_start);
    u.numerator_i.bind(numerator);
    u.denominator_i(denominator);
    u.quotient_o.bind(quotient);
    u.done_o(divider_done);
  }
  {
    auto& u = *u_sphere_shader;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.op_i(shader_op);
    u.base_red_i(base_red);
    u.base_green_i(base_green);
    u.base_blue_i(base_blue);
    u.dark_i(dark);
    u.fraction_i(fraction);
    u.reflect_i(reflect);
    u.direct_i(direct);
    u.sub_i(sub);
    u.weight_o(weight);
    u.alias_i(aliasing);
    u.word_o(word);
  }
}

void sphere_chip::bind_tracer() {
  {
    auto& u = *u_sphere_tracer;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.origin_i.bind(origin);
    u.light_i.bind(light);
    u.max_reflections_i(max_reflections);
    u.alias_i(aliasing);
    u.narrow_i(narrow);
    u.planes_i(planes);
    u.picture_done_o(picture_done);
    u.done_o(done_o);
    u.loaded_i(loaded);
    u.x_o(x);
    u.y_o(tracer_y);
    u.sub_o(sub);
    u.direction_i.bind(direction);
    u.sphere_index_o(sphere_index);
    u.centre_i.bind(centre);
    u.radius2_i(radius2);
    u.inverse_i(inverse);
    u.sphere_reflect_i(sphere_reflect);
    u.sphere_red_i(sphere_red);
    u.sphere_green_i(sphere_green);
    u.sphere_blue_i(sphere_blue);
    u.is_light_i(is_light);
    u.sphere_last_i(sphere_last);
    u.plane_index_o(plane_index);
    u.normal_i.bind(normal);
    u.distance_i(distance);
    u.plane_red_i(plane_red);
    u.plane_green_i(plane_green);
    u.plane_blue_i(plane_blue);
    u.plane_reflect_i(plane_reflect);
    u.checker_i(plane_checker);
    u.limited_i(limited);
    u.limit_i.bind(limit);
    u.plane_last_i(plane_last);
    u.plane_empty_i(plane_empty);
    u.op_o(op);
    u.a_o.bind(a);
    u.b_o.bind(b);
    u.s_o(s);
    u.product_i.bind(product);
    u.sum_i(sum);
    u.square_i(square);
    u.root_start_o(root_start);
    u.radicand_o(radicand);
    u.root_i(root);
    u.root_done_i(root_done);
    u.divider_start_o(divider_start);
    u.numerator_o.bind(numerator);
    u.denominator_o(denominator);
    u.quotient_i.bind(quotient);
    u.divider_done_i(divider_done);
    u.shader_op_o(shader_op);
    u.base_red_o(base_red);
    u.base_green_o(base_green);
    u.base_blue_o(base_blue);
    u.dark_o(dark);
    u.fraction_o(fraction);
    u.reflect_o(reflect);
    u.direct_o(direct);
    u.weight_i(weight);
    u.word_valid_o(word_valid);
    u.word_address_o(word_address);
    u.word_ready_i(put_ready);
    u.state_o(state);
  }
}

void sphere_chip::bind_store() {
  {
    auto& u = *u_vga_timing;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.speed_i(speed);
    u.hsync_no(hsync_n);
    u.vsync_no(vsync_n);
    u.x2_o(x2);
    u.y_o(y);
    u.active_o(active);
    u.h_active_o(h_active);
    u.consume_o(consume);
    u.line_end_o(line_end);
    u.active_start_o(active_start);
    u.frame_end_o(frame_end);
    u.nav_line_o(nav_line);
  }
  {
    auto& u = *u_write_buffer;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.put_valid_i(word_valid);
    u.put_address_i(word_address);
    u.put_data_i(word);
    u.put_ready_o(put_ready);
    u.take_valid_o(take_valid);
    u.take_address_o(take_address);
    u.take_data_o(take_data);
    u.take_ready_i(take_ready);
    u.fill_o(fill);
  }
  {
    auto& u = *u_store_arbiter;
    u.read_i(read);
    u.read_address_i(read_address);
    u.sync_i(sync);
    u.blank_i(blank);
    u.take_valid_i(take_valid);
    u.take_address_i(take_address);
    u.take_data_i(take_data);
    u.take_ready_o(take_ready);
    u.mem_write_o(mem_write);
    u.mem_address_o(mem_address);
    u.mem_data_o(mem_data);
  }
  {
    auto& u = u_frame_memory;
    u.clk_i(clk_i);
    u.mem_write_i(mem_write);
    u.mem_address_i(mem_address);
    u.mem_data_i(mem_data);
    u.mem_data_o(mem_read_data);
  }
  {
    auto& u = *u_frame_scanout;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.consume_i(consume);
    u.active_i(active);
    u.line_end_i(line_end);
    u.y_i(y);
    u.hsync_ni(hsync_n);
    u.vsync_ni(vsync_n);
    u.read_o(read);
    u.read_address_o(read_address);
    u.mem_data_i(mem_read_data);
    u.red_o(red_o);
    u.green_o(green_o);
    u.blue_o(blue_o);
    u.hsync_no(hsync_no);
    u.vsync_no(vsync_no);
  }
}

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
