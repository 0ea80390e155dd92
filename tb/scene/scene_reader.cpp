// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_reader.h"

#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "tb/scene/input_file.h"
#include "tb/scene/plan_reader.h"
#include "tb/scene/room_reader.h"
#include "tb/scene/scene_check.h"
#include "tb/scene/shot_reader.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

namespace {

void read_top(const TomlNode& root, SceneFile& scene, Faults& faults) {
  const TableReader top(root, "", faults);
  top.read("name", scene.name);
  int only = 0;  // scene_kinds.h chooses
  top.read_choice("engine", {"beam"}, only);
  top.read("frames", 1, MaxFrames, scene.frames, FrameBitsHelp);
  top.read("corner_bits", MinCornerBits, MaxCornerBits, scene.corner_bits);
  top.read("wrap", scene.wrap);
  top.read("overlap", scene.overlap);
}

// `faults_before` were there before the rooms were read.
void check_count(const SceneFile& scene, int faults_before, Faults& faults) {
  const int count = static_cast<int>(scene.rooms.size());
  if (count == 0 && faults.count() == faults_before)
    faults.add({1, 1}, "the scene has no rooms",
               "draw a [plan] or write [[room]]; `racebeam scene new` makes a file to start from");
  if (count > MaxRooms)
    faults.add({1, 1}, "the scene has " + std::to_string(count) + " rooms",
               "at most " + std::to_string(MaxRooms) + " fit the room number");
}

}  // namespace

SceneFile read_scene_tree(const TomlNode& root, std::string_view text, const std::string& name,
                          Faults& faults) {
  SceneFile scene;
  scene.name = name;
  read_top(root, scene, faults);
  const int faults_before = faults.count();
  if (const TomlNode* plan = root.find("plan")) read_plans(*plan, text, scene.rooms, faults);
  std::vector<NamedPortal> portals;
  std::vector<std::string> faulty;
  if (const TomlNode* rooms = root.find("room"))
    read_rooms(*rooms, scene.rooms, portals, faulty, faults);
  check_count(scene, faults_before, faults);
  const std::map<std::string, int> numbers = room_numbers(scene.rooms, faulty, faults);
  connect_named(portals, numbers, scene.overlap, scene.rooms, faults);
  if (scene.rooms.size() <= MaxRooms) check_rooms(scene, faults);
  read_shots(root, numbers, scene, faults);
  if (!faults.none()) return scene;
  check_views(scene, faults);
  warn_of_lost_rooms(scene, faults);
  return scene;
}

SceneResult read_scene(std::string_view text, const std::string& name) {
  SceneResult result;
  if (const std::optional<TomlNode> root = parse_toml(text, result.faults))
    result.scene = read_scene_tree(*root, text, name, result.faults);
  else result.scene.name = name;
  return result;
}

SceneResult read_scene_file(const std::string& path) {
  Faults faults;
  std::optional<std::string> text = read_input_file(path, "scene", faults);
  if (!text) return {{}, std::move(faults)};
  SceneResult result = read_scene(*text, std::filesystem::path(path).stem().string());
  result.text = std::move(*text);
  return result;
}

}  // namespace racebeam
