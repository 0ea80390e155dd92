// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/knobs.h"

#include <algorithm>
#include <iterator>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

/// As knob_info, with the member where it is read best.
struct table_row {
  const char* name;
  int knobs::*member;
  int min, max;
  std::vector<std::string> names;
  const char *unit, *meaning, *source;
  bool of_scene = false;
  const char* model_of = "";

  knob_info info() const {
    return {{name, min, max, names, unit, meaning, source, of_scene, model_of}, member};
  }
};

std::vector<knob_info> infos_of(const table_row* begin, const table_row* end) {
  std::vector<knob_info> infos;
  for (const table_row* row = begin; row != end; ++row) infos.push_back(row->info());
  return infos;
}

}  // namespace

const std::vector<knob_info>& knob_table() {
  static const table_row rows[] = {
      {"interval_stack_depth",
       &knobs::interval_stack_depth,
       1,
       64,
       {},
       "entries",
       "interval ring stack; an overwritten entry costs a restart",
       "contract 10.1"},
      {"face_stack_depth",
       &knobs::face_stack_depth,
       2,
       15,
       {},
       "entries",
       "face-axis stack; one entry for each room entered",
       "contract 10.2"},
      {"max_room_depth",
       &knobs::max_room_depth,
       1,
       14,
       {},
       "rooms",
       "depth at which the next face is a wall; face_stack_depth - 1 if that is less",
       "contract 11.5"},
      {"fifo_entries",
       &knobs::fifo_entries,
       3,
       64,
       {},
       "entries",
       "interval FIFO: head, shift register and tail",
       "contract 14"},
      {"fifo_short_length_bits",
       &knobs::fifo_short_length_bits,
       3,
       10,
       {},
       "bits",
       "length bits of the shift register and tail",
       "contract 14"},
      {"hurry_threshold",
       &knobs::hurry_threshold,
       -1,
       639,
       {},
       "pixels",
       "a starved beam gives up intervals up to one pixel longer; -1: never",
       "contract 9.3"},
      {"dr_bits",
       &knobs::dr_bits,
       8,
       13,
       {},
       "bits",
       "width of each ray direction element",
       "contract 8"},
      {"corner_bits",
       &knobs::corner_bits,
       10,
       16,
       {},
       "bits",
       "width of each corner coordinate; fewer see less far; a scene file brings its own",
       "contract 11.1"},
      {"corner_factor_bits",
       &knobs::corner_factor_bits,
       6,
       16,
       {},
       "bits",
       "corner factor of the two multipliers, after the shift",
       "contract 11.3"},
      {"partial_products_cut",
       &knobs::partial_products_cut,
       0,
       8,
       {},
       "bits",
       "partial products below 2^cut are dropped",
       "contract 11.3"},
      {"bisection",
       &knobs::bisection,
       0,
       2,
       {"pow2", "midpoint", "floor"},
       "",
       "bisection point: closest power of two, the middle, or the power of two below",
       "contract 9.5"},
      {"stepping",
       &knobs::stepping,
       0,
       2,
       {"jumper", "fraction", "fraction_dr2"},
       "",
       "dr steps without stored fraction bits, with them, or with them in dr2 alone",
       "contract 8"},
      {"interlace",
       &knobs::interlace,
       0,
       1,
       {"off", "on"},
       "",
       "odd lines show the previous camera position (pin no_interlace)",
       "contract 5.4"},
      {"dithering",
       &knobs::dithering,
       0,
       2,
       {"off", "on", "checkered"},
       "",
       "shading B alternates between lines, or, behind the FIFO, between pixels",
       "contract 15.1"},
      {"clocks_per_pixel",
       &knobs::clocks_per_pixel,
       1,
       8,
       {},
       "clocks",
       "clocks of 1/25.2 MHz divided by this; sound needs 2",
       "contract 6"},
      {"skip_shared_edges",
       &knobs::skip_shared_edges,
       0,
       2,
       {"off", "on", "table"},
       "",
       "no decision for a portal edge on the room's face, found by comparing or in the scene",
       "article \"Pseudocode\""},
      {"speed",
       &knobs::speed,
       0,
       7,
       {},
       "",
       "input pins ui[2:0]: some pixels take one clock, sound changes pitch",
       "contract 5.6"},
      {"head_start",
       &knobs::head_start,
       0,
       320,
       {},
       "clocks",
       "the tracer starts a line so much later: what it has before the first pixel shrinks",
       "article \"Camera view calculations\""},
      {"stepping_fraction_bits",
       &knobs::stepping_fraction_bits,
       0,
       DdrFractionBits,
       {},
       "bits",
       "fraction bits that stepping = fraction stores; 0 is jumper, 9 exact",
       "article \"Stepping the dr vector\""},
      {"ddr_fraction_bits",
       &knobs::ddr_fraction_bits,
       0,
       DdrFractionBits,
       {},
       "bits",
       "fraction bits of the ray's change per pixel; the others are dropped",
       "article \"Stepping the dr vector\""},
      {"corner_rounding",
       &knobs::corner_rounding,
       0,
       1,
       {"off", "on"},
       "",
       "the corner factors are rounded, not cut, where they are shifted",
       "contract 11.3"},
      {"fifo_merge",
       &knobs::fifo_merge,
       0,
       1,
       {"off", "on"},
       "",
       "the FIFO's newest entry takes in intervals of its own colour",
       "contract 14"},
      {"camera_cosine",
       &knobs::camera_cosine,
       0,
       1,
       {"parabola", "exact"},
       "",
       "sines and cosines of the camera's angles; exact ones have no RTL",
       "contract 7.1",
       false,
       "camera_unit"},
      {"navigator_bits",
       &knobs::navigator_bits,
       1,
       NavigatorPortBits,
       {},
       "bits",
       "width of each stored camera coordinate; as its path needs",
       "docs/scenes.md",
       true},
      {"free_flight",
       &knobs::free_flight,
       0,
       1,
       {"off", "on"},
       "",
       "all bits of x, y and room are stored: for flights in any direction",
       "docs/scenes.md",
       true},
      {"portals_per_face",
       &knobs::portals_per_face,
       1,
       MaxPortals,
       {},
       "portals",
       "most portals in one face of a room",
       "docs/scenes.md",
       true},
  };
  static_assert(std::size(rows) * sizeof(int) == sizeof(knobs), "a knob has no row");
  static const std::vector<knob_info> table = infos_of(std::begin(rows), std::end(rows));
  return table;
}

const std::vector<knob_row>& knob_rows() {
  static const std::vector<knob_row> rows = rows_of(knob_table());
  return rows;
}

knobs::knobs(const knob_values& values) { put_values(knob_table(), knob_rows(), values, *this); }
knobs::operator knob_values() const { return values_of(knob_table(), knob_rows(), *this); }

bool operator==(const knobs& a, const knobs& b) {
  const auto& rows = knob_table();
  return std::all_of(rows.begin(), rows.end(),
                     [&](const knob_info& row) { return a.*row.member == b.*row.member; });
}

}  // namespace racebeam
