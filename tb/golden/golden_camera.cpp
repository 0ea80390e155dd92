// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/golden_camera.h"

#include <cmath>

#include "sc/beam/sequencer.h"

namespace racebeam {

namespace {

constexpr int Quarter = 512;         // steps of a quarter turn in the parabolas
constexpr int HalfWidth = 320;       // pixels
constexpr int FixedFov = 96;         // pixels
constexpr int One = Quarter - 1;     // what the chip has for 1
constexpr int ColumnsTarget = 192;   // 512 - HalfWidth
constexpr int Sine = 0, Cosine = 1;  // quarters; + 2: negative

constexpr int mod(int v, int size) { return (v % size + size) % size; }
constexpr int floor_shift(int a, int k) { return (a - mod(a, 1 << k)) / (1 << k); }
constexpr int bit(int a, int n) { return mod(floor_shift(a, n), 2); }

// What pixel 2^k has added; pixel i the sum over its bits.
int steps_of_bit(int delta, int k) {
  return floor_shift(delta * (1 << k), 9) + (k <= 8 ? bit(delta, 8 - k) : 0);
}

// Sine of an angle, a number of quarters later.
double parabola(int angle, int quarters) {
  const int q = angle / Quarter + quarters;
  const double u = angle % Quarter / double{Quarter};
  const double size = q & 1 ? (1 - u) * (1 + u) : u * (2 - u);
  return q & 2 ? -size : size;
}
double sine(int angle, int quarters, int cosine) {
  if (cosine == CosineParabola) return parabola(angle, quarters);
  return std::sin((angle + quarters * Quarter) * std::acos(-1.0) / (2 * Quarter));
}

// What the model has for exact products: rounded after each factor.
int exact_product(int product, int angle, int quarters) {
  return static_cast<int>(std::lround(product * std::abs(sine(angle, quarters, CosineExact))));
}

// The demo's angles count 1/1024 turn; a twist adds y to them (contract 7.5, 17.3).
GoldenTurns demo_turns(int variant, bool fast) {
  const int twist = variant == 3 ? 4 : variant == 1 || variant == 2 ? 2 : 0;
  GoldenTurns turns{
      {0, 2, fast ? 1 : 4, twist}, {-2, -2, fast ? 2 : 8, variant == 1 ? 0 : twist}, {FixedFov}};
  if (variant >= 4) turns.fov = {0, 1, 2, variant >= 6};
  return turns;
}

}  // namespace

int golden_steps(int delta, int i) {
  int sum = 0;
  for (int k = 0; k <= 9; ++k)
    if (bit(i, k)) sum += steps_of_bit(delta, k);
  return sum;
}

GoldenView GoldenTurns::view(int frame, int y) const {
  const int y9 = wrap_signed(y, 9);
  return {yaw.value(frame, y9, TurnUnits), pitch.value(frame, y9, TurnUnits),
          fov.value(frame, y9, FocalUnits)};
}

GoldenView golden_view(int frame, int variant, bool fast, int y) {
  return demo_turns(variant, fast).view(frame, y);
}

GoldenLine golden_line(const GoldenView& view, int y, int cosine) {
  const int u1 = view.yaw % Quarter, v1 = One - u1;
  const int u2 = view.pitch % Quarter, v2 = One - u2;
  static constexpr int yaw_offset[3][3] = {{0, 0, 1}, {2, 0, 3}, {1, 0, 2}};
  static constexpr int pitch_offset[2][3] = {{1, 0, 1}, {0, 1, 0}};
  static constexpr int start[3] = {0, 256, 512};
  const int target[3] = {view.fov, mod(y + 256, 512), ColumnsTarget};
  GoldenLine line{{}, {}};
  for (int pass = 0; pass < 3; ++pass) {
    for (int a = 0; a < 3; ++a) {
      int q = view.yaw / Quarter + yaw_offset[pass][a];
      bool negative = q & 2;
      int product = cosine == CosineExact ? exact_product(One, view.yaw, yaw_offset[pass][a])
                                          : mod((q & 1 ? v1 : u1) + golden_steps(v1, u1), 1024);
      if (pass < 2 && a == 1) product = One, negative = false;
      if (pass == 2 && a == 1) product = 0, negative = false;
      if (pass < 2) {
        q = view.pitch / Quarter + pitch_offset[pass][a];
        negative ^= (q & 2) != 0;
        if (cosine == CosineExact) {
          product = exact_product(product, view.pitch, pitch_offset[pass][a]);
        } else {
          product = mod((q & 1 ? 0 : product) + golden_steps(product, v2), 1024);
          product = mod((q & 1 ? product : 0) + golden_steps(product, u2), 1024);
        }
      }
      line.ddr[a] = wrap_signed(negative ? -product : product, DrBits);
      const int scaled =
          golden_steps(line.ddr[a], target[pass]) - golden_steps(line.ddr[a], start[pass]);
      line.dr_0[a] = wrap_signed(line.dr_0[a] + scaled, DrBits);
    }
  }
  return line;
}

GoldenIdeal::GoldenIdeal(const GoldenView& view, int y, int cosine) {
  const auto yaw = [&](int quarters) { return sine(view.yaw, quarters, cosine); };
  const auto pitch = [&](int quarters) { return sine(view.pitch, quarters, cosine); };
  const GoldenVector forward = {yaw(Sine) * pitch(Cosine), pitch(Sine),
                                yaw(Cosine) * pitch(Cosine)};
  const GoldenVector down = {-yaw(Sine) * pitch(Sine), pitch(Cosine), -yaw(Cosine) * pitch(Sine)};
  ddr = {yaw(Cosine), 0, -yaw(Sine)};
  for (int a = 0; a < 3; ++a) dr_0[a] = view.fov * forward[a] + y * down[a] - HalfWidth * ddr[a];
}

GoldenVector GoldenIdeal::ray(int pixel) const {
  return {dr_0[0] + pixel * ddr[0], dr_0[1] + pixel * ddr[1], dr_0[2] + pixel * ddr[2]};
}

GoldenCamera::GoldenCamera(int frame, const knobs& k) : frame_(frame), cosine_(k.camera_cosine) {
  sequencer_core sequencer;
  sequencer.frame_q = frame;
  turns_ = demo_turns(sequencer.variant(), sequencer.fast());
}

GoldenCamera::GoldenCamera(const SceneFile& scene, int frame, const knobs& k)
    : frame_(frame), cosine_(k.camera_cosine) {
  const Camera& camera = scene.shot_at(frame).camera;
  turns_ = {camera.yaw, camera.pitch, camera.fov};
}

GoldenRays GoldenCamera::rays(int y) const {
  const GoldenLine line = golden_line(view(y), y, cosine_);
  GoldenRays rays;
  for (int a = 0; a < 3; ++a) {
    int of_bit[10], sum[VisibleColumns] = {0};
    for (int k = 0; k < 10; ++k) of_bit[k] = steps_of_bit(line.ddr[a], k);
    rays[0][a] = line.dr_0[a];
    for (int p = 1; p < VisibleColumns; ++p) {
      sum[p] = sum[p & (p - 1)] + of_bit[__builtin_ctz(p)];
      rays[p][a] = wrap_signed(line.dr_0[a] + sum[p], DrBits);
    }
  }
  return rays;
}

}  // namespace racebeam
