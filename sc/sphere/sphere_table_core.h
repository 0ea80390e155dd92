// Behaviour of sphere_table (sphere_table.h) and plane_table (plane_table.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sc/base/probe.h"
#include "sc/sphere/knobs.h"
#include "sc/sphere/numbers.h"
#include "sc/sphere/sphere_scene.h"

namespace racebeam {

struct sphere_table_core {
  std::array<sphere_row, SphereEntries> rows_q;
  int last_q = 0;

  struct inputs {
    bool write;
    int index, last;
    sphere_row row;
  };
  const sphere_row& row(int index) const { return rows_q[index]; }
  void clock(const inputs& in, const sphere_knobs& k) {
    if (!in.write || in.index >= k.table_entries) return;
    rows_q[in.index] = in.row;
    rows_q[in.index].centre = masked(in.row.centre, kept_bits(k.fraction_bits));
    last_q = in.last;
  }

  /// Calls visit(name, bits, read) for each register; the RTL has an entry in one.
  template <class Visit>
  void each_register(Visit&& visit, const sphere_knobs& k) const {
    visit("last_q", SphereIndexBits, [this] { return last_q; });
    for (int n = 0; n < k.table_entries; ++n) {
      const sphere_row* r = &rows_q[n];
      visit(element("centre_x_q", n), SphereBits, [r] { return r->centre[0]; });
      visit(element("centre_y_q", n), SphereBits, [r] { return r->centre[1]; });
      visit(element("centre_z_q", n), SphereBits, [r] { return r->centre[2]; });
      visit(element("radius_q", n), UnitBits, [r] { return r->radius; });
      visit(element("radius2_q", n), SphereBits, [r] { return r->radius2; });
      visit(element("inverse_q", n), UnitBits, [r] { return r->inverse; });
      visit(element("reflect_q", n), UnitBits, [r] { return r->reflect; });
      visit(element("red_q", n), SphereColourBits, [r] { return r->colour[0]; });
      visit(element("green_q", n), SphereColourBits, [r] { return r->colour[1]; });
      visit(element("blue_q", n), SphereColourBits, [r] { return r->colour[2]; });
      visit(element("is_light_q", n), 1, [r] { return r->is_light; });
    }
  }
};

struct plane_table_core {
  static const plane_row& row(const std::vector<plane_row>& planes, int index) {
    static const plane_row none;
    return index < static_cast<int>(planes.size()) ? planes[index] : none;
  }
  static int last(const std::vector<plane_row>& planes) {
    return planes.empty() ? 0 : static_cast<int>(planes.size()) - 1;
  }
};

}  // namespace racebeam
