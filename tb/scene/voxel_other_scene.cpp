// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_other_scene.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "tb/base/counted.h"
#include "tb/scene/input_file.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

namespace {

namespace fs = std::filesystem;

constexpr const char *Voxel = "voxel", *Beam = "beam", *Sphere = "sphere", *For = "for";

/// Who shows a file: the one without the key is of beam.
std::string engine_of(const TomlNode& root) {
  const TomlNode* const named = root.find("engine");
  return !named ? Beam : named->kind == TomlNode::String ? named->text : "";
}

TomlNode without_others_keys(TomlNode root) {
  const auto is_for = [](const TomlEntry& entry) { return entry.key == For; };
  root.entries.erase(std::remove_if(root.entries.begin(), root.entries.end(), is_for),
                     root.entries.end());
  return root;
}

/// A table of [for.voxel], and of what all files have.
TomlNode voxel_keys(const TomlNode& root) {
  const TomlNode* const all = root.find(For);
  const TomlNode* const found = all ? all->find(Voxel) : nullptr;
  TomlNode own;
  own.place = found ? found->place : Place{1, 1};
  if (found) own.entries = found->entries;
  for (const char* key : {"name", "frames"})
    for (const TomlEntry& entry : root.entries)
      if (entry.key == key && !own.find(key)) own.entries.push_back(entry);
  return own;
}

VoxelOther rooms_of(const TomlNode& root, const SceneText& file, Faults& faults) {
  VoxelOther other;
  other.rooms = std::static_pointer_cast<const BeamScene>(
      read_beam_scene({root, file.text, file.name, file.folder}, faults));
  return other;
}

VoxelOther spheres_of(const TomlNode& root, const SceneText& file, Faults& faults) {
  VoxelOther other;
  other.spheres = std::static_pointer_cast<const SphereScene>(
      read_sphere_scene({root, file.text, file.name, file.folder}, faults));
  if (!other.spheres) return other;
  for (const TomlNode& each : root.find("sphere")->items) {
    const TomlNode* const id = each.find("id");
    other.names.push_back(id ? id->text : std::to_string(other.names.size() + 1));
  }
  return other;
}

using ReadScene = VoxelOther (*)(const TomlNode& root, const SceneText& file, Faults& faults);

VoxelOther read_named(const TomlNode& named, const SceneText& file, const char* key,
                      const char* engine, ReadScene read, Faults& faults) {
  std::string name;
  if (!read_text(named, key, name, faults)) return {};
  const std::string path = beside(file, name);
  Faults inside;
  VoxelOther other;
  if (const std::optional<std::string> text = read_input_file(path, "scene", inside))
    if (const std::optional<TomlNode> root = parse_toml(*text, inside)) {
      const std::string is_of = engine_of(*root);
      if (is_of != engine) {
        faults.add(named.place, racebeam::quoted(name) + " is a scene of " + is_of,
                   std::string("'") + key + "' takes one of " + engine);
        return {};
      }
      const fs::path at(path);
      other = read(without_others_keys(*root),
                   {*root, *text, at.stem().string(), at.parent_path().string()}, inside);
    }
  if (!inside.none()) {
    const Fault& first = inside.kept().front();
    const std::string where =
        first.place.line ? "line " + std::to_string(first.place.line) + ": " : "";
    faults.add(
        named.place,
        racebeam::quoted(name) + " has " + counted(inside.count(), "fault") + ": " + where +
            first.what,
        first.place.line ? "`racebeam scene check " + path + "` tells all of them" : first.help);
  }
  return other;
}

}  // namespace

VoxelFile split_voxel_file(const SceneText& file, Faults& faults) {
  Faults known;  // it was read before
  std::optional<TomlNode> root = parse_toml(file.text, known);
  if (!root) return {file.root, {}, {}};
  const std::string engine = engine_of(*root);
  if (engine == Voxel) return {file.root, {}, {}};
  VoxelFile split{voxel_keys(*root), {}, {}};
  if (engine == Beam) split.rooms = without_others_keys(std::move(*root));
  else if (engine == Sphere) split.spheres = without_others_keys(std::move(*root));
  else
    faults.add(root->find("engine")->place,
               "the voxel tracer cannot show a scene of " + racebeam::quoted(engine),
               "it shows its own, those of rooms and those of engine = \"sphere\"");
  return split;
}

VoxelOther read_own_scene(const VoxelFile& split, const SceneText& file, Faults& faults) {
  if (split.rooms) return rooms_of(*split.rooms, file, faults);
  if (split.spheres) return spheres_of(*split.spheres, file, faults);
  return {};
}

VoxelOther read_named_rooms(const TomlNode& named, const SceneText& file, Faults& faults) {
  return read_named(named, file, "rooms", Beam, rooms_of, faults);
}

VoxelOther read_named_spheres(const TomlNode& named, const SceneText& file, Faults& faults) {
  return read_named(named, file, "spheres", Sphere, spheres_of, faults);
}

std::string beside(const SceneText& file, const std::string& name) {
  return (fs::path(file.folder) / name).string();
}

}  // namespace racebeam
