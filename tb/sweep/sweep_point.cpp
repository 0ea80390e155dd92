// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_point.h"

#include <algorithm>
#include <map>

namespace racebeam {

const knob_info* swept_knob(const std::string& name) {
  for (const knob_info& row : knob_table())
    if (!row.of_scene && row.name == name) return &row;
  return nullptr;
}

std::vector<std::string> swept_knobs() {
  std::vector<std::string> names;
  for (const knob_info& row : knob_table())
    if (!row.of_scene) names.emplace_back(row.name);
  return names;
}

void SweepPoint::set_knob(const knob_info& row, int value) {
  k.*row.member = value;
  const auto at = std::lower_bound(set.begin(), set.end(), &row);
  if (at == set.end() || *at != &row) set.insert(at, &row);
}

bool operator==(const SweepPoint& a, const SweepPoint& b) {
  return a.name == b.name && a.k == b.k && a.set == b.set;
}

knobs knobs_on(const SweepPoint& point, const knobs& standard) {
  knobs k = standard;
  for (const knob_info* row : point.set) k.*row->member = point.k.*row->member;
  k.max_room_depth = k.room_depth_limit();
  return k;
}

std::string point_text(const knobs& k) {
  std::map<std::string, std::string> lines;
  for (const knob_info& row : knob_table()) lines[row.name] = row.text(k.*row.member);
  std::string text;
  for (const auto& [name, value] : lines) text += name + "=" + value + "\n";
  return text;
}

}  // namespace racebeam
