// Pixels of scene four: words and clocks in four modes (design of the sphere tracer).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/sphere/sphere_inputs_core.h"

namespace racebeam {

struct four_pixel {
  int x, y;
  struct {
    std::uint64_t word;
    int clocks;
  } by_mode[4];  // plain; 3 reflections; with planes; with planes, 8x
};

constexpr four_pixel FourPixels[] = {
    {0, 0, {{0x0000, 35}, {0x0000, 35}, {0x0000, 327}, {0x0000, 2943}}},
    {200, 240, {{0x7863, 76}, {0x7863, 109}, {0x7863, 294}, {0x7884, 2702}}},
    {313, 240, {{0x0fe3, 75}, {0x0fe3, 108}, {0x0fe3, 297}, {0x13e4, 2707}}},
    {256, 190, {{0x109f, 77}, {0x109f, 112}, {0x18df, 188}, {0x211f, 2408}}},
    {256, 290, {{0x1084, 75}, {0x1084, 107}, {0x1084, 111}, {0x1084, 2133}}},
    {396, 380, {{0xffff, 44}, {0xffff, 44}, {0xffff, 44}, {0xffff, 396}}},
    {256, 470, {{0x0000, 35}, {0x0000, 35}, {0x318c, 320}, {0x4210, 2922}}},
    {100, 400, {{0x0000, 35}, {0x0000, 35}, {0x1ce9, 330}, {0x1ce9, 2970}}},
    {20, 240, {{0x0000, 35}, {0x0000, 35}, {0x1c00, 319}, {0x1c00, 2934}}},
    {256, 330, {{0x0000, 35}, {0x0000, 35}, {0x7bde, 312}, {0x6739, 2755}}},
};

/// The switches of a mode.
inline void set_mode(sphere_inputs_core& inputs, int mode) {
  inputs.max_reflections_q = mode ? 3 : 0;
  inputs.planes_q = mode >= 2;
  inputs.alias_q = mode == 3 ? 2 : 0;
}

}  // namespace racebeam
