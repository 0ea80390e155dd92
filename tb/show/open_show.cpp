// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/open_show.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "tb/base/content_hash.h"
#include "tb/base/counted.h"
#include "tb/base/nearest.h"
#include "tb/scene/scene_reader.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* BuiltIn = "demo";
constexpr const char* Extension = ".toml";

// Names that were perhaps meant: the built-in demo, and the scene files beside `file` and in
// scenes.
std::vector<std::string> known_scenes(const fs::path& file) {
  std::vector<std::string> known = {BuiltIn};
  for (const fs::path& folder : {file.parent_path(), fs::path("scenes")}) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
      if (entry.path().extension() == Extension)
        known.push_back((folder / entry.path().filename()).string());
  }
  std::sort(known.begin() + 1, known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  return known;
}

SceneResult load(const std::string& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw unknown_name("scene", file, known_scenes(file));
  SceneResult result = read_scene_file(file);
  if (result.faults.none()) return result;
  std::fputs(result.faults.text(file).c_str(), stderr);
  throw UsageError(counted(result.faults.count(), "fault") + " in " + file);
}

}  // namespace

SceneFile load_scene(const std::string& file, std::string* warnings) {
  std::error_code error;
  if (file == BuiltIn && !fs::exists(file, error))
    throw UsageError(
        "demo is built into the chip and no file; its rooms and its flight as a scene file: "
        "scenes/demo.toml");
  SceneResult result = load(file);
  if (warnings) *warnings = result.faults.warnings(file);
  return std::move(result.scene);
}

Show open_show(const std::string& scene) {
  if (scene == BuiltIn) return {};
  SceneResult result = load(scene);
  return {std::move(result.scene), content_hash(result.text)};
}

}  // namespace racebeam
