// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/chip_core.h"

#include <tuple>

#include "sc/beam/chip_wires.h"

namespace racebeam {

namespace {

/// The room and the room looked for, from the chip's scene or a program's table.
void look_up(const scene_program* program, int flags, int id,
             const decision_datapath_core::lookup& look, const knobs& k,
             decision_datapath_core::inputs& to) {
  const bool negative = bit_of(look.signs, look.axis);
  const auto room =
      program ? scene_rom_core::geometry(*program, id) : scene_core::geometry(flags, id);
  to.half_size = room.half_size;
  to.position = room.position;
  if (program) {
    const auto beyond =
        scene_rom_core::look(program->rooms, id, look.axis, negative, look.portal, look.way);
    to.neighbour = beyond.room;
    to.back = beyond.back;
    to.edges = beyond.edges;
  } else {
    to.neighbour = scene_core::neighbour(flags, id, look.axis, negative);
    if (k.skip_shared_edges == SharedEdgesTable)
      to.edges = scene_core::shared_edges(flags, id, look.axis, negative);
  }
}

/// A clock of all units but pwm_sound: the pins uo. `view` and `wires` receive wires if given.
[[gnu::always_inline]] inline int clock_units(chip_core& chip, bool rst_n, const knobs& k,
                                              chip_view* view, chip_wires* wires) {
  const scene_program* const program = chip.program;
  vga_timing_core& vga_timing = chip.vga_timing;
  sequencer_core& sequencer = chip.sequencer;
  timeline_core& timeline = chip.timeline;
  camera_unit_core& camera_unit = chip.camera_unit;
  ray_stepper_core& ray_stepper = chip.ray_stepper;
  subdivider_core& subdivider = chip.subdivider;
  stacks_core& stacks = chip.stacks;
  decision_datapath_core& decision_datapath = chip.decision_datapath;
  navigator_core& navigator = chip.navigator;
  interval_fifo_core& interval_fifo = chip.interval_fifo;

  // 1 to 3: raster, FIFO flags, conductor.
  const vga_timing_core::inputs timing_in{rst_n, k.speed};
  const auto t = vga_timing.comb(timing_in, k.clocks_per_pixel);
  const bool starving = interval_fifo.starving(k);
  const sequencer_core::inputs choose{rst_n, t.frame_end, camera_unit.run(), ray_stepper.dr2_q[1]};
  const auto s = program ? timeline.comb(choose, *program, k) : sequencer.comb(choose, k);

  // 4, 5: the decision.
  const bool line_reset = !rst_n || t.line_end;
  const bool tracer_reset = camera_unit.tracer_reset(line_reset);
  const bool left = subdivider.state_q == StateLeft;
  const auto& top = stacks.top(subdivider.sp_q, k);
  subdivider_core::inputs sub{};
  sub.tracer_reset = tracer_reset;
  sub.dec = decision_datapath.decide(left ? ray_stepper.dr1_q : ray_stepper.dr2_q, k);
  sub.mask = decision_datapath.mask();
  sub.wall = decision_datapath.wall_q;
  sub.second = decision_datapath.second_q;
  sub.tag = decision_datapath.tag();
  sub.starving = starving;
  sub.top_tag = top.tag;
  sub.top_i2 = top.i2;
  sub.lock = s.lock;
  sub.consume = t.consume;

  // 6: the interval on offer.
  const int value = pixel_output_core::value(decision_datapath.hit_face_q, subdivider.signs(),
                                             t.y & 1, s.shading_b, starving, k);
  const interval_fifo_core::inputs fifo_in{tracer_reset, t.consume, subdivider.emit(sub, k),
                                           subdivider.len_m1(), value};
  sub.ack = interval_fifo.ack(fifo_in, k);

  // 7: the subdivider's move.
  const auto move = subdivider.comb(sub, k);

  // 8, 9: the camera and the stepper.
  camera_unit_core::inputs cam{line_reset, move.step, ray_stepper.dr2_q, 0, t.y};
  if (tracer_reset) {
    const int src = camera_unit.source(line_reset, move.step);
    cam.angle = program ? timeline.angle(src, t.y, *program) : sequencer.angle(src, t.y);
  }
  const auto control = camera_unit.comb(cam, k);
  sub.idx_load = control.idx_load;
  sub.idx_start = control.idx_start;
  sub.i2_init = control.i2_init;
  const ray_stepper_core::inputs stepper_in{
      control.load,   control.load_zero, control.ext,   control.ext_sign, control.axis_mask,
      control.delta,  control.copy,      move.copy_sub, move.step,        move.neg,
      move.step_size, subdivider.idx2_q, tracer_reset};

  // 10, 11: the room and the navigator.
  const auto nav = navigator.comb(t.nav_line, decision_datapath.corner_q);
  decision_datapath_core::inputs place{};
  place.tracer_reset = tracer_reset;
  place.restart = move.restart;
  place.nav_line = t.nav_line;
  place.active_start = t.active_start;
  place.nav_position = navigator.position_q;
  place.nav_room = navigator.room_q;
  place.nav_axis = nav.axis;
  place.nav_portal = navigator.portal_q;
  place.nav_negative = nav.negative;
  place.nav_move = nav.move;
  place.nav_op = nav.op;
  place.velocity = s.velocity;
  place.descend = move.descend;
  place.climb = move.climb;
  place.in_return = subdivider.state_q == StateReturn;
  place.cur = move.cur;
  place.leave = move.leave;
  place.signs = subdivider.signs();
  place.top_tag = top.tag;
  place.face_read = stacks.face(decision_datapath.depth_q, k);
  look_up(program, s.scene_flags, decision_datapath.room_q, decision_datapath.look(place, k), k,
          place);
  place.interlace = k.interlace && s.scene_interlace && (t.y & 1) && !t.nav_line;

  // 12: the pins.
  const int uo = pixel_output_core::uo(
      {interval_fifo.display(k), s.lock, s.inverse, t.active, t.hsync_n, t.vsync_n,
       ray_stepper.dr2_q, s.palette, s.colours, pixel_output_core::is_odd(t.x2, t.y)},
      k);
  if (view)
    *view = {t.y,
             chip.frame(),
             t.line_end,
             t.consume,
             camera_unit.run(),
             subdivider.state_q,
             subdivider.idx2_q,
             subdivider.i2_q,
             sub.tag,
             subdivider.sd_q,
             sub.second,
             sub.wall,
             fifo_in.emit,
             sub.ack,
             subdivider.line_done_q,
             move.restart,
             starving,
             move.descend,
             move.push,
             interval_fifo.fill(k),
             sub.dec,
             sub.mask,
             fifo_in.value,
             s.lock};

  const bool face_write = decision_datapath.face_write(place);
  if (wires) {
    chip_wires& w = *wires;
    w.rst_n = rst_n, w.speed = k.speed, w.no_interlace = !k.interlace;
    w.x2 = t.x2, w.y = t.y, w.hsync_n = t.hsync_n, w.vsync_n = t.vsync_n, w.active = t.active;
    w.h_active = t.h_active, w.consume = t.consume, w.line_end = t.line_end;
    w.active_start = t.active_start, w.frame_end = t.frame_end, w.nav_line = t.nav_line;
    w.src = camera_unit.source(line_reset, move.step);
    w.angle = program ? timeline.angle(w.src, t.y, *program) : sequencer.angle(w.src, t.y);
    w.frame = chip.frame(), w.scene_flags = s.scene_flags, w.palette = s.palette;
    w.colours = s.colours, w.shading_b = s.shading_b, w.scene_interlace = s.scene_interlace;
    w.lock = s.lock, w.inverse = s.inverse, w.nav_reset = s.nav_reset, w.start = s.start;
    w.start_room = s.start_room, w.velocity = s.velocity;
    w.run = camera_unit.run(), w.tracer_reset = tracer_reset, w.load = control.load;
    w.load_zero = control.load_zero, w.ext = control.ext, w.copy_ext = control.copy;
    w.ext_sign = control.ext_sign, w.axis_mask = control.axis_mask, w.delta = control.delta;
    w.idx_load = control.idx_load, w.idx_start = control.idx_start, w.i2_init = control.i2_init;
    w.dr1 = ray_stepper.dr1_q, w.dr2 = ray_stepper.dr2_q;
    w.state = subdivider.state_q, w.descend = move.descend, w.climb = move.climb;
    w.restart = move.restart, w.emit = fifo_in.emit, w.cur = move.cur, w.leave = move.leave;
    w.ray_signs = subdivider.signs(), w.len_m1 = fifo_in.len_m1, w.idx2 = subdivider.idx2_q;
    w.i2 = subdivider.i2_q, w.step = move.step, w.neg = move.neg, w.copy_sub = move.copy_sub;
    w.push_en = move.push, w.step_size = move.step_size, w.sp = subdivider.sp_q;
    w.sd = subdivider.sd_q, w.line_done = subdivider.line_done_q;
    w.top_tag = top.tag, w.top_i2 = top.i2, w.fread = place.face_read;
    w.dec = sub.dec, w.mask = sub.mask, w.tag = sub.tag, w.wall = sub.wall;
    w.second = sub.second, w.fwrite = face_write, w.fdata = decision_datapath.face_code();
    w.hit_face = decision_datapath.hit_face_q, w.room = decision_datapath.room_q;
    const auto look = decision_datapath.look(place, k);
    w.look_axis = look.axis, w.look_way = look.way, w.look_signs = look.signs;
    w.look_portal = look.portal, w.corner = decision_datapath.corner_q;
    w.half_size = place.half_size, w.position = place.position, w.neighbour = place.neighbour;
    w.back = place.back, w.edges = place.edges;
    w.nav_position = navigator.position_q, w.nav_room = navigator.room_q, w.nav_axis = nav.axis;
    w.nav_portal = navigator.portal_q, w.nav_negative = nav.negative, w.nav_move = nav.move;
    w.nav_op = nav.op, w.ack = sub.ack, w.starving = starving;
    const int display = interval_fifo.display(k);
    w.display = display & IndexMask, w.display_half = display >= HalfTone;
    w.value = value & IndexMask, w.half = value >= HalfTone, w.fill = interval_fifo.fill(k);
    w.uo = uo;
  }

  // The edge.
  stacks.clock({move.push, sub.tag, subdivider.i2_q, subdivider.sp_q, face_write,
                decision_datapath.face_code(), decision_datapath.depth_q},
               k);
  navigator.clock({!rst_n || s.nav_reset, s.start, s.start_room, t.nav_line && t.active_start,
                   decision_datapath.corner_q, decision_datapath.room_q},
                  k);
  decision_datapath.clock(place, k);
  ray_stepper.clock(stepper_in, k);
  subdivider.clock(sub, move, k);
  camera_unit.clock(cam, k);
  interval_fifo.clock(fifo_in, k);
  if (program) timeline.clock(choose, *program);
  else sequencer.clock(choose);
  vga_timing.clock(timing_in, k.clocks_per_pixel);
  return uo;
}

}  // namespace

chip_core::chip_core(const scene_program* program)
    : program(program), navigator(navigator_core::at_power_up(program != nullptr)) {
  if (program) timeline.seek(0, *program);
}

chip_core::pins chip_core::clock(bool rst_n, const knobs& k, chip_view* view) {
  const auto t = vga_timing.comb({rst_n, k.speed}, k.clocks_per_pixel);
  const pwm_sound_core::inputs sound_in{rst_n, k.speed, t.x2, t.y, frame()};
  const bool pwm = pwm_sound.comb().pwm;
  const int uo = clock_video(rst_n, k, view);
  pwm_sound.clock(sound_in);
  return {uo, pwm};
}

int chip_core::clock_video(bool rst_n, const knobs& k, chip_view* view) {
  return clock_units(*this, rst_n, k, view, nullptr);
}

void clock_wires(chip_core& chip, bool rst_n, const knobs& k, chip_wires& wires) {
  wires.pwm = chip.pwm_sound.comb().pwm;
  clock_units(chip, rst_n, k, nullptr, &wires);
  chip.pwm_sound.clock({rst_n, k.speed, wires.x2, wires.y, wires.frame});
}

bool chip_core::same_video(const chip_core& other) const {
  const auto timing = [](const vga_timing_core& c) {
    return std::tie(c.h_region_q, c.h_pos_q, c.half_q, c.v_region_q, c.v_pos_q, c.vs_q);
  };
  const auto camera = [](const camera_unit_core& c) {
    return std::tie(c.pass_q, c.phase_q, c.step_seen_q, c.pstage_q, c.pclk_q, c.psign_q, c.ddr_q,
                    c.wait_q);
  };
  const auto flight = [](const navigator_core& c) {
    return std::tie(c.nav_state_q, c.position_q, c.room_q, c.portal_q);
  };
  return timing(vga_timing) == timing(other.vga_timing) && frame() == other.frame() &&
         camera(camera_unit) == camera(other.camera_unit) &&
         flight(navigator) == flight(other.navigator) && ray_stepper == other.ray_stepper &&
         subdivider == other.subdivider && stacks == other.stacks &&
         decision_datapath == other.decision_datapath && interval_fifo == other.interval_fifo;
}

void chip_core::deposit(int frame, const knobs& k) {
  if (program) timeline.seek(frame, *program);
  else sequencer.frame_q = frame;
  const navigator_core place = fly_to(frame, k, program);
  navigator.position_q = place.position_q;
  navigator.room_q = place.room_q;
}

namespace {

/// What a frame asks of the navigator.
sequencer_outputs choices(int frame, const knobs& k, const scene_program* program) {
  const sequencer_inputs in{true, false, false, 0};
  if (program) {
    timeline_core timeline;
    timeline.seek(frame, *program);
    return timeline.comb(in, *program, k);
  }
  sequencer_core sequencer;
  sequencer.frame_q = frame;
  return sequencer.comb(in, k);
}

/// The last line of a frame: the navigator with the datapath's adder.
void fly(const sequencer_outputs& s, const knobs& k, const scene_program* program,
         navigator_core& navigator) {
  constexpr int Most = 80;  // clocks: four portals at most, and more than enough
  decision_datapath_core datapath;
  for (int clock = 0; clock == 0 || (navigator.nav_state_q != NavIdle && clock < Most); ++clock) {
    const auto nav = navigator.comb(true, datapath.corner_q);
    decision_datapath_core::inputs in{};
    in.nav_line = true;
    in.active_start = clock == 0;
    in.nav_position = navigator.position_q;
    in.nav_room = navigator.room_q;
    in.nav_axis = nav.axis;
    in.nav_portal = navigator.portal_q;
    in.nav_negative = nav.negative;
    in.nav_op = nav.op;
    in.nav_move = nav.move;
    in.velocity = s.velocity;
    look_up(program, s.scene_flags, datapath.room_q, datapath.look(in, k), k, in);
    navigator.clock(
        {s.nav_reset, s.start, s.start_room, in.active_start, datapath.corner_q, datapath.room_q},
        k);
    datapath.clock(in, k);
  }
}

}  // namespace

navigator_core fly_to(int frame, const knobs& k, const scene_program* program) {
  int start = frame;
  while (!choices(start, k, program).nav_reset) --start;
  navigator_core navigator;
  for (int f = start; f < frame; ++f) {
    const auto s = choices(f, k, program);
    if (s.nav_reset) navigator.clock({true, s.start, s.start_room, false, {}, 0}, k);
    fly(s, k, program, navigator);
  }
  const auto s = choices(frame, k, program);
  if (s.nav_reset) navigator.clock({true, s.start, s.start_room, false, {}, 0}, k);
  return navigator;
}

}  // namespace racebeam
