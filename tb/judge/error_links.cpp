// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/error_links.h"

#include <algorithm>
#include <stdexcept>

namespace racebeam {

namespace {

using Links = std::vector<ErrorLink>;

// The beam, the stack, the multiplier.
const Links Limits = {
    {{"give_up", "a starved beam takes short intervals as they are"},
     [](knobs& k, const knobs&) { k.hurry_threshold = -1; }},
    {{"starved", "the beam overtakes the tracer; a late interval is dark from end to end"},
     [](knobs& k, const knobs&) {
       k.clocks_per_pixel = most(&knobs::clocks_per_pixel);
       k.fifo_entries = most(&knobs::fifo_entries);
       k.fifo_short_length_bits = most(&knobs::fifo_short_length_bits);
       k.fifo_merge = 1;
       k.speed = k.head_start = 0;
     }},
    {{"stack", "the interval stack overflows"},
     [](knobs& k, const knobs&) { k.interval_stack_depth = most(&knobs::interval_stack_depth); }},
    {{"multiplier_cut", "the small partial products are dropped"},
     [](knobs& k, const knobs&) { k.partial_products_cut = 0; }},
    {{"corner_shift", "large corners lose low bits"},
     [](knobs& k, const knobs&) {
       k.corner_factor_bits = most(&knobs::corner_factor_bits);
       k.corner_rounding = 0;
     }},
};

const ErrorLink Residue = {
    {"interlace_residue", "odd lines: what a way back to the root leaves in the corner"}, nullptr};

const ErrorLink RoomDepth = {
    {"room_depth", "rooms that are left out: max_room_depth, face_stack_depth, corner_bits"},
    [](knobs& k, const knobs& standard) {
      k.max_room_depth = most(&knobs::max_room_depth);
      k.face_stack_depth = most(&knobs::face_stack_depth);
      k.corner_bits = standard.corner_bits;
    }};

void to_standard_rays(knobs& k, const knobs& standard) {
  k.dr_bits = standard.dr_bits;
  k.stepping = standard.stepping;
  k.stepping_fraction_bits = standard.stepping_fraction_bits;
  k.ddr_fraction_bits = standard.ddr_fraction_bits;
}

const ErrorLink SameRules = {{"other_knobs", "bisection, skip_shared_edges"},
                             [](knobs& k, const knobs& standard) {
                               k.bisection = standard.bisection;
                               k.skip_shared_edges = standard.skip_shared_edges;
                             }};

Links joined(std::initializer_list<Links> parts) {
  Links all;
  for (const Links& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

int most(int knobs::*member) {
  const auto& rows = knob_table();
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const knob_info& info) { return info.member == member; });
  if (row == rows.end()) throw std::invalid_argument("a knob without a row");
  return row->max;
}

const Links& trace_4_links() {
  static const ErrorLink other_knobs = {
      {"other_knobs",
       "knobs that the tracers do not follow: dr_bits, stepping, ddr_fraction_bits, "
       "skip_shared_edges"},
      [](knobs& k, const knobs& standard) {
        to_standard_rays(k, standard);
        k.skip_shared_edges = standard.skip_shared_edges;
      }};
  static const Links links = joined({Limits, {other_knobs, Residue}});
  return links;
}

const Links& ray_links() {
  static const Links links = {
      {{"ray_steps", "steps along a line drop fractions: stepping, ddr_fraction_bits"},
       [](knobs& k, const knobs&) {
         k.stepping = SteppingFraction;
         k.stepping_fraction_bits = most(&knobs::stepping_fraction_bits);
         k.ddr_fraction_bits = most(&knobs::ddr_fraction_bits);
       }},
      {{"ray_bits", "a ray is rounded to dr_bits; up to the 13 that there may be"},
       [](knobs& k, const knobs&) { k.dr_bits = most(&knobs::dr_bits); }},
  };
  return links;
}

const Links& reference_trace_4_links() {
  static const ErrorLink ray_knobs = {
      {"ray_knobs", "rays other than the chip's: dr_bits, stepping, ddr_fraction_bits"},
      to_standard_rays};
  static const Links links = joined({Limits, {SameRules, ray_knobs, RoomDepth, Residue}});
  return links;
}

const Links& reference_geometry_links() {
  static const Links links = joined({Limits, {SameRules, RoomDepth, Residue}, ray_links()});
  return links;
}

}  // namespace racebeam
