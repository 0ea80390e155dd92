// Behaviour of block_spheres (block_spheres.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/block/knobs.h"
#include "sc/block/numbers.h"

namespace racebeam {

/// A sphere as a core has it.
struct block_sphere {
  vec3 pose{};  // from the centre to the eye
  int rv = 0;   // radius2 - pose^2
  vec3 centre{};
  int radius = 0, radius2 = 0;
  vec3 colour{};  // 12.20, of one
};

struct block_spheres_core {
  std::array<block_sphere, BlockEntries> rows_q;

  struct inputs {
    bool write;
    int field, index;
    int value, eye_k;
  };

  const block_sphere& row(int group, const block_knobs& k) const {
    return rows_q[group & (entries(k) - 1)];
  }
  void clock(const inputs& in, const block_knobs& k) {
    if (!in.write) return;
    block_sphere& row = rows_q[in.index & (entries(k) - 1)];
    if (in.field <= BlockCentreZ) {
      row.centre[in.field] = in.value;
      row.pose[in.field] = block_difference(in.eye_k, in.value);
    } else if (in.field >= BlockRed && in.field <= BlockBlue) {
      row.colour[in.field - BlockRed] = in.value;
    } else if (in.field == BlockRadius) {
      row.radius = in.value;
    } else if (in.field == BlockRadius2) {
      row.radius2 = in.value;
    } else if (in.field == BlockRv) {
      row.rv = in.value;
    }
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit, const block_knobs& k) const {
    for (int n = 0; n < entries(k); ++n) {
      const block_sphere* r = &rows_q[n];
      visit(element("pose_x_q", n), BlockBits, [r] { return r->pose[0]; });
      visit(element("pose_y_q", n), BlockBits, [r] { return r->pose[1]; });
      visit(element("pose_z_q", n), BlockBits, [r] { return r->pose[2]; });
      visit(element("rv_q", n), BlockBits, [r] { return r->rv; });
      visit(element("centre_x_q", n), BlockBits, [r] { return r->centre[0]; });
      visit(element("centre_y_q", n), BlockBits, [r] { return r->centre[1]; });
      visit(element("centre_z_q", n), BlockBits, [r] { return r->centre[2]; });
      visit(element("radius_q", n), BlockBits, [r] { return r->radius; });
      visit(element("radius2_q", n), BlockBits, [r] { return r->radius2; });
      visit(element("red_q", n), BlockBits, [r] { return r->colour[0]; });
      visit(element("green_q", n), BlockBits, [r] { return r->colour[1]; });
      visit(element("blue_q", n), BlockBits, [r] { return r->colour[2]; });
    }
  }

 private:
  static int entries(const block_knobs& k) { return BlockEntries / k.lanes; }
};

}  // namespace racebeam
