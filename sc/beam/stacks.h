// stacks: what the tracer must remember to come back: intervals and faces.
//
// What    the interval stack is a ring of {tag, i2}: a push writes at sp, the top is the entry
//         below; pushes beyond its size overwrite the oldest entries (subdivider counts the valid
//         ones). The face stack has one word per room entered: face OR dom_prev, and with several
//         portals in a face their numbers; read at depth - 1; reads at depth 0 or above its size
//         give 0, writes above its size are lost.
// Size    4 x 17 bits and 9 x 2 bits, flip-flops.
// Cycles  a write is read from the next clock on.
// Comb    sp_i -> top_tag_o, top_i2_o; tag_i -> fread_o.
// Stall   none.
// Reset   none; 0 at power-up, never cleared (contract 18, item S).
// Knobs   interval_stack_depth, face_stack_depth.
// Twin    rtl/beam/stacks.sv
// Test    tests/beam/stacks_test.cpp
// Source  contract section 10; article "Stack underflow".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <iterator>

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Behaviour of stacks.
struct stacks_core {
  static constexpr int MaxIntervals = 64, MaxFaces = 16;
  struct entry {
    int tag, i2;
  };
  entry intervals_q[MaxIntervals]{};
  int faces_q[MaxFaces]{};

  struct inputs {
    bool push;
    int tag, i2, sp;
    bool face_write;
    int face, depth;
  };

  const entry& top(int sp, const knobs& k) const {
    return intervals_q[sp == 0 ? k.interval_stack_depth - 1 : sp - 1];
  }
  int face(int depth, const knobs& k) const {
    return depth >= 1 && depth <= k.face_stack_depth ? faces_q[depth - 1] : 0;
  }
  bool operator==(const stacks_core& other) const {
    const auto same = [](const entry& a, const entry& b) { return a.tag == b.tag && a.i2 == b.i2; };
    return std::equal(std::begin(intervals_q), std::end(intervals_q), std::begin(other.intervals_q),
                      same) &&
           std::equal(std::begin(faces_q), std::end(faces_q), std::begin(other.faces_q));
  }
  void clock(const inputs& in, const knobs& k) {
    if (in.push) intervals_q[in.sp] = {in.tag, in.i2};
    if (in.face_write && in.depth < k.face_stack_depth) faces_q[in.depth] = in.face;
  }

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const knobs& k) const {
    const bool portals = k.portals_per_face > 1;
    for (int n = 0; n < k.interval_stack_depth; ++n) {
      visit(element("tags_q", n), portals ? TagPortBits : TagBits,
            [this, n] { return intervals_q[n].tag; });
      visit(element("i2s_q", n), PixelBits, [this, n] { return intervals_q[n].i2; });
    }
    for (int n = 0; n < k.face_stack_depth; ++n)
      visit(element("faces_q", n), portals ? FacePortBits : FaceBits,
            [this, n] { return faces_q[n]; });
  }
};

/// Pins of stacks.
class stacks_pins : public sc_core::sc_module {
 public:
  // Clock
  in_port<1> clk_i{"clk_i"};
  // Interval stack: subdivider pushes {tag, i2}
  in_port<1> push_en_i{"push_en_i"};
  in_port<TagPortBits> tag_i{"tag_i"};  // {portal, depth, level}
  in_port<PixelBits> i2_i{"i2_i"};
  in_port<StackPointerPortBits> sp_i{"sp_i"};
  out_port<TagPortBits> top_tag_o{"top_tag_o"};
  out_port<PixelBits> top_i2_o{"top_i2_o"};
  // Face stack: decision_datapath; its address is the depth in tag_i
  in_port<1> fwrite_i{"fwrite_i"};
  in_port<FacePortBits> fdata_i{"fdata_i"};
  out_port<FacePortBits> fread_o{"fread_o"};

  explicit stacks_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of stacks: its core behind the pins.
class stacks : public stacks_pins, public probed {
 public:
  using pins = stacks_pins;
  static constexpr const char* unit_name = "stacks";

  stacks(const sc_core::sc_module_name& name, const knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void comb();
  int depth() const { return tag_i.value() >> LevelBits & low_bits(DepthBits); }

  const knobs knobs_;
  stacks_core core_;
  sc_core::sc_event written_{"written"};
  bool writing_ = false;
};

}  // namespace racebeam
