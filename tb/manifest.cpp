// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/manifest.h"

#include <nlohmann/json.hpp>

#include "tb/knobs_json.h"
#include "tb/version.h"

namespace racebeam {

std::string Manifest::text() const {
  const nlohmann::ordered_json json = {
      {"schema", "racebeam-manifest"},
      {"schema_version", 1},
      {"version", program_version()},
      {"scene", scene},
      {"scene_hash", scene_hash},
      {"level", level},
      {"knobs", k ? knobs_json(*k) : nlohmann::ordered_json()},
      {"command", command},
      {"first_frame", first_frame},
      {"every", every},
      {"frames_wanted", frames_wanted},
      {"frames_rendered", frames_rendered},
      {"complete", frames_rendered == frames_wanted},
      {"files", files},
  };
  // File names and arguments need not be UTF-8; JSON must be.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace racebeam
