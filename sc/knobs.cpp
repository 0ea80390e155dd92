// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/knobs.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace racebeam {

namespace {

// Edits (insert, delete, replace) that turn `a` into `b`.
int edit_distance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

const knob_info& find_knob(const std::string& name) {
  const auto& table = knob_table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const knob_info& row) { return row.name == name; });
  if (found != table.end()) return *found;
  const auto nearest =
      std::min_element(table.begin(), table.end(), [&](const knob_info& a, const knob_info& b) {
        return edit_distance(name, a.name) < edit_distance(name, b.name);
      });
  throw knob_error("unknown knob '" + name + "'; the nearest is '" + nearest->name +
                   "' (`racebeam knobs` lists all)");
}

}  // namespace

std::string knob_info::text(int value) const {
  return names.empty() ? std::to_string(value) : names.at(value - min);
}

std::string knob_info::range() const {
  if (names.empty()) return std::to_string(min) + ".." + std::to_string(max);
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

const std::vector<knob_info>& knob_table() {
  static const std::vector<knob_info> table = {
      {"interval_stack_depth",
       &knobs::interval_stack_depth,
       1,
       64,
       {},
       "entries",
       "interval ring stack; an overwritten entry costs a restart",
       "S0-61, contract 10.1"},
      {"face_stack_depth",
       &knobs::face_stack_depth,
       2,
       15,
       {},
       "entries",
       "face-axis stack; one entry for each room entered",
       "S0-60, contract 10.2"},
      {"max_room_depth",
       &knobs::max_room_depth,
       1,
       14,
       {},
       "rooms",
       "depth at which the next face counts as a wall",
       "contract 11.5"},
      {"fifo_entries",
       &knobs::fifo_entries,
       3,
       64,
       {},
       "entries",
       "interval FIFO: head, shift register and tail",
       "S0-51, contract 14"},
      {"fifo_short_length_bits",
       &knobs::fifo_short_length_bits,
       3,
       10,
       {},
       "bits",
       "length bits of the shift register and tail",
       "S0-83, contract 14"},
      {"hurry_threshold",
       &knobs::hurry_threshold,
       -1,
       639,
       {},
       "pixels",
       "a starved beam gives up intervals up to one pixel longer; -1: never",
       "S0-54, contract 9.3"},
      {"dr_bits",
       &knobs::dr_bits,
       8,
       13,
       {},
       "bits",
       "width of each ray direction element",
       "S0-87, contract 8"},
      {"corner_bits",
       &knobs::corner_bits,
       10,
       12,
       {},
       "bits",
       "width of each corner coordinate; fewer see less far",
       "S0-91, contract 11.1"},
      {"corner_factor_bits",
       &knobs::corner_factor_bits,
       6,
       12,
       {},
       "bits",
       "corner factor of the two multipliers, after the shift",
       "S0-91, contract 11.3"},
      {"partial_products_cut",
       &knobs::partial_products_cut,
       0,
       8,
       {},
       "bits",
       "partial products below 2^cut are dropped",
       "S0-95, contract 11.3"},
      {"bisection",
       &knobs::bisection,
       0,
       1,
       {"pow2", "midpoint"},
       "",
       "bisection point: closest power of two, or the middle",
       "S0-65, contract 9.5"},
      {"stepping",
       &knobs::stepping,
       0,
       1,
       {"jumper", "fraction"},
       "",
       "dr steps without stored fraction bits, or with 9 of them",
       "S0-106, contract 8"},
      {"interlace",
       &knobs::interlace,
       0,
       1,
       {"off", "on"},
       "",
       "odd lines show the previous camera position (pin no_interlace)",
       "S0-93, contract 5.4"},
      {"dithering",
       &knobs::dithering,
       0,
       1,
       {"off", "on"},
       "",
       "shading B alternates between lines",
       "S0-85, contract 15.1"},
      {"clocks_per_pixel",
       &knobs::clocks_per_pixel,
       1,
       8,
       {},
       "clocks",
       "clocks of 1/25.2 MHz divided by this; sound needs 2",
       "S0-08, contract 6"},
      {"skip_shared_edges",
       &knobs::skip_shared_edges,
       0,
       1,
       {"off", "on"},
       "",
       "no decision for a portal edge that coincides with the room's face",
       "S0-35"},
      {"speed",
       &knobs::speed,
       0,
       7,
       {},
       "",
       "input pins ui[2:0]: some pixels take one clock, sound changes pitch",
       "contract 5.6"},
  };
  return table;
}

void set_knob(knobs& k, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos)
    throw knob_error("'" + assignment + "' is not of the form knob=value");
  const knob_info& row = find_knob(assignment.substr(0, equals));
  const std::string text = assignment.substr(equals + 1);
  const auto named = std::find(row.names.begin(), row.names.end(), text);
  int value = row.min - 1;
  if (named != row.names.end()) {
    value = row.min + static_cast<int>(named - row.names.begin());
  } else if (row.names.empty()) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) value = row.min - 1;
  }
  if (value < row.min || value > row.max)
    throw knob_error("knob " + std::string(row.name) + " = '" + text +
                     "' is out of range; it takes " + row.range() +
                     (*row.unit ? std::string(" ") + row.unit : ""));
  k.*row.member = value;
}

}  // namespace racebeam
