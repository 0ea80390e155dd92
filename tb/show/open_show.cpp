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
#include "tb/base/project_folder.h"
#include "tb/scene/scene_reader.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* BuiltIn = "demo";
constexpr const char* Extension = ".toml";

// Names that were perhaps meant: the built-in demo, the scene files beside `file`, and the
// project's.
std::vector<std::string> known_scenes(const fs::path& file) {
  std::vector<std::string> known = {BuiltIn};
  std::error_code error;
  const fs::path folder = file.parent_path();
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
    if (entry.path().extension() == Extension)
      known.push_back((folder / entry.path().filename()).string());
  std::sort(known.begin() + 1, known.end());
  for (const std::string& name : scene_names())
    if (name != BuiltIn) known.push_back(name);
  return known;
}

SceneResult load(const std::string& scene) {
  const std::string file = scene_path(scene);
  std::error_code error;
  if (!fs::exists(file, error)) throw unknown_name("scene", scene, known_scenes(scene));
  SceneResult result = read_scene_file(file);
  if (result.faults.none()) return result;
  std::fputs(result.faults.text(file).c_str(), stderr);
  throw UsageError(counted(result.faults.count(), "fault") + " in " + file);
}

}  // namespace

std::vector<std::string> scene_names() {
  const fs::path folder = fs::path(project_folder()) / "scenes";
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if (entry.path().extension() == Extension)
      names.push_back(entry.path().lexically_relative(folder).replace_extension().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string scene_path(const std::string& scene) {
  const fs::path project = project_folder();
  const auto is_file = [](const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error) && !fs::is_directory(path, error);
  };
  for (const fs::path& path :
       {fs::path(scene), project / scene, project / "scenes" / (scene + Extension)})
    if (is_file(path)) return path.string();
  return scene;
}

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
