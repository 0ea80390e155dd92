// manifest.json: how the pictures in a folder were made, schema "racebeam-manifest" version 1.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sc/knobs.h"

namespace racebeam {

struct Manifest {
  std::string scene;       ///< or the folder of a project
  std::string scene_hash;  ///< of what was rendered
  std::string level;
  std::optional<knobs> k;            ///< of this project's chip
  std::vector<std::string> command;  ///< command line, program name first
  int first_frame = 0, every = 1;
  int frames_wanted = 0, frames_rendered = 0;
  std::vector<std::string> files;  ///< in the folder, without the manifest

  /// The whole document; the program's version is added.
  std::string text() const;
};

}  // namespace racebeam
