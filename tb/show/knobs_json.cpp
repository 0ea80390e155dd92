// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/knobs_json.h"

#include <nlohmann/json.hpp>

namespace racebeam {

using Json = nlohmann::ordered_json;

Json knob_json(const knob_info& row, int value) {
  return row.names.empty() ? Json(value) : Json(row.text(value));
}

Json knobs_json(const knobs& k) {
  Json json = Json::object();
  for (const knob_info& row : knob_table())
    if (!row.of_scene) json[row.name] = knob_json(row, k.*row.member);
  return json;
}

}  // namespace racebeam
