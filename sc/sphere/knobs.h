// What an architect may change of the sphere tracer, and the table that names it.
//
// The defaults are the sphere tracer as built here; as_built puts back what the source has.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/base/knob_values.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

enum capture_guard_rule { GuardCounter = 0, GuardApproach = 1, GuardOff = 2 };

struct sphere_knobs {
  int fraction_bits = 12;
  int colour_bits = 5;
  int root_bits_per_clock = 6;
  int divide_clocks = 5;
  int table_entries = 16;
  int write_buffer_depth = 64;
  int write_policy = WritePolicySync;
  int when_full = WhenFullStall;
  int write_each_pass = 0;
  int shadow_rays = 1;
  int plane_shadows = 0;
  int min_weight = 40;
  int wrap_right = 0;
  int wide = 0;
  int clocks_per_pixel = 1;
  int host_clocks_per_word = 2;
  int capture_guard = GuardCounter;
  int as_built = 0;

  sphere_knobs() = default;
  /// Throws std::logic_error if they are another engine's.
  sphere_knobs(const knob_values& values);  // NOLINT(google-explicit-constructor)
  operator knob_values() const;             // NOLINT(google-explicit-constructor)

  /// The clocks of ROOT: the tracer sees the root in the last of them.
  int root_clocks() const { return 3 + (22 + root_bits_per_clock - 1) / root_bits_per_clock; }
  /// Columns and rows of the picture.
  int columns(bool narrow) const { return narrow ? 320 : wide ? 640 : 512; }
  static int rows(bool narrow) { return narrow ? 240 : 480; }
  /// Those of the frame store.
  store_knobs store() const {
    store_knobs s;
    s.write_buffer_depth = write_buffer_depth;
    s.write_policy = write_policy;
    s.when_full = when_full;
    s.wrap_right = wrap_right;
    s.colour_bits = colour_bits;
    s.picture_width = wide ? 640 : 512;
    return s;
  }
  /// The same with what as_built stands for in the knobs of its own.
  sphere_knobs resolved() const {
    sphere_knobs k = *this;
    if (as_built) {
      k.write_each_pass = 1;
      k.when_full = WhenFullDrop;
      k.table_entries = 5;
    }
    return k;
  }
};

/// Whether all knobs are equal: every row of the table.
bool operator==(const sphere_knobs& a, const sphere_knobs& b);
inline bool operator!=(const sphere_knobs& a, const sphere_knobs& b) { return !(a == b); }

using sphere_knob_info = knob_of<sphere_knobs>;

/// All knobs: a member without a row does not compile.
const std::vector<sphere_knob_info>& sphere_knob_table();
/// The same without their places.
const std::vector<knob_row>& sphere_knob_rows();

}  // namespace racebeam
