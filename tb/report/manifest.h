// manifest.json: how the pictures in a folder were made, schema "racebeam-manifest" version 1.
//
// Several runs with the same settings may add frames to one folder: "command", "first_frame",
// "every" (0: frames of a list), "frames_wanted", "frames_rendered" and "complete" tell of the last
// of them; "frames", "files" and "earlier_commands" of all.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sc/base/knob_values.h"

namespace racebeam {

/// What stands in a unit's place.
struct ManifestUnit {
  std::string implementation;  ///< "rtl", "lockstep" beside the model, "gates:osu018" ...
  std::map<std::string, std::string> files;  ///< of the RTL, with a checksum of each
};

struct Manifest {
  std::string scene;       ///< or the folder of a project
  std::string scene_hash;  ///< of what was rendered
  std::string level;
  std::optional<knob_values> k;                 ///< of this project's chip
  std::map<std::string, ManifestUnit> units;    ///< those that are not models
  std::map<std::string, std::string> inputs;    ///< pins of a project's chip
  std::map<std::string, std::string> channels;  ///< between units: what stalls or delays each
  std::vector<std::string> command;             ///< command line, program name first
  int first_frame = 0, every = 1;
  int frames_wanted = 0, frames_rendered = 0;
  std::set<int> frames;
  std::vector<std::string> files;  ///< seen from the folder, without the manifest
  std::vector<std::vector<std::string>> earlier_commands;

  /// What decides how a frame looks: runs into one folder must agree in it.
  nlohmann::ordered_json settings() const;
  /// The whole document; the program's version is added.
  std::string text() const;

  /// Where `old`, the text of another manifest, has other settings: "knobs.dr_bits: 10, now 9" for
  /// each; empty if they agree. Throws UsageError if it is no manifest.
  std::vector<std::string> differences(const std::string& old) const;
  /// Adds frames, files and commands of `old`, which has the same settings.
  void add_earlier(const std::string& old);
};

}  // namespace racebeam
