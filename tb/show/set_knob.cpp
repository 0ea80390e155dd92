// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/set_knob.h"

#include <algorithm>
#include <charconv>

#include "tb/base/console.h"
#include "tb/base/nearest.h"
#include "tb/scene/engines.h"

namespace racebeam {

namespace {

/// The place of the row.
std::size_t find_knob(const std::vector<knob_row>& rows, const std::string& name) {
  std::vector<std::string> known;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const knob_row& row = rows[n];
    if (row.name == name && row.of_scene)
      throw UsageError("knob " + name + " is not for --set: the scene file sets it (" +
                       row.meaning + ")");
    if (row.name == name) return n;
    if (!row.of_scene) known.push_back(row.name);
  }
  for (const engine* other : engines())
    for (const knob_row& row : other->knobs)
      if (row.name == name)
        throw UsageError("knob " + name + " is one of " + other->name +
                         ", not of the engine that shows this scene; `racebeam knobs --engine " +
                         other->name + "` lists it");
  throw unknown_name("knob", name, known);
}

}  // namespace

void set_knob(knob_values& k, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos)
    throw UsageError("'" + assignment + "' is not of the form knob=value");
  const std::size_t place = find_knob(k.rows(), assignment.substr(0, equals));
  const knob_row& row = k.rows()[place];
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
  k[place] = value;
}

void set_knob(knobs& k, const std::string& assignment) {
  knob_values values = k;
  set_knob(values, assignment);
  k = values;
}

void set_knobs(const engine& built, knob_values& k, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) set_knob(k, assignment);
  if (const std::string told = built.settle(k); !told.empty()) tell(told);
}

std::string knobs_text(const knob_values& k) {
  std::string text;
  for (std::size_t n = 0; n < k.rows().size(); ++n)
    if (const knob_row& row = k.rows()[n]; !row.of_scene && k[n] != row.standard)
      text += (text.empty() ? "" : ", ") + std::string(row.name) + "=" + row.text(k[n]);
  return text.empty() ? "default" : text;
}

}  // namespace racebeam
