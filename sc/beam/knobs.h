// What an architect may change, and the table that names it.
//
// The table drives the command line, its help, the checks, the statistics file and the manifest.
// The defaults are the taped-out chip. Source: docs/explore.md, contract section 3.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/base/knob_values.h"

namespace racebeam {

enum bisection_rule { BisectionPow2 = 0, BisectionMidpoint = 1, BisectionFloor = 2 };
enum dithering_rule { DitheringOff = 0, DitheringOn = 1, DitheringCheckered = 2 };
enum shared_edges_rule { SharedEdgesOff = 0, SharedEdgesOn = 1, SharedEdgesTable = 2 };
enum cosine_rule { CosineParabola = 0, CosineExact = 1 };
enum stepping_rule { SteppingJumper = 0, SteppingFraction = 1, SteppingFractionDr2 = 2 };

struct knobs {
  int interval_stack_depth = 4;
  int face_stack_depth = 9;
  int max_room_depth = 8;
  int fifo_entries = 10;
  int fifo_short_length_bits = 6;
  int hurry_threshold = 32;
  int dr_bits = 10;
  int corner_bits = 12;
  int corner_factor_bits = 8;
  int partial_products_cut = 5;
  int bisection = BisectionPow2;
  int stepping = SteppingJumper;
  int interlace = 1;
  int dithering = DitheringOn;
  int clocks_per_pixel = 2;
  int skip_shared_edges = SharedEdgesOff;
  int speed = 0;
  int head_start = 0;
  int stepping_fraction_bits = 9;
  int ddr_fraction_bits = 9;
  int corner_rounding = 0;
  int fifo_merge = 1;
  int camera_cosine = CosineParabola;

  // Only a scene file sets these (scene_program.h).
  int navigator_bits = 9;
  int free_flight = 0;
  int portals_per_face = 1;

  knobs() = default;
  /// Throws std::logic_error if they are another engine's.
  knobs(const knob_values& values);  // NOLINT(google-explicit-constructor)
  operator knob_values() const;      // NOLINT(google-explicit-constructor)

  /// Fraction bits of dr2, and of dr1.
  int dr2_fraction() const { return stepping == SteppingJumper ? 0 : stepping_fraction_bits; }
  int dr1_fraction() const { return stepping == SteppingFraction ? stepping_fraction_bits : 0; }
  /// Largest depth at which a room is entered: the face stack must hold one face per room.
  int room_depth_limit() const {
    return max_room_depth < face_stack_depth ? max_room_depth : face_stack_depth - 1;
  }
};

/// Whether all knobs are equal: every row of the table.
bool operator==(const knobs& a, const knobs& b);
inline bool operator!=(const knobs& a, const knobs& b) { return !(a == b); }

/// A row of the table. The struct and its knob_values are the same knobs, and become each other
/// without a word.
using knob_info = knob_of<knobs>;

/// All knobs: a member without a row does not compile. Those of scene files come last.
const std::vector<knob_info>& knob_table();
/// The same for what works with any engine.
const std::vector<knob_row>& knob_rows();

}  // namespace racebeam
