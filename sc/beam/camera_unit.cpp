// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/camera_unit.h"

#include <cmath>

#include "sc/beam/sequencer.h"

namespace racebeam {

namespace {

// Masks have bit a for axis a. Quadrant offsets per axis: 0 sin, 1 cos, 2 -sin, 3 -cos.
constexpr int AllAxes = 7;
constexpr int AxisY = 2;

/// One pass of contract 7.1.
struct pass_row {
  int yaw_quadrant[3], pitch_quadrant[3];
  int one, zero;  // axes whose yaw factor is 1; axes that stay 0
  int idx_start;
};
constexpr pass_row passes[3] = {
    {{0, 0, 1}, {1, 0, 1}, AxisY, 0, 0},
    {{2, 0, 3}, {0, 1, 0}, AxisY, 0, 256},
    {{1, 0, 2}, {0, 0, 0}, 0, AxisY, 512},
};

/// Types of the three axes' factor at one angle: cosine type, negative.
struct factor_masks {
  int cosine, negative;
};
factor_masks masks(const int (&offsets)[3], int quadrant) {
  factor_masks m{0, 0};
  for (int a = 0; a < 3; ++a) {
    const int q = quadrant + offsets[a];
    m.cosine |= (q & 1) << a;
    m.negative |= (q >> 1 & 1) << a;
  }
  return m;
}

// A sine factor has 9 bits; delta has one bit less than dr.
int to_delta(int fraction, const knobs& k) { return rescaled(fraction, DrBits, k.dr_bits); }

/// Sizes of a factor's sine and cosine at an angle, without the parabolas.
struct exact_factor {
  double sine, cosine;
  explicit exact_factor(int angle)
      : sine(std::sin(radians(angle))), cosine(std::cos(radians(angle))) {}
  static double radians(int angle) { return (angle & 511) * std::acos(0.0) / 512; }
};

}  // namespace

int camera_unit_core::source(bool reset, bool stepping) const {
  if (phase_q != CameraProduct && !preset(reset, stepping)) return AngleFov;
  return pstage_q > 0 ? AnglePitch : AngleYaw;
}

camera_unit_core::outputs camera_unit_core::comb(const inputs& in, const knobs& k) const {
  const bool finished = finish(in.stepping, k);
  const bool presetting = preset(in.reset, in.stepping);
  const pass_row& pass = passes[pass_q];
  outputs o;
  o.copy = finished;
  o.load_zero = true;
  o.ext_sign = 0;

  if (phase_q != CameraProduct && !presetting) {
    o.load = phase_q == CameraLoad;
    o.load_zero = phase_q != CameraLoad || pass_q == 0;
    o.ext = false;
    o.axis_mask = AllAxes;
    o.delta = ddr_q;
    o.idx_start = phase_q == CameraLoad ? pass.idx_start : 0;
    const bool last = phase_q == CameraRun || (finished && pass_q == 2);
    o.i2_init = last ? LastPixel : pass_q == 0 ? in.angle : pass_q == 1 ? (in.y & 511) ^ 256 : 192;
    o.idx_load = o.load || (finished && pass_q == 2);
    return o;
  }

  const int fraction = in.angle & 511;
  const int inverse = 511 - fraction;
  const auto m = masks(pstage_q == 0 ? pass.yaw_quadrant : pass.pitch_quadrant, in.angle >> 9);
  const bool stage_done = product_stage_done(in.stepping);
  o.load = presetting || stage_done;
  o.idx_load = o.load;
  o.idx_start = 0;
  o.delta = ddr_q;
  o.ext = true;
  o.axis_mask = AllAxes;
  o.i2_init = fraction;
  if (pstage_q == 0) {
    const int u = to_delta(fraction, k), v = to_delta(inverse, k);
    const int one = low_bits(k.dr_bits - 1);
    switch (pclk_q) {
      case 0:
        o.delta = {u, u, u};
        o.axis_mask = ~m.cosine & ~pass.one & AllAxes;
        o.i2_init = 0;
        break;
      case 1:
        o.delta = {v, v, v};
        o.axis_mask = m.cosine & ~pass.one;
        o.i2_init = 0;
        break;
      case 2:
        o.delta = {one, one, one};
        o.axis_mask = pass.one;
        break;
      default:
        o.delta = {v, v, v};
        o.axis_mask = ~pass.one & AllAxes;
        o.ext = false;
    }
  } else if (pstage_q == 3) {
    o.ext_sign = psign_q;
  } else {
    o.ext = pclk_q == 0;
    if (o.ext) o.axis_mask = pstage_q == 1 ? ~m.cosine & AllAxes : m.cosine;
    if (pstage_q == 1) o.i2_init = inverse;
  }
  o.axis_mask &= ~pass.zero;
  if (presetting || stage_done) o.i2_init = 0;
  return o;
}

void camera_unit_core::clock(const inputs& in, const knobs& k) {
  const bool finished = finish(in.stepping, k);
  const bool stage_done = product_stage_done(in.stepping);
  const bool product_done = pstage_q == 3 && pclk_q == 2;
  const bool presetting = preset(in.reset, in.stepping);
  const pass_row& pass = passes[pass_q];

  if (stage_done && k.camera_cosine == CosineExact) multiply_exactly(in, k);
  else if (stage_done)
    for (int a = 0; a < 3; ++a) ddr_q[a] = in.dr2[a] & low_bits(k.dr_bits);
  else if (pstage_q == 3 && pclk_q == 3)
    for (int a = 0; a < 3; ++a)
      ddr_q[a] =
          pass_q == 2 ? in.dr2[a] & ~low_bits(DdrFractionBits - k.ddr_fraction_bits) : in.dr2[a];

  if (presetting) {
    pstage_q = pclk_q = psign_q = 0;
  } else if (stage_done) {
    const auto m = masks(pstage_q == 0 ? pass.yaw_quadrant : pass.pitch_quadrant, in.angle >> 9);
    if (pstage_q == 0) psign_q ^= m.negative & ~pass.one;
    if (pstage_q == 2) psign_q ^= m.negative;
    pstage_q = pass_q == 2 ? 3 : pstage_q + 1;
    pclk_q = 0;
  } else if (pstage_q == 0) {
    pclk_q = pclk_q < 3 ? pclk_q + 1 : 3;
  } else if (pstage_q == 3) {
    pclk_q = pclk_q < 2 ? 3 : 2;
  } else {
    pclk_q = 3;
  }

  const bool waiting = scaled(in.stepping) && pass_q == 2 && wait_q != k.head_start;
  wait_q = in.reset ? 0 : wait_q + waiting;
  step_seen_q = in.stepping;
  if (in.reset) {
    pass_q = phase_q = 0;
    step_seen_q = false;
  } else if (finished) {
    phase_q = pass_q == 2 ? CameraRun : CameraProduct;
    if (pass_q < 2) ++pass_q;
  } else if (phase_q == CameraProduct && product_done) {
    phase_q = CameraLoad;
  } else if (phase_q == CameraLoad) {
    phase_q = CameraScale;
  }
}

// The yaw's factors after its stage, the pitch's after the second of its two.
void camera_unit_core::multiply_exactly(const inputs& in, const knobs& k) {
  if (pstage_q == 1) return;
  const pass_row& pass = passes[pass_q];
  const bool yaw = pstage_q == 0;
  const auto m = masks(yaw ? pass.yaw_quadrant : pass.pitch_quadrant, in.angle >> 9);
  const exact_factor factor(in.angle);
  for (int a = 0; a < 3; ++a) {
    const int before = !yaw ? ddr_q[a] : bit_of(pass.zero, a) ? 0 : low_bits(k.dr_bits - 1);
    const double by = yaw && bit_of(pass.one, a) ? 1
                      : bit_of(m.cosine, a)      ? factor.cosine
                                                 : factor.sine;
    ddr_q[a] = static_cast<int>(std::lround(before * by));
  }
}

camera_unit::camera_unit(const sc_core::sc_module_name& name, const knobs& k)
    : camera_unit_pins(name), knobs_(k) {
  SC_HAS_PROCESS(camera_unit);
  SC_METHOD(seq);
  sensitive << line_end_i << rst_ni;
  SC_METHOD(comb);
  sensitive << stepped_ << line_end_i << rst_ni << y_i << angle_i;
}

camera_unit_core::inputs camera_unit::inputs() const {
  return {reset(), step_i.value() != 0, dr2_i.signed_value(), angle_i.value(), y_i.signed_value()};
}

// In RUN nothing but the end of the line can change the camera: it sleeps.
void camera_unit::seq() {
  if (asleep_) {
    asleep_ = !reset();
  } else {
    core_.clock(inputs(), knobs_);
    stepped_.notify(sc_core::SC_ZERO_TIME);
    asleep_ = core_.run() && !reset() && !watched_;
  }
  if (asleep_) next_trigger();
  else next_trigger(clk_i->posedge_event());
}

void camera_unit::comb() {
  const auto in = inputs();
  src_o.drive(core_.source(in.reset, in.stepping));
  run_o.drive(core_.run());
  tracer_reset_o.drive(core_.tracer_reset(in.reset));
  const auto o = core_.comb(in, knobs_);
  load_o.drive(o.load);
  load_zero_o.drive(o.load_zero);
  ext_o.drive(o.ext);
  ext_sign_o.drive(o.ext_sign);
  axis_mask_o.drive(o.axis_mask);
  delta_o.drive(o.delta);
  copy_ext_o.drive(o.copy);
  idx_load_o.drive(o.idx_load);
  idx_start_o.drive(o.idx_start);
  i2_init_o.drive(o.i2_init);
  // The tracer's steps are the camera's business only while it rules the stepper.
  if (core_.run()) return;
  if (work_events_.size() == 0)
    work_events_ = step_i->value_changed_event() | stepped_ | line_end_i->value_changed_event() |
                   rst_ni->value_changed_event() | y_i->value_changed_event() |
                   angle_i->value_changed_event();
  next_trigger(work_events_);
}

}  // namespace racebeam
