// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/pixel_output.h"

namespace racebeam {

namespace {

/// r * 16 + g * 4 + b.
constexpr int rgb(int r, int g, int b) { return r << 4 | g << 2 | b; }
/// A colour as pins {B0 G0 R0 . B1 G1 R1}.
constexpr int pins(int colour) {
  const int r = colour >> 4, g = colour >> 2 & 3, b = colour & 3;
  return (b & 1) << 6 | (g & 1) << 5 | (r & 1) << 4 | (b >> 1) << 2 | (g >> 1) << 1 | r >> 1;
}
/// Palettes of contract 15.2.
constexpr int palettes[3][4] = {
    {rgb(0, 0, 0), rgb(0, 0, 1), rgb(0, 1, 2), rgb(2, 2, 3)},
    {rgb(0, 0, 2), rgb(0, 1, 2), rgb(1, 2, 2), rgb(1, 3, 2)},
    {rgb(1, 0, 1), rgb(2, 1, 1), rgb(3, 2, 1), rgb(3, 3, 2)},
};

// Bit `index` and the one below it of a dr element, counted for 10 bits.
int dr_bits(int dr, int index, const knobs& k) {
  return rescaled(dr, k.dr_bits, DrBits) >> (index - 1) & 3;
}

}  // namespace

int pixel_output_core::colour(const inputs& in, const knobs& k) {
  int index = shown(in.display, in.odd);
  if (in.lock)
    index = (dr_bits(in.dr2[0], 6, k) | dr_bits(in.dr2[2], 5, k)) & dr_bits(in.dr2[1], 7, k);
  if (in.inverse) index ^= index >> 1;
  if (in.palette != TablePalette) return palettes[in.palette][index];
  return in.colours >> (ColourBits * index) & low_bits(ColourBits);
}

int pixel_output_core::uo(const inputs& in, const knobs& k) {
  const int syncs = in.hsync_n << 7 | in.vsync_n << 3;
  return in.active ? syncs | pins(colour(in, k)) : syncs;
}

pixel_output::pixel_output(const sc_core::sc_module_name& name, const knobs& k)
    : pixel_output_pins(name), knobs_(k) {
  SC_HAS_PROCESS(pixel_output);
  SC_METHOD(offer);
  sensitive << hit_face_i << ray_signs_i << y_i << shading_b_i << starving_i;
  SC_METHOD(show);
  sensitive << display_i << lock_i << inverse_i << palette_i << colours_i << active_i << hsync_ni
            << vsync_ni;
  if (k.dithering == DitheringCheckered) sensitive << display_half_i << x2_i << y_i;
}

void pixel_output::offer() {
  const int value =
      pixel_output_core::value(hit_face_i.value(), ray_signs_i.value(), y_i.value() & 1,
                               shading_b_i.value(), starving_i.value(), knobs_);
  value_o.drive(value & IndexMask);
  half_o.drive(value >= HalfTone);
}

void pixel_output::show() {
  const bool checkered = knobs_.dithering == DitheringCheckered;
  const bool half = checkered && display_half_i.value();
  const bool odd = checkered && pixel_output_core::is_odd(x2_i.value(), y_i.value());
  uo_o.drive(pixel_output_core::uo(
      {display_i.value() | half * HalfTone, lock_i.value() != 0, inverse_i.value() != 0,
       active_i.value() != 0, hsync_ni.value() != 0, vsync_ni.value() != 0, dr2_i.signed_value(),
       palette_i.value(), colours_i.value(), odd},
      knobs_));
  if (lock_i.value()) {
    if (lock_events_.size() == 0)
      lock_events_ = dr2_i.x->value_changed_event() | dr2_i.y->value_changed_event() |
                     dr2_i.z->value_changed_event() | lock_i->value_changed_event() |
                     display_i->value_changed_event() | inverse_i->value_changed_event() |
                     palette_i->value_changed_event() | colours_i->value_changed_event() |
                     active_i->value_changed_event() | hsync_ni->value_changed_event() |
                     vsync_ni->value_changed_event();
    next_trigger(lock_events_);
  }
}

}  // namespace racebeam
