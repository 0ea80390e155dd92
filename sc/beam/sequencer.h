// sequencer: the demo's conductor. Frame counter; what each frame shows and how the camera turns.
//
// What    counts frames 0..12798 (12799 lives for one clock) and derives from the count: scene
//         flags, palette, shading, interlace, rotation variant, lock effect, inversion, camera
//         start, speed and restarts; and the camera angle that camera_unit asks for by src_i.
//         part = frame[13:11], pattern = frame[10:9], measure = frame[8:7]. All flights start in
//         room i = 4, j = 0, k = 0 with x = z = 0 and go along z; colours_o is not used.
// Size    14 register bits.
// Cycles  everything but the frame counter is combinational.
// Comb    dr2_y_i, run_i -> palette_o, lock_o (only in the lock effect's parts);
//         src_i, y_i -> angle_o.
// Stall   none.
// Reset   frame 0.
// Twin    rtl/beam/sequencer.sv
// Test    tests/beam/sequencer_test.cpp
// Source  contract sections 7.5, 13, 17.1, 17.3, 17.4, 17.5.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Bits of scene_flags (contract 17.2).
enum scene_flag {
  SceneWindows = 1,  // W: ceiling windows
  ScenePortals = 2,  // P: portals in the odd-odd cells
  SceneBlocked = 4,  // B: blocked odd cells
  SceneHeights = 8,  // H: alternate heights
  SceneTunnel = 16,  // U: tunnel
  SceneNarrow = 32,  // N: narrow corridors
};

/// What camera_unit asks angle_o for.
enum angle_source { AngleYaw = 0, AnglePitch = 1, AngleFov = 2 };

/// What sequencer and timeline are told, and what they choose.
struct sequencer_inputs {
  bool rst_n, frame_end, run;
  int dr2_y;  // signed, dr_bits wide
};
struct sequencer_outputs {
  int scene_flags, palette, colours;
  bool shading_b, scene_interlace, lock, inverse, nav_reset;
  vec3 start, velocity;  // room centre minus camera
  int start_room;
};

/// Whether a partial ray pattern is shown where dr2 has this y component (contract 17.4).
inline bool shows_pattern(int dr2_y, const knobs& k) {
  return (rescaled(dr2_y, k.dr_bits, DrBits) >> 6 & 3) != 0;
}

/// Behaviour of sequencer.
struct sequencer_core {
  using inputs = sequencer_inputs;
  using outputs = sequencer_outputs;

  int frame_q = 0;

  int part() const { return frame_q >> 11; }
  int pattern() const { return frame_q >> 9 & 3; }
  int measure() const { return frame_q >> 7 & 3; }
  /// Scene selector e of contract 17.1.
  int scene_selector() const {
    if (part() != 1 && part() != 4) return part();
    const int e = frame_q >> 8 & 7;
    return part() == 1 && e == 5 ? 1 : e;
  }
  bool lock_enabled() const { return part() == 1 && (pattern() != 0 || measure() == 3); }
  bool lock_partial() const { return pattern() != 1; }

  /// Rotation variant, 0..7, and whether it turns faster (contract 17.1, 17.3).
  int variant() const;
  bool fast() const { return lock_enabled() || (part() == 4 && scene_selector() == 5); }

  /// All outputs but the angle.
  outputs comb(const inputs& in, const knobs& k) const;
  /// The angle (even, 1/2048 turn) or focal length selected by `src`.
  int angle(int src, int y) const;

  void clock(const inputs& in) {
    if (!in.rst_n || frame_q == DemoFrames) frame_q = 0;
    else frame_q += in.frame_end;
  }

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const knobs&) const {
    visit("frame_q", FrameBits, [this] { return frame_q; });
  }
};

/// Pins of sequencer and timeline.
class sequencer_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // vga_timing
  in_port<1> frame_end_i{"frame_end_i"};
  in_port<10> y_i{"y_i"};  // signed
  // camera_unit
  in_port<1> run_i{"run_i"};
  in_port<2> src_i{"src_i"};               // angle_source
  out_port<AngleBits> angle_o{"angle_o"};  // 1/2048 turn, or focal length in pixels
  // ray_stepper
  in_port<DrPortBits> dr2_y_i{"dr2_y_i"};  // signed
  // Choices of the frame
  out_port<FrameBits> frame_o{"frame_o"};
  out_port<6> scene_flags_o{"scene_flags_o"};    // scene_flag bits
  out_port<2> palette_o{"palette_o"};            // 0..2, or TablePalette:
  out_port<ColoursBits> colours_o{"colours_o"};  // four colours, the first lowest
  out_port<1> shading_b_o{"shading_b_o"};        // dithered shading
  out_port<1> scene_interlace_o{"scene_interlace_o"};
  out_port<1> lock_o{"lock_o"};        // ray pattern instead of rooms
  out_port<1> inverse_o{"inverse_o"};  // swap colour indices 2 and 3
  // navigator: room centre minus camera, signed
  axes_out<NavigatorPortBits> start_o{"start", "_o"};
  out_port<RoomPortBits> start_room_o{"start_room_o"};
  axes_out<VelocityPortBits> velocity_o{"velocity", "_o"};  // per frame
  out_port<1> nav_reset_o{"nav_reset_o"};

  explicit sequencer_pins(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// Puts the frame counter to `frame` as if it had counted there (back door, between clocks).
  virtual void deposit(int frame) = 0;

 protected:
  void drive(int frame, const sequencer_outputs& o);
};

/// The chip's sequencer.
class sequencer : public sequencer_pins, public probed {
 public:
  using pins = sequencer_pins;
  static constexpr const char* unit_name = "sequencer";

  sequencer(const sc_core::sc_module_name& name, const knobs& k);

  void deposit(int frame) override;
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void comb();
  void comb_angle();

  const knobs knobs_;
  sequencer_core core_;
  sc_core::sc_event frame_changed_{"frame_changed"};
  sc_core::sc_event_or_list lock_events_;
  bool counting_ = false;
};

}  // namespace racebeam
