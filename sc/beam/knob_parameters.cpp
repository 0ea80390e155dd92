// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/knob_parameters.h"

#include <cctype>
#include <string>

namespace racebeam {

namespace {

// interval_stack_depth -> IntervalStackDepth
std::string parameter_name(const std::string& knob) {
  std::string name;
  bool capital = true;
  for (const char c : knob) {
    if (c != '_') name += capital ? static_cast<char>(std::toupper(c)) : c;
    capital = c == '_';
  }
  return name;
}

}  // namespace

knobs without_pins(knobs k) {
  k.speed = knobs().speed;
  k.interlace = knobs().interlace;
  return k;
}

std::vector<rtl_parameter> knob_parameters(const knobs& k) {
  std::vector<rtl_parameter> all;
  for (const knob_info& row : knob_table())
    all.push_back({parameter_name(row.name), k.*row.member, "the knob " + std::string(row.name),
                   k.*row.member == knobs().*row.member ? "" : row.model_of});
  return all;
}

}  // namespace racebeam
