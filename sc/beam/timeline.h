// timeline: the conductor of a scene file, read from a table; takes the place of sequencer, with
// the same pins.
//
// What    counts frames 0..frames - 1 (the value `frames` lives for one clock, as 12799 on the
// chip)
//         and walks through the shots of a scene_program. A shot says what holds from its frame
//         on: colours, shading, interlace, ray pattern, inversion, velocity, whether the flight
//         starts anew; it loads the turns that it sets, the others go on. A turn is a value to
//         which step is added after every so many frames; per_line * y is added as it is read. Yaw
//         and pitch count modulo 2048, the focal length modulo 256, y is taken as 9 bits.
// Size    frame 14, shot; per turn: value 11, frames since its last step 17.
// Cycles  registers change after frame_end_i; everything else is combinational.
// Comb    dr2_y_i, run_i -> colours_o, lock_o (only while a ray pattern is shown);
//         src_i, y_i -> angle_o.
// Stall   none.
// Reset   frame 0, shot 0 and its turns.
// Twin    rtl/beam/timeline.sv
// Test    tests/beam/timeline_test.cpp
// Source  docs/scenes.md; contract sections 7.5, 17.1, 17.3 to 17.5 for the effects.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/beam/scene_program.h"
#include "sc/beam/sequencer.h"

namespace racebeam {

/// Behaviour of timeline.
struct timeline_core {
  using inputs = sequencer_inputs;
  using outputs = sequencer_outputs;
  struct turn {
    int value = 0, waited = 0;  // frames since the last step
  };

  int frame_q = 0;
  int shot_q = 0;
  turn turns_q[3];  // by angle_source

  const shot_row& shot(const scene_program& program) const { return program.shots[shot_q]; }
  /// All outputs but the angle.
  outputs comb(const inputs& in, const scene_program& program, const knobs& k) const;
  /// The angle (1/2048 turn) or focal length (0..255) selected by `src`.
  int angle(int src, int y, const scene_program& program) const;
  void clock(const inputs& in, const scene_program& program);
  /// The registers as if it had counted to `frame`.
  void seek(int frame, const scene_program& program);
  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const scene_program& program) const {
    visit("frame_q", FrameBits, [this] { return frame_q; });
    visit("shot_q", count_bits(static_cast<int>(program.shots.size()) + 1),
          [this] { return shot_q; });
    for (int t = 0; t < 3; ++t) {
      const std::string turn = element("g_turn", t);
      visit(turn + ".value_q", AngleBits, [this, t] { return turns_q[t].value; });
      visit(turn + ".waited_q", 17, [this, t] { return turns_q[t].waited; });
    }
  }

 private:
  void next_frame(const scene_program& program);
};

/// timeline with the table of a program, which must outlive it.
class timeline : public sequencer_pins, public probed {
 public:
  using pins = sequencer_pins;
  static constexpr const char* unit_name = "timeline";

  timeline(const sc_core::sc_module_name& name, const knobs& k, const scene_program& program);

  void deposit(int frame) override;
  std::vector<probe> probes() const override { return registers_of(core_, program_); }

 private:
  void seq();
  void comb();
  void comb_angle();

  const knobs knobs_;
  const scene_program& program_;
  timeline_core core_;
  sc_core::sc_event frame_changed_{"frame_changed"};
  sc_core::sc_event_or_list lock_events_;
  bool counting_ = false;
};

}  // namespace racebeam
