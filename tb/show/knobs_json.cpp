// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/knobs_json.h"

#include <nlohmann/json.hpp>

namespace racebeam {

using Json = nlohmann::ordered_json;

Json knob_json(const knob_row& row, int value) {
  return row.names.empty() ? Json(value) : Json(row.text(value));
}

Json knobs_json(const knob_values& k) {
  Json json = Json::object();
  for (std::size_t n = 0; n < k.rows().size(); ++n)
    if (const knob_row& row = k.rows()[n]; !row.of_scene) json[row.name] = knob_json(row, k[n]);
  return json;
}

}  // namespace racebeam
