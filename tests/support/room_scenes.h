// The project's scenes of box rooms: other engines have scenes, too.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sc/beam/engine.h"
#include "tb/scene/beam_scene.h"
#include "tb/scene/scene_kinds.h"

namespace racebeam {

/// By name: "house", "chip/tunnel".
inline std::vector<std::string> room_scenes() {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(RACEBEAM_SOURCE_DIR) / "scenes";
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const AnySceneResult read = read_any_scene_file(entry.path().string());
    if (!read.scene || &read.scene->engine() == &beam_engine())
      names.push_back(fs::relative(entry.path(), folder).replace_extension().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Without faults; without what the file has for other engines.
inline SceneFile room_scene(const std::string& name) {
  const AnySceneResult read = read_any_scene_file(RACEBEAM_SOURCE_DIR "/scenes/" + name + ".toml");
  EXPECT_TRUE(read.faults.none()) << read.faults.text(name);
  return static_cast<const BeamScene&>(*read.scene).file;
}

}  // namespace racebeam
