// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/chip.h"

#include <type_traits>

#include "sc/beam/chip_core.h"
#include "sc/beam/chip_deposit.h"
#include "sc/beam/counters.h"
#include "sc/beam/knob_parameters.h"
#include "sc/beam/units.h"
#include "sc/swap/rtl_island.h"
#include "sc/swap/rtl_twin.h"

namespace racebeam {

namespace {

/// The model or the RTL of a unit. `more`: what its constructor takes besides the knobs.
template <class Unit, class... More>
std::unique_ptr<typename Unit::pins> make(const unit_choices& choices, const char* name,
                                          const knobs& k, const More&... more) {
  const unit_choice& choice = choices.of(Unit::unit_name);
  if (!choice.island.empty()) return std::make_unique<rtl_shell<Unit>>(name, choice.island);
  if (choice.driver == unit_choice::Rtl)
    return std::make_unique<rtl_twin<Unit>>(name, knob_parameters(k), choice.plugin);
  if constexpr (std::is_constructible_v<Unit, const char*, const knobs&, const More&...>)
    return std::make_unique<Unit>(name, k, more...);
  else return std::make_unique<Unit>(name, more...);
}

}  // namespace

struct chip::strap_wires {
  wire<3> speed{"speed"};
  wire<1> no_interlace{"no_interlace"};
};

chip::chip(const sc_core::sc_module_name& name, const knobs& k, const scene_program* program,
           const unit_choices& choices)
    : wired_chip(name),
      u_vga_timing(make<vga_timing>(choices, "u_vga_timing", k, k.clocks_per_pixel)),
      u_sequencer(program ? make<timeline>(choices, "u_sequencer", k, *program)
                          : make<sequencer>(choices, "u_sequencer", k)),
      u_camera_unit(make<camera_unit>(choices, "u_camera_unit", k)),
      u_ray_stepper(make<ray_stepper>(choices, "u_ray_stepper", k)),
      u_subdivider(make<subdivider>(choices, "u_subdivider", k)),
      u_stacks(make<stacks>(choices, "u_stacks", k)),
      u_decision_datapath(make<decision_datapath>(choices, "u_decision_datapath", k)),
      u_scene(program ? make<scene_rom>(choices, "u_scene", k, *program)
                      : make<scene>(choices, "u_scene", k)),
      u_navigator(make<navigator>(choices, "u_navigator", k)),
      u_interval_fifo(make<interval_fifo>(choices, "u_interval_fifo", k)),
      u_pixel_output(make<pixel_output>(choices, "u_pixel_output", k)),
      u_pwm_sound(make<pwm_sound>(choices, "u_pwm_sound", k)),
      stalls_(channel_stalls::make(*this, clk_i)),
      delays_(channel_delays::make(*this, clk_i)),
      knobs_(k),
      program_(program) {
  bind_raster_and_camera();
  bind_tracer();
  bind_output();
  islands_ = islands_of(*this);
}

void chip::bind_raster_and_camera() {
  {
    auto& u = *u_vga_timing;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.speed_i(speed_i);
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
    auto& u = *u_sequencer;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.frame_end_i(frame_end);
    u.y_i(y);
    u.run_i(run);
    u.src_i(src);
    u.angle_o(angle);
    u.dr2_y_i(dr2.y);
    u.frame_o(frame);
    u.scene_flags_o(scene_flags);
    u.palette_o(palette);
    u.colours_o(colours);
    u.shading_b_o(shading_b);
    u.scene_interlace_o(scene_interlace);
    u.lock_o(lock);
    u.inverse_o(inverse);
    u.start_o.bind(start);
    u.start_room_o(start_room);
    u.velocity_o.bind(velocity);
    u.nav_reset_o(nav_reset);
  }
  {
    auto& u = *u_camera_unit;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.line_end_i(delayed(delays_, u.line_end_i, line_end));
    u.y_i(y);
    u.src_o(src);
    u.angle_i(angle);
    u.run_o(run);
    u.tracer_reset_o(tracer_reset);
    u.dr2_i.bind(dr2);
    u.load_o(load);
    u.load_zero_o(load_zero);
    u.ext_o(ext);
    u.ext_sign_o(ext_sign);
    u.axis_mask_o(axis_mask);
    u.delta_o.bind(delta);
    u.copy_ext_o(copy_ext);
    bind_channel(stalls_, u.step_i, step);
    u.idx_load_o(idx_load);
    u.idx_start_o(idx_start);
    u.i2_init_o(i2_init);
  }
  {
    auto& u = *u_navigator;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.nav_reset_i(nav_reset);
    u.nav_line_i(nav_line);
    u.active_start_i(active_start);
    u.start_i.bind(start);
    u.start_room_i(start_room);
    u.corner_i.bind(corner);
    u.room_i(room);
    u.nav_position_o.bind(nav_position);
    u.nav_room_o(nav_room);
    u.nav_axis_o(nav_axis);
    u.nav_portal_o(nav_portal);
    u.nav_negative_o(nav_negative);
    u.nav_op_o(nav_op);
    u.nav_move_o(nav_move);
  }
}

void chip::bind_tracer() {
  {
    auto& u = *u_ray_stepper;
    u.clk_i(clk_i);
    u.tracer_reset_i(tracer_reset);
    u.load_i(load);
    u.load_zero_i(load_zero);
    u.ext_i(ext);
    u.ext_sign_i(ext_sign);
    u.axis_mask_i(axis_mask);
    u.delta_i.bind(delta);
    u.copy_ext_i(copy_ext);
    u.step_i(step);
    u.neg_i(neg);
    u.step_size_i(step_size);
    u.idx2_i(idx2);
    u.copy_sub_i(copy_sub);
    u.dr1_o.bind(dr1);
    u.dr2_o.bind(dr2);
  }
  {
    auto& u = *u_subdivider;
    u.clk_i(clk_i);
    u.tracer_reset_i(tracer_reset);
    u.idx_load_i(idx_load);
    u.idx_start_i(idx_start);
    u.i2_init_i(i2_init);
    u.state_o(state);
    u.dec_i(dec);
    u.mask_i(mask);
    u.wall_i(wall);
    bind_channel(stalls_, u.second_i, second);
    u.tag_i(tag);
    u.descend_o(descend);
    u.climb_o(climb);
    u.cur_o(cur);
    u.leave_o(leave);
    u.ray_signs_o(ray_signs);
    u.restart_o(restart);
    u.emit_o(emit);
    u.len_m1_o(len_m1);
    bind_channel(stalls_, u.ack_i, delayed(delays_, u.ack_i, ack));
    u.starving_i(starving);
    u.step_o(step);
    u.neg_o(neg);
    u.step_size_o(step_size);
    u.idx2_o(idx2);
    u.copy_sub_o(copy_sub);
    u.push_en_o(push_en);
    u.i2_o(i2);
    u.sp_o(sp);
    u.sd_o(sd);
    u.top_tag_i(top_tag);
    u.top_i2_i(top_i2);
    u.lock_i(lock);
    u.consume_i(consume);
    u.line_done_o(line_done);
  }
  {
    auto& u = *u_stacks;
    u.clk_i(clk_i);
    u.push_en_i(push_en);
    u.tag_i(tag);
    u.i2_i(i2);
    u.sp_i(sp);
    u.top_tag_o(top_tag);
    u.top_i2_o(top_i2);
    u.fwrite_i(fwrite);
    u.fdata_i(fdata);
    u.fread_o(fread);
  }
  {
    auto& u = *u_decision_datapath;
    u.clk_i(clk_i);
    u.tracer_reset_i(tracer_reset);
    u.nav_line_i(nav_line);
    u.active_start_i(active_start);
    u.y_i(y);
    u.no_interlace_i(no_interlace_i);
    u.scene_interlace_i(scene_interlace);
    u.velocity_i.bind(velocity);
    u.nav_position_i.bind(nav_position);
    u.nav_room_i(nav_room);
    u.nav_axis_i(nav_axis);
    u.nav_portal_i(nav_portal);
    u.nav_negative_i(nav_negative);
    u.nav_op_i(nav_op);
    u.nav_move_i(nav_move);
    u.corner_o.bind(corner);
    u.dr1_i.bind(dr1);
    u.dr2_i.bind(dr2);
    u.state_i(state);
    u.dec_o(dec);
    u.mask_o(mask);
    u.tag_o(tag);
    u.wall_o(wall);
    u.second_o(second);
    u.descend_i(descend);
    bind_channel(stalls_, u.climb_i, climb);
    u.cur_i(cur);
    u.leave_i(leave);
    u.ray_signs_i(ray_signs);
    u.restart_i(restart);
    u.top_tag_i(top_tag);
    u.fread_i(fread);
    u.fwrite_o(fwrite);
    u.fdata_o(fdata);
    u.room_o(room);
    u.look_axis_o(look_axis);
    u.look_signs_o(look_signs);
    u.look_portal_o(look_portal);
    u.look_way_o(look_way);
    u.half_size_i.bind(half_size);
    u.position_i.bind(position);
    u.neighbour_i(neighbour);
    u.back_i(back);
    u.edges_i(edges);
    u.hit_face_o(hit_face);
  }
  {
    auto& u = *u_scene;
    u.scene_flags_i(scene_flags);
    u.room_i(room);
    u.look_axis_i(look_axis);
    u.look_signs_i(look_signs);
    u.look_portal_i(look_portal);
    u.look_way_i(look_way);
    u.half_size_o.bind(half_size);
    u.position_o.bind(position);
    u.neighbour_o(neighbour);
    u.back_o(back);
    u.edges_o(edges);
  }
}

void chip::bind_output() {
  {
    auto& u = *u_interval_fifo;
    u.clk_i(clk_i);
    u.tracer_reset_i(tracer_reset);
    bind_channel(stalls_, u.emit_i, delayed(delays_, u.emit_i, emit));
    u.len_m1_i(delayed(delays_, u.len_m1_i, len_m1));
    u.value_i(delayed(delays_, u.value_i, value));
    u.half_i(delayed(delays_, u.half_i, half));
    u.ack_o(ack);
    u.starving_o(starving);
    u.consume_i(consume);
    u.display_o(display);
    u.display_half_o(display_half);
    u.fill_o(fill);
  }
  {
    auto& u = *u_pixel_output;
    u.hit_face_i(hit_face);
    u.ray_signs_i(ray_signs);
    u.y_i(y);
    u.shading_b_i(shading_b);
    u.starving_i(starving);
    u.value_o(value);
    u.half_o(half);
    u.display_i(display);
    u.display_half_i(display_half);
    u.x2_i(x2);
    u.lock_i(lock);
    u.dr2_i.bind(dr2);
    u.inverse_i(inverse);
    u.palette_i(palette);
    u.colours_i(colours);
    u.active_i(active);
    u.hsync_ni(hsync_n);
    u.vsync_ni(vsync_n);
    u.uo_o(uo_o);
  }
  {
    auto& u = *u_pwm_sound;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.speed_i(speed_i);
    u.pwm_o(pwm_o);
    u.x2_i(x2);
    u.y_i(y);
    u.frame_i(frame);
  }
}

chip_view chip::view() const {
  const auto number = [](const auto& w) { return static_cast<int>(w.read()); };
  return {wrap_signed(number(y), 10),
          number(frame),
          line_end.read(),
          consume.read(),
          run.read(),
          number(state),
          number(idx2),
          number(i2),
          number(tag),
          number(sd),
          second.read(),
          wall.read(),
          emit.read(),
          u_subdivider->ack_i.value() != 0,  // not that of the FIFO, if there are registers between
          line_done.read(),
          restart.read(),
          starving.read(),
          descend.read(),
          push_en.read(),
          number(fill),
          number(dec),
          number(mask),
          number(value) | number(half) * HalfTone,
          lock.read()};
}

chip::~chip() = default;

void chip::connect(const wired_chip::pins& bench) {
  straps_ = std::make_unique<strap_wires>();
  clk_i(bench.clk);
  rst_ni(bench.rst_n);
  speed_i(straps_->speed);
  no_interlace_i(straps_->no_interlace);
  uo_o(bench.uo);
  pwm_o(bench.pwm);
}

void chip::set_pins() {
  straps_->speed.write(knobs_.speed);
  straps_->no_interlace.write(!knobs_.interlace);
}

frame_counts chip::take_counts() { return counted(collector_.take()); }

void chip::deposit(int to) {
  u_sequencer->deposit(to);
  const navigator_core place = fly_to(to, knobs_, program_);
  u_navigator->deposit(place.position_q, place.room_q);
}

void chip::deposit_beside(const std::string& unit, rtl_instance& rtl, int to) const {
  const bool whole = unit == WholeChip;
  const std::string instance = whole ? "" : instance_of(unit);
  if (instance == "u_sequencer") rtl.seek(to);
  if (!whole && instance != "u_navigator") return;
  const navigator_core place = fly_to(to, knobs_, program_);
  if (!whole) return rtl.place(place.position_q, place.room_q);
  for (const auto& [signal, value] : chip_deposits(to, place)) rtl.deposit(signal, value);
}

}  // namespace racebeam
