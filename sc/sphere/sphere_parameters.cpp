// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_parameters.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "sc/store/store_parameters.h"

namespace racebeam {

namespace {

// root_bits_per_clock -> RootBitsPerClock
std::string parameter_name(const std::string& knob) {
  std::string name;
  bool capital = true;
  for (const char c : knob) {
    if (c != '_') name += capital ? static_cast<char>(std::toupper(c)) : c;
    capital = c == '_';
  }
  return name;
}

void add_digits(std::string& row, int value, int digits) {
  for (int n = digits - 1; n >= 0; --n) row += "0123456789abcdef"[value >> 4 * n & 15];
}

}  // namespace

std::vector<rtl_parameter> sphere_knob_parameters(const sphere_knobs& k) {
  const sphere_knobs now = k.resolved();
  std::vector<rtl_parameter> all = store_parameters(now.store());
  for (const sphere_knob_info& row : sphere_knob_table()) {
    const std::string name = parameter_name(row.name);
    const bool there =
        std::any_of(all.begin(), all.end(), [&](const rtl_parameter& p) { return p.name == name; });
    if (!there) all.push_back({name, now.*row.member, "the knob " + std::string(row.name)});
  }
  return all;
}

std::vector<rtl_parameter> sphere_parameters(const sphere_knobs& k, const sphere_tables& tables) {
  std::vector<rtl_parameter> all = sphere_knob_parameters(k);
  const sphere_start& s = tables.start;
  all.push_back({"OriginX", s.origin[0], "the eye's x"});
  all.push_back({"OriginY", s.origin[1], "the eye's y"});
  all.push_back({"OriginZ", s.origin[2], "the eye's z"});
  all.push_back({"LightX", s.light[0], "the light's x"});
  all.push_back({"LightY", s.light[1], "the light's y"});
  all.push_back({"LightZ", s.light[2], "the light's z"});
  all.push_back({"Screen", s.screen, "the screen"});
  all.push_back({"Planes", static_cast<int>(tables.planes.size()), "the number of planes"});
  return all;
}

std::string plane_file_row(const plane_row& plane) {
  std::string row;
  for (const int n : plane.normal) add_digits(row, n, 6);
  add_digits(row, plane.distance, 6);
  for (const int c : plane.colour) add_digits(row, c, 2);
  add_digits(row, plane.reflect, 3);
  add_digits(row, plane.checker, 1);
  add_digits(row, plane.limited, 1);
  for (const int l : plane.limit) add_digits(row, l, 3);
  return row;
}

}  // namespace racebeam
