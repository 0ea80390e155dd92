// camera_unit: once per line, the ray direction of pixel 0 and its change per pixel.
//
// What    computes dr_0 = fov*forward/512 + y*down/512 - 320*right/512 and ddr = right from yaw
//         and pitch, with no multiplier of its own: it sets ray_stepper's delta and the range of
//         subdivider's idx2, so that stepping dr2 from 0 to n pixels multiplies delta by n/512.
//         Sines and cosines are parabolas, up to 0.056 too large: (1-t)(1+t), one factor at a time.
//         Three passes (forward, down, right), each PRODUCT (of sines), LOAD, SCALE; then RUN.
// Size    45 register bits, 9 more with a head_start; angle_i counts 1/2048 turn, full scale of a
//         sine is 511.
// Cycles  44..83 clocks, and head_start, from the start of the line to the first clock of RUN, data
//         dependent.
// Comb    line_end_i, rst_ni -> tracer_reset_o and all controls; step_i -> controls;
//         y_i -> i2_init_o; step_i, line_end_i -> src_o; angle_i -> delta_o, axis_mask_o,
//         i2_init_o (angle_i depends on src_o: no loop).
// Stall   waits in SCALE while step_i; in the last one head_start clocks more.
// Reset   start of a line, also by line_end_i; ddr keeps its value.
// Knobs   dr_bits scales full scale; head_start; ddr_fraction_bits: the others of ddr are 0.
//         camera_cosine, of the model alone: with exact ones the factors are those of the angles,
//         in the same clocks.
// Twin    rtl/beam/camera_unit.sv
// Test    tests/beam/camera_unit_test.cpp
// Source  contract section 7; article "Camera view calculations".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/beam/knobs.h"

namespace racebeam {

enum camera_phase { CameraProduct = 0, CameraLoad = 1, CameraScale = 2, CameraRun = 3 };

/// Behaviour of camera_unit.
struct camera_unit_core {
  static constexpr int WaitBits = 9;

  int pass_q = 0;   // 0 forward, 1 down, 2 right
  int phase_q = 0;  // camera_phase
  bool step_seen_q = false;
  int pstage_q = 0;  // factor of the product: 0 yaw, 1 and 2 pitch, 3 sign
  int pclk_q = 0;    // clock within the factor, saturating
  int psign_q = 0;   // per axis: product is negative
  vec3 ddr_q{};      // signed (between factors unsigned, dr_bits)
  int wait_q = 0;    // clocks of the head start that are over

  struct inputs {
    bool reset;  // line_end or reset
    bool stepping;
    vec3 dr2;
    int angle;  // of the source asked for
    int y;      // signed
  };
  struct outputs {
    bool load, load_zero, ext, copy, idx_load;
    int ext_sign, axis_mask;
    vec3 delta;
    int idx_start, i2_init;
  };

  bool run() const { return phase_q == CameraRun; }
  bool tracer_reset(bool reset) const { return reset || !run(); }
  /// Which angle `inputs::angle` must hold: an angle_source.
  int source(bool reset, bool stepping) const;
  outputs comb(const inputs& in, const knobs& k) const;
  void clock(const inputs& in, const knobs& k);
  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const knobs& k) const {
    visit("pass_q", 2, [this] { return pass_q; });
    visit("phase_q", 2, [this] { return phase_q; });
    visit("pstage_q", 2, [this] { return pstage_q; });
    visit("pclk_q", 2, [this] { return pclk_q; });
    visit("step_seen_q", 1, [this] { return step_seen_q; });
    visit("psign_q", 3, [this] { return psign_q; });
    visit("ddr_x_q", k.dr_bits + 1, [this] { return ddr_q[0]; });
    visit("ddr_y_q", k.dr_bits + 1, [this] { return ddr_q[1]; });
    visit("ddr_z_q", k.dr_bits + 1, [this] { return ddr_q[2]; });
    if (k.head_start > 0) visit("g_wait.wait_q", WaitBits, [this] { return wait_q; });
  }

 private:
  bool scaled(bool stepping) const { return phase_q == CameraScale && !stepping && !step_seen_q; }
  bool finish(bool stepping, const knobs& k) const {
    return scaled(stepping) && (pass_q < 2 || wait_q == k.head_start);
  }
  void multiply_exactly(const inputs& in, const knobs& k);
  bool preset(bool reset, bool stepping) const { return reset || (scaled(stepping) && pass_q < 2); }
  bool product_stage_done(bool stepping) const { return pstage_q != 3 && pclk_q == 3 && !stepping; }
};

/// Pins of camera_unit.
class camera_unit_pins : public sc_core::sc_module {
 public:
  // Clock, reset, line
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  in_port<1> line_end_i{"line_end_i"};
  in_port<10> y_i{"y_i"};  // signed
  // sequencer
  out_port<2> src_o{"src_o"};             // angle_source
  in_port<AngleBits> angle_i{"angle_i"};  // 1/2048 turn, or focal length in pixels
  // Phase of the line
  out_port<1> run_o{"run_o"};                    // phase is RUN
  out_port<1> tracer_reset_o{"tracer_reset_o"};  // tracer and FIFO are held at their start
  // ray_stepper
  axes_in<DrPortBits> dr2_i{"dr2", "_i"};  // signed
  out_port<1> load_o{"load_o"};
  out_port<1> load_zero_o{"load_zero_o"};
  out_port<1> ext_o{"ext_o"};
  out_port<3> ext_sign_o{"ext_sign_o"};
  out_port<3> axis_mask_o{"axis_mask_o"};
  axes_out<DdrPortBits> delta_o{"delta", "_o"};  // signed
  out_port<1> copy_ext_o{"copy_ext_o"};
  // subdivider
  in_port<1> step_i{"step_i"};  // its step request
  out_port<1> idx_load_o{"idx_load_o"};
  out_port<PixelBits> idx_start_o{"idx_start_o"};
  out_port<PixelBits> i2_init_o{"i2_init_o"};  // i2 during tracer_reset and after a restart

  explicit camera_unit_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of camera_unit: its core behind the pins.
class camera_unit : public camera_unit_pins, public probed {
 public:
  using pins = camera_unit_pins;
  static constexpr const char* unit_name = "camera_unit";

  camera_unit(const sc_core::sc_module_name& name, const knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }
  /// step_seen_q follows step_i in Run too.
  void watch() override { watched_ = true; }

 private:
  void seq();
  void comb();
  bool reset() const { return !rst_ni.value() || line_end_i.value(); }
  camera_unit_core::inputs inputs() const;

  const knobs knobs_;
  camera_unit_core core_;
  sc_core::sc_event stepped_{"stepped"};
  sc_core::sc_event_or_list work_events_;
  bool asleep_ = false;
  bool watched_ = false;
};

}  // namespace racebeam
