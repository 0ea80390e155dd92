// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/traced_chip.h"

namespace racebeam {

std::string FrameClock::text() const {
  return std::to_string(frame) + ":" + std::to_string(line) + ":" + std::to_string(clock);
}

std::int64_t FrameClock::ordinal(int line_clocks) const {
  return (static_cast<std::int64_t>(frame) * FrameLines + line - FirstLine) * line_clocks + clock;
}

TracedChip::TracedChip(const knobs& k, int frame, const scene_program* program)
    : knobs_(k), now_(program), next_(program) {
  now_.clock(false, k);
  now_.deposit(frame, k);
  for (chip_core chip = now_; chip.vga_timing.v_pos_q == FirstLine; ++line_clocks_)
    chip.clock(true, k);
}

void TracedChip::skip(std::int64_t clocks) {
  for (; clocks > 0; --clocks) now_.clock(true, knobs_);
}

void TracedChip::look() {
  next_ = now_;
  pins_ = next_.clock(true, knobs_, &view_);
  timing_ = now_.vga_timing.comb({true, knobs_.speed}, knobs_.clocks_per_pixel);
  const sequencer_inputs in{true, timing_.frame_end, view_.run, now_.ray_stepper.dr2_q[1]};
  choice_ = now_.program ? now_.timeline.comb(in, *now_.program, knobs_)
                         : now_.sequencer.comb(in, knobs_);
}

std::vector<probe> TracedChip::registers() const {
  std::vector<probe> all;
  const auto add = [&all](const char* unit, const std::vector<probe>& probes) {
    for (probe one : probes) {
      one.name = std::string("chip.u_") + unit + "." + one.name;
      all.push_back(one);
    }
  };
  add("vga_timing", registers_of(now_.vga_timing, knobs_.clocks_per_pixel));
  add("sequencer", now_.program ? registers_of(now_.timeline, *now_.program)
                                : registers_of(now_.sequencer, knobs_));
  add("camera_unit", registers_of(now_.camera_unit, knobs_));
  add("ray_stepper", registers_of(now_.ray_stepper, knobs_));
  add("subdivider", registers_of(now_.subdivider, knobs_));
  add("stacks", registers_of(now_.stacks, knobs_));
  add("decision_datapath", registers_of(now_.decision_datapath, knobs_));
  add("navigator", registers_of(now_.navigator, knobs_));
  add("interval_fifo", registers_of(now_.interval_fifo, knobs_));
  add("pwm_sound", registers_of(now_.pwm_sound));
  return all;
}

std::vector<probe> TracedChip::wires() const {
  std::vector<probe> all;
  const Add add = [&all](const std::string& name, int bits, const Read& read) {
    all.push_back({"chip." + name, bits,
                   [bits, read] { return static_cast<std::uint64_t>(read() & low_bits(bits)); }});
  };
  const AddAxes add_axes = [&add](const std::string& name, int bits, const ReadAxes& read) {
    for (int a = 0; a < 3; ++a) add(name + "_" + "xyz"[a], bits, [a, read] { return read()[a]; });
  };
  add_seen(add);
  add_timing_and_choice(add, add_axes);
  add_tracer(add, add_axes);
  return all;
}

void TracedChip::add_seen(const Add& add) const {
  const chip_view& v = view_;
  add("y", 10, [&v] { return v.y; });
  add("frame", FrameBits, [&v] { return v.frame; });
  add("line_end", 1, [&v] { return v.line_end; });
  add("consume", 1, [&v] { return v.consume; });
  add("run", 1, [&v] { return v.run; });
  add("state", 2, [&v] { return v.state; });
  add("idx2", PixelBits, [&v] { return v.idx2; });
  add("i2", PixelBits, [&v] { return v.i2; });
  add("tag", TagPortBits, [&v] { return v.tag; });
  add("sd", StackCountPortBits, [&v] { return v.sd; });
  add("second", 1, [&v] { return v.second; });
  add("wall", 1, [&v] { return v.wall; });
  add("emit", 1, [&v] { return v.emit; });
  add("ack", 1, [&v] { return v.ack; });
  add("line_done", 1, [&v] { return v.line_done; });
  add("restart", 1, [&v] { return v.restart; });
  add("starving", 1, [&v] { return v.starving; });
  add("descend", 1, [&v] { return v.descend; });
  add("push_en", 1, [&v] { return v.push; });
  add("fill", 7, [&v] { return v.fill; });
}

void TracedChip::add_timing_and_choice(const Add& add, const AddAxes& add_axes) const {
  const auto& t = timing_;
  add("x2", 11, [&t] { return t.x2; });
  add("hsync_n", 1, [&t] { return t.hsync_n; });
  add("vsync_n", 1, [&t] { return t.vsync_n; });
  add("active", 1, [&t] { return t.active; });
  add("h_active", 1, [&t] { return t.h_active; });
  add("active_start", 1, [&t] { return t.active_start; });
  add("frame_end", 1, [&t] { return t.frame_end; });
  add("nav_line", 1, [&t] { return t.nav_line; });
  const auto& s = choice_;
  add("scene_flags", 6, [&s] { return s.scene_flags; });
  add("palette", 2, [&s] { return s.palette; });
  add("colours", ColoursBits, [&s] { return s.colours; });
  add("shading_b", 1, [&s] { return s.shading_b; });
  add("scene_interlace", 1, [&s] { return s.scene_interlace; });
  add("lock", 1, [&s] { return s.lock; });
  add("inverse", 1, [&s] { return s.inverse; });
  add("nav_reset", 1, [&s] { return s.nav_reset; });
  add("start_room", RoomPortBits, [&s] { return s.start_room; });
  add_axes("start", NavigatorPortBits, [&s] { return s.start; });
  add_axes("velocity", VelocityPortBits, [&s] { return s.velocity; });
  add("uo_o", 8, [this] { return pins_.uo; });
  add("pwm_o", 1, [this] { return pins_.pwm; });
  add("rst_ni", 1, [] { return 1; });
  add("speed_i", 3, [this] { return knobs_.speed; });
  add("no_interlace_i", 1, [this] { return !knobs_.interlace; });
}

void TracedChip::add_tracer(const Add& add, const AddAxes& add_axes) const {
  const knobs& k = knobs_;
  const chip_core& c = now_;
  add("tracer_reset", 1, [this, &c] { return c.camera_unit.tracer_reset(view_.line_end); });
  add_axes("dr1", DrPortBits, [&c] { return c.ray_stepper.dr1_q; });
  add_axes("dr2", DrPortBits, [&c] { return c.ray_stepper.dr2_q; });
  add("ray_signs", 3, [&c] { return c.subdivider.signs(); });
  add("len_m1", PixelBits, [&c] { return c.subdivider.len_m1(); });
  add("sp", StackPointerPortBits, [&c] { return c.subdivider.sp_q; });
  add("top_tag", TagPortBits, [&c, &k] { return c.stacks.top(c.subdivider.sp_q, k).tag; });
  add("top_i2", PixelBits, [&c, &k] { return c.stacks.top(c.subdivider.sp_q, k).i2; });
  const decision_datapath_core& d = c.decision_datapath;
  add("fread", FacePortBits, [&c, &d, &k] { return c.stacks.face(d.depth_q, k); });
  add("dec", 4, [&c, &d, &k] {
    return d.decide(c.subdivider.state_q == StateLeft ? c.ray_stepper.dr1_q : c.ray_stepper.dr2_q,
                    k);
  });
  add("mask", 4, [&d] { return d.mask(); });
  add("fdata", FacePortBits, [&d] { return d.face_code(); });
  add("hit_face", 2, [&d] { return d.hit_face_q; });
  add("room", RoomPortBits, [&d] { return d.room_q; });
  add_axes("corner", CornerPortBits, [&d] { return d.corner_q; });
  const auto room = [this, &c, &d] {
    return c.program ? scene_rom_core::geometry(*c.program, d.room_q)
                     : scene_core::geometry(choice_.scene_flags, d.room_q);
  };
  add_axes("half_size", CornerPortBits, [room] { return room().half_size; });
  add_axes("position", CornerPortBits, [room] { return room().position; });
  const auto nav = [this, &c, &d] { return c.navigator.comb(timing_.nav_line, d.corner_q); };
  add_axes("nav_position", NavigatorPortBits, [&c] { return c.navigator.position_q; });
  add("nav_room", RoomPortBits, [&c] { return c.navigator.room_q; });
  add("nav_portal", PortalBits, [&c] { return c.navigator.portal_q; });
  add("nav_axis", 2, [nav] { return nav().axis; });
  add("nav_negative", 1, [nav] { return nav().negative; });
  add("nav_op", 3, [nav] { return nav().op; });
  add("nav_move", 1, [nav] { return nav().move; });
  add("display", 2, [&c, &k] { return c.interval_fifo.display(k) & IndexMask; });
  add("display_half", 1, [&c, &k] { return c.interval_fifo.display(k) >= HalfTone; });
  const auto value = [this, &c, &d, &k] {
    return pixel_output_core::value(d.hit_face_q, c.subdivider.signs(), view_.y & 1,
                                    choice_.shading_b, view_.starving, k);
  };
  add("value", 2, [value] { return value() & IndexMask; });
  add("half", 1, [value] { return value() >= HalfTone; });
}

}  // namespace racebeam
