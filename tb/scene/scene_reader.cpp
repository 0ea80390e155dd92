// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_reader.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <utility>

#include "tb/scene/plan_reader.h"
#include "tb/scene/room_reader.h"
#include "tb/scene/scene_check.h"
#include "tb/scene/shot_reader.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

namespace {

constexpr std::uintmax_t LargestFile = 16 << 20;

void read_top(const TomlNode& root, SceneFile& scene, Faults& faults) {
  const TableReader top(root, "", faults);
  top.read("name", scene.name);
  std::vector<std::string> names;
  for (const engine* one : engines()) names.emplace_back(one->name);
  if (int number = 0; top.read_choice("engine", names, number)) scene.engine = engines()[number];
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

SceneResult unreadable(const std::string& why, const std::string& help) {
  SceneResult result;
  result.faults.add({}, why, help);
  return result;
}

}  // namespace

SceneResult read_scene(std::string_view text, const std::string& name) {
  SceneResult result;
  SceneFile& scene = result.scene;
  Faults& faults = result.faults;
  scene.name = name;
  const std::optional<TomlNode> root = parse_toml(text, faults);
  if (!root) return result;
  read_top(*root, scene, faults);
  const int faults_before = faults.count();
  if (const TomlNode* plan = root->find("plan")) read_plans(*plan, text, scene.rooms, faults);
  std::vector<NamedPortal> portals;
  std::vector<std::string> faulty;
  if (const TomlNode* rooms = root->find("room"))
    read_rooms(*rooms, scene.rooms, portals, faulty, faults);
  check_count(scene, faults_before, faults);
  const std::map<std::string, int> numbers = room_numbers(scene.rooms, faulty, faults);
  connect_named(portals, numbers, scene.overlap, scene.rooms, faults);
  if (scene.rooms.size() <= MaxRooms) check_rooms(scene, faults);
  read_shots(*root, numbers, scene, faults);
  if (!faults.none()) return result;
  check_views(scene, faults);
  warn_of_lost_rooms(scene, faults);
  return result;
}

SceneResult read_scene_file(const std::string& path) {
  const std::filesystem::path file(path);
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    return unreadable("this is a folder", "name a scene file in it");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > LargestFile)
    return unreadable("the file is larger than 16 MB", "is it a scene?");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return unreadable(std::string("cannot be read: ") + std::strerror(errno),
                      "check the name; `racebeam scene new` writes a file to start from");
  // Devices have no size: no more than a file may have is taken.
  std::string text(LargestFile + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) return unreadable("cannot be read", "is the disk in order?");
  if (text.size() > LargestFile)
    return unreadable("the file is larger than 16 MB", "is it a scene?");
  SceneResult result = read_scene(text, file.stem().string());
  result.text = std::move(text);
  return result;
}

}  // namespace racebeam
