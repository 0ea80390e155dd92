// Behaviour of sphere_shader (sphere_shader.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "sc/base/probe.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_scene.h"

namespace racebeam {

/// The last sub-ray of a pixel.
constexpr int last_sub(int alias) { return alias == 0 ? 0 : alias == 1 ? 4 : 8; }

struct sphere_shader_core {
  static constexpr int FullWeight = 0xfff, FullChannel = 0x3ff;
  using channels = std::array<int, 3>;

  channels colour_q{}, sum_q{};
  int weight_q = FullWeight;
  bool light_q = false;
  std::array<channels, SubRays> buffer_q{};

  struct inputs {
    bool rst_n;
    int op;
    sphere_colour base;
    bool dark;
    int fraction, reflect;
    bool direct;
    int sub, alias;
  };

  int weight(int reflect) const { return weight_q * reflect >> UnitBits; }
  std::uint64_t word(int sub, int alias, const sphere_knobs& k) const {
    std::uint64_t word = light_q;
    for (int c = 0; c < 3; ++c) {
      int all = 0;
      for (int n = 0; n <= std::min(sub, SubRays - 1); ++n)
        all += (n == sub ? sum_q[c] : buffer_q[n][c]) >> shift(n, alias);
      const int channel = all & FullChannel;
      word =
          word << k.colour_bits | static_cast<unsigned>(channel >> (ChannelBits - k.colour_bits));
    }
    return word;
  }
  void clock(const inputs& in) {
    if (!in.rst_n) {
      *this = {};
      return;
    }
    switch (in.op) {
      case ShadeStart: restart(true); break;
      case ShadeLight:
        colour_q.fill(FullChannel);
        if (in.direct && in.sub == 0) light_q = true;
        break;
      case ShadeHalf:
      case ShadeLit:
      case ShadePlain:
        for (int c = 0; c < 3; ++c) {
          const int full = in.base[c] << (ChannelBits - SphereColourBits) >> (in.dark ? 2 : 0);
          colour_q[c] = in.op == ShadePlain  ? full
                        : in.op == ShadeHalf ? full >> 1
                                             : (in.fraction * full >> UnitBits) + (full >> 1);
        }
        break;
      case ShadeAdd:
        for (int c = 0; c < 3; ++c)
          sum_q[c] = std::min(sum_q[c] + (colour_q[c] * weight_q >> UnitBits), FullChannel);
        weight_q = weight(in.reflect);
        break;
      case ShadeStore:
        if (in.sub < SubRays) buffer_q[in.sub] = sum_q;
        restart(in.sub == last_sub(in.alias));
        break;
      default: break;
    }
  }

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit) const {
    static constexpr const char* channel[] = {"red", "green", "blue"};
    for (int c = 0; c < 3; ++c) {
      visit(std::string("colour_") + channel[c] + "_q", ChannelBits + 1,
            [this, c] { return colour_q[c]; });
      visit(std::string("sum_") + channel[c] + "_q", ChannelBits, [this, c] { return sum_q[c]; });
    }
    visit("weight_q", UnitBits, [this] { return weight_q; });
    visit("light_q", 1, [this] { return light_q; });
    for (int n = 0; n < SubRays; ++n)
      visit(element("buffer_q", n), 3 * ChannelBits, [this, n] {
        return (buffer_q[n][0] << ChannelBits | buffer_q[n][1]) << ChannelBits | buffer_q[n][2];
      });
  }

 private:
  static int shift(int sub, int alias) {
    if (alias == 0) return 0;
    if (alias == 1) return sub == 0 ? 1 : 3;
    return sub == 0 ? 2 : sub <= 4 ? 4 : 3;
  }
  void restart(bool pixel) {
    sum_q = {};
    weight_q = FullWeight;
    if (pixel) light_q = false;
  }
};

}  // namespace racebeam
