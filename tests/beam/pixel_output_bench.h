// pixel_output alone on the bench.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "sc/beam/pixel_output.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {

/// 15.2: red, green, blue by palette and index.
inline constexpr int Colours[3][4][3] = {
    {{0, 0, 0}, {0, 0, 1}, {0, 1, 2}, {2, 2, 3}},
    {{0, 0, 2}, {0, 1, 2}, {1, 2, 2}, {1, 3, 2}},
    {{1, 0, 1}, {2, 1, 1}, {3, 2, 1}, {3, 3, 2}},
};

/// Section 4: the output byte of a colour (bits hsync B0 G0 R0 vsync B1 G1 R1).
inline int byte_of(const int (&rgb)[3], int hsync, int vsync) {
  int byte = hsync << 7 | vsync << 3;
  for (int c = 0; c < 3; ++c) byte |= (rgb[c] & 1) << (4 + c) | (rgb[c] >> 1) << c;
  return byte;
}

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const knobs& k = {}) : unit("dut", k), bench(unit) {
    bench["active_i"].drive(1);
    bench["hsync_ni"].drive(1);
    bench["vsync_ni"].drive(1);
  }
  int uo(int display, int palette) {
    bench["display_i"].drive(display);
    bench["palette_i"].drive(palette);
    bench.settle();
    return bench["uo_o"].value();
  }
  /// The index on show, read back from palette 2, in which the four colours differ.
  int index() {
    bench.settle();
    const int byte = uo(bench["display_i"].value(), 2);
    for (int i = 0; i < 4; ++i)
      if (byte == byte_of(Colours[2][i], 1, 1)) return i;
    return -1;
  }
  int value(int face, int signs, int y, int shading_b, int starving = 0) {
    bench["hit_face_i"].drive(face);
    bench["ray_signs_i"].drive(signs);
    bench["y_i"].drive(y);
    bench["shading_b_i"].drive(shading_b);
    bench["starving_i"].drive(starving);
    bench.settle();
    return bench["value_o"].value();
  }
};

template <class Unit>
class PixelOutputTest : public testing::Test {
 protected:
  Dut<Unit> dut;
};

using Twins = testing::Types<pixel_output, own_rtl<pixel_output>>;

}  // namespace racebeam
