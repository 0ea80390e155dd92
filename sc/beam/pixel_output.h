// pixel_output: colours. Index of an emitted interval, palette, blanking, pins.
//
// What    value_o is the colour index of the interval on offer: 0 while the beam starves, else by
//         the axis of the wall hit (shading A) or by axis, side and line parity (shading B,
//         dithered by scan line). Checkered, half_o tells that an interval lies between value_o
//         and the next index; pixels on show whose column plus line is odd then have that one: this
//         dithers behind the FIFO, which has to carry one bit more. uo_o is the pixel on show in
//         TinyVGA order: hsync, B0, G0, R0, vsync, B1, G1, R1 from bit 7; black where not active.
//         In the lock effect the index is a pattern of the ray direction's bits.
// Size    no registers.
// Cycles  combinational: no latency between the FIFO and the pins.
// Comb    all inputs -> outputs; dr2_*_i only while lock_i, x2_i and display_half_i only checkered.
// Stall   none.
// Reset   none.
// Knobs   dithering, dr_bits.
// Twin    rtl/beam/pixel_output.sv
// Test    tests/beam/pixel_output_test.cpp
// Source  contract sections 4, 15, 17.4, 17.5; article "Interval FIFO" (dithering).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/unit.h"
#include "sc/beam/codes.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Behaviour of pixel_output.
struct pixel_output_core {
  /// Colour index of an emitted interval; checkered, with HalfTone if it lies between two.
  static int value(int hit_face, int signs, bool odd_line, bool shading_b, bool starving,
                   const knobs& k) {
    if (starving) return 0;
    if (!shading_b) return 3 - hit_face;
    const bool negative = bit_of(signs, hit_face);
    const int tone = negative ? 6 - hit_face : 1 + hit_face;
    if (k.dithering == DitheringCheckered) return tone >> 1 | (tone & 1) * HalfTone;
    return ((tone + (odd_line && k.dithering)) & 7) >> 1;
  }

  struct inputs {
    int display;  // with HalfTone
    bool lock, inverse, active, hsync_n, vsync_n;
    vec3 dr2;
    int palette, colours;
    bool odd;  // column plus line
  };
  /// Colour index on show, before pattern and inversion.
  static constexpr int shown(int display, bool odd) {
    return ((display & IndexMask) + (odd && display >= HalfTone)) & IndexMask;
  }
  /// Column plus line is odd, at a half-pixel position of a line.
  static constexpr bool is_odd(int x2, int y) { return (x2 >> 1 ^ y) & 1; }
  /// The pixel, r * 16 + g * 4 + b; what is not active and the syncs do not matter.
  static int colour(const inputs& in, const knobs& k);
  /// r * 16 + g * 4 + b of the pins.
  static constexpr int colour_of_pins(int uo) {
    const auto component = [uo](int high, int low) {
      return (uo >> high & 1) << 1 | (uo >> low & 1);
    };
    return component(0, 4) << 4 | component(1, 5) << 2 | component(2, 6);
  }
  /// The pins.
  static int uo(const inputs& in, const knobs& k);
};

/// Pins of pixel_output.
class pixel_output_pins : public sc_core::sc_module {
 public:
  // Interval on offer
  in_port<2> hit_face_i{"hit_face_i"};    // axis of the wall
  in_port<3> ray_signs_i{"ray_signs_i"};  // ray signs, 1: negative
  in_port<10> y_i{"y_i"};                 // bit 0: odd line
  in_port<1> shading_b_i{"shading_b_i"};
  in_port<1> starving_i{"starving_i"};
  out_port<2> value_o{"value_o"};
  out_port<1> half_o{"half_o", OfKnob};  // checkered: half a tone more
  // Pixel on show
  in_port<2> display_i{"display_i"};  // colour index
  in_port<1> display_half_i{"display_half_i", OfKnob};
  in_port<11> x2_i{"x2_i", OfKnob};  // signed, half pixels
  in_port<1> lock_i{"lock_i"};
  axes_in<DrPortBits> dr2_i{"dr2", "_i"};  // signed
  in_port<1> inverse_i{"inverse_i"};
  in_port<2> palette_i{"palette_i"};            // 0..2: the chip's; TablePalette:
  in_port<ColoursBits> colours_i{"colours_i"};  // four colours r * 16 + g * 4 + b, the first lowest
  in_port<1> active_i{"active_i"};
  in_port<1> hsync_ni{"hsync_ni"};
  in_port<1> vsync_ni{"vsync_ni"};
  out_port<8> uo_o{"uo_o"};  // {hsync, B0, G0, R0, vsync, B1, G1, R1}

  explicit pixel_output_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of pixel_output: its core behind the pins.
class pixel_output : public pixel_output_pins {
 public:
  using pins = pixel_output_pins;
  static constexpr const char* unit_name = "pixel_output";

  pixel_output(const sc_core::sc_module_name& name, const knobs& k);

 private:
  void offer();
  void show();

  const knobs knobs_;
  sc_core::sc_event_or_list lock_events_;
};

}  // namespace racebeam
