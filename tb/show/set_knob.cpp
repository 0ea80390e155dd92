// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/set_knob.h"

#include <algorithm>
#include <charconv>

#include "tb/base/console.h"
#include "tb/base/nearest.h"

namespace racebeam {

namespace {

const knob_info& find_knob(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& row : knob_table()) {
    if (row.name == name && row.of_scene)
      throw UsageError("knob " + name + " is not for --set: the scene file sets it (" +
                       row.meaning + ")");
    if (row.name == name) return row;
    if (!row.of_scene) known.push_back(row.name);
  }
  throw unknown_name("knob", name, known);
}

}  // namespace

void set_knob(knobs& k, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos)
    throw UsageError("'" + assignment + "' is not of the form knob=value");
  const knob_info& row = find_knob(assignment.substr(0, equals));
  const std::string text = assignment.substr(equals + 1);
  const auto named = std::find(row.names.begin(), row.names.end(), text);
  int value = row.min - 1;
  if (named != row.names.end()) {
    value = row.min + static_cast<int>(named - row.names.begin());
  } else if (row.names.empty()) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size())
      throw UsageError("knob " + std::string(row.name) + " = '" + text +
                       "' is not a whole number; it takes " + row.range());
    if (error != std::errc()) value = row.min - 1;
  }
  if (value < row.min || value > row.max)
    throw UsageError("knob " + std::string(row.name) + " = '" + text +
                     "' is out of range; it takes " + row.range() +
                     (*row.unit ? std::string(" ") + row.unit : ""));
  k.*row.member = value;
}

void set_knobs(knobs& k, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) set_knob(k, assignment);
  const int counts = k.room_depth_limit();
  if (counts != k.max_room_depth)
    tell("max_room_depth=" + std::to_string(k.max_room_depth) + " counts as " +
         std::to_string(counts) + ": a room takes an entry of face_stack_depth=" +
         std::to_string(k.face_stack_depth) + ", and one is not for rooms");
  k.max_room_depth = counts;
}

std::string knobs_text(const knobs& k) {
  const knobs chip;
  std::string text;
  for (const auto& row : knob_table())
    if (!row.of_scene && k.*row.member != chip.*row.member)
      text += (text.empty() ? "" : ", ") + std::string(row.name) + "=" + row.text(k.*row.member);
  return text.empty() ? "default" : text;
}

}  // namespace racebeam
