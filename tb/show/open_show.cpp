// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/open_show.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "tb/base/content_hash.h"
#include "tb/base/counted.h"
#include "tb/base/nearest.h"
#include "tb/base/project_folder.h"
#include "tb/scene/engines.h"
#include "tb/scene/scene_kinds.h"

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

AnySceneResult load(const std::string& scene) {
  const std::string file = scene_path(scene);
  std::error_code error;
  if (!fs::exists(file, error)) throw unknown_name("scene", scene, known_scenes(scene));
  AnySceneResult result = read_any_scene_file(file);
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

std::shared_ptr<const AnyScene> load_any_scene(const std::string& file, std::string* warnings) {
  std::error_code error;
  if (file == BuiltIn && !fs::exists(file, error))
    throw UsageError(
        "demo is built into the chip and no file; its rooms and its flight as a scene file: "
        "scenes/demo.toml");
  AnySceneResult result = load(file);
  if (warnings) *warnings = result.faults.warnings(file);
  return std::move(result.scene);
}

SceneFile load_scene(const std::string& file, const std::string& what) {
  const Show show(load_any_scene(file), "");
  expect_rooms(show, what);
  return *show.scene();
}

void expect_rooms(const Show& show, const std::string& what) {
  if (!show.of_rooms())
    throw UsageError(what + " is for scenes of box rooms; " + show.name() + " is a scene for " +
                     show.engine().name);
}

Show open_show(const std::string& scene) {
  if (scene == BuiltIn) return {};
  AnySceneResult result = load(scene);
  return {std::move(result.scene), content_hash(result.text)};
}

std::optional<Show> open_show_for(const engine& shown, const std::string& scene, std::string& why) {
  if (scene == BuiltIn) {
    if (&shown == engines().front()) return Show();
    why = std::string("demo is built into ") + engines().front()->name;
    return {};
  }
  const std::string file = scene_path(scene);
  std::error_code error;
  if (!fs::exists(file, error)) throw unknown_name("scene", scene, known_scenes(scene));
  AnySceneResult result = read_any_scene_file(file, &shown);
  if (result.faults.none()) return Show(std::move(result.scene), content_hash(result.text));
  const Fault& first = result.faults.kept().front();
  why = fmt::format("{}:{}:{}: {}", fs::path(file).filename().string(), first.place.line,
                    first.place.column, first.what);
  return {};
}

const engine& engine_named(const std::string& name) {
  std::vector<std::string> known;
  for (const engine* one : engines()) {
    if (one->name == name) return *one;
    known.emplace_back(one->name);
  }
  throw unknown_name("engine", name, known);
}

void expect_engine(const Show& show, const std::string& name) {
  if (name.empty() || &engine_named(name) == &show.engine()) return;
  const std::string own = show.engine().name;
  throw UsageError(show.name() + " is a scene for " + own + "; --engine " + own +
                   " or leave --engine out");
}

}  // namespace racebeam
