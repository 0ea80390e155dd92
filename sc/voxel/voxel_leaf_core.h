// Behaviour of voxel_leaf (voxel_leaf.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/voxel/numbers.h"
#include "sc/voxel/voxel_world.h"

namespace racebeam {

struct voxel_leaf_core {
  bool active_q = false;
  int phase_q = 0;        // clocks of this sample that are over
  std::uint32_t t_q = 0;  // of this sample
  int samples_q = 0;

  struct inputs {
    bool rst_n, start, at, fetch, stop;
    std::uint32_t t_from, t_to, step;
    vec3 origin, direction;
    std::uint32_t data;
  };
  struct outputs {
    bool read, some, sample, hit, done;
    std::uint32_t address;
    vec3 position;
  };

  static std::uint64_t first(const inputs& in) { return std::uint64_t{in.t_from} + in.step / 2; }

  outputs comb(const inputs& in, const voxel_knobs& k) const {
    outputs o{};
    o.position = voxel_point(in.origin, in.at ? in.t_from : t_q, in.direction);
    o.address = address(o.position, k);
    o.read = in.fetch || (active_q && phase_q == 0);
    o.some = first(in) < in.t_to;
    o.sample = active_q && phase_q == 1 + k.memory_clocks;
    const voxel_column c = unpacked_column(in.data);
    o.hit = o.sample && voxel_solid(c.low, c.middle, c.high, o.position[2]);
    o.done = o.sample && (o.hit || std::uint64_t{t_q} + in.step >= in.t_to);
    return o;
  }

  void clock(const inputs& in, const voxel_knobs& k) {
    const outputs o = comb(in, k);
    if (active_q) ++phase_q;
    if (o.sample) {
      phase_q = 0;
      active_q = !o.done && !in.stop;
      t_q += o.hit ? 0 : in.step;
      samples_q = (samples_q + !o.hit) & low_bits(VoxelSampleBits);
    }
    if (in.start) {
      active_q = o.some;
      phase_q = samples_q = 0;
      t_q = static_cast<std::uint32_t>(first(in));
    }
    if (!in.rst_n) active_q = false;
  }

  /// Of the column at a position.
  static std::uint32_t address(const vec3& position, const voxel_knobs& k) {
    const auto wrapped = [](int value, int size) {
      return static_cast<std::uint32_t>(voxel_wrapped(value >> VoxelPositionFraction, size));
    };
    return wrapped(position[1], k.size_y) * static_cast<std::uint32_t>(k.size_x) +
           wrapped(position[0], k.size_x);
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("active_q", 1, [this] { return active_q; });
    visit("phase_q", 4, [this] { return phase_q; });
    visit("t_q", VoxelTBits, [this] { return t_q; });
    visit("samples_q", VoxelSampleBits, [this] { return samples_q; });
  }
};

}  // namespace racebeam
