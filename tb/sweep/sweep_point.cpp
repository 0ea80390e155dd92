// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_point.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "tb/scene/engines.h"

namespace racebeam {

namespace {

std::size_t place_of(const knob_row& row, const knob_values& k) {
  return static_cast<std::size_t>(&row - k.rows().data());
}

}  // namespace

const knob_row* swept_knob(const engine& of, const std::string& name) {
  for (const knob_row& row : of.knobs)
    if (!row.of_scene && row.name == name) return &row;
  return nullptr;
}

std::vector<std::string> swept_knobs(const engine& of) {
  std::vector<std::string> names;
  for (const knob_row& row : of.knobs)
    if (!row.of_scene) names.emplace_back(row.name);
  return names;
}

int SweepPoint::value_of(const knob_row& row) const { return k[place_of(row, k)]; }

void SweepPoint::set_knob(const knob_row& row, int value) {
  k[place_of(row, k)] = value;
  const auto at = std::lower_bound(set.begin(), set.end(), &row);
  if (at == set.end() || *at != &row) set.insert(at, &row);
}

bool operator==(const SweepPoint& a, const SweepPoint& b) {
  return a.name == b.name && a.k == b.k && a.set == b.set;
}

knob_values knobs_on(const SweepPoint& point, const knob_values& standard) {
  knob_values k = standard;
  for (const knob_row* row : point.set) k[place_of(*row, k)] = point.value_of(*row);
  engine_of(k).settle(k);
  return k;
}

std::string point_text(const knob_values& k) {
  std::vector<const knob_row*> by_name;
  for (const knob_row& row : k.rows()) by_name.push_back(&row);
  std::sort(by_name.begin(), by_name.end(),
            [](const knob_row* a, const knob_row* b) { return std::strcmp(a->name, b->name) < 0; });
  std::string text;
  for (const knob_row* row : by_name)
    (((text += row->name) += '=') += row->text(k[place_of(*row, k)])) += '\n';
  return text;
}

}  // namespace racebeam
