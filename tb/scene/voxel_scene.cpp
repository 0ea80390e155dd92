// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "sc/voxel/engine.h"
#include "sc/voxel/numbers.h"
#include "sc/voxel/voxel_world.h"
#include "tb/base/counted.h"
#include "tb/scene/tables_reader.h"
#include "tb/scene/voxel_camera_reader.h"
#include "tb/scene/voxel_ground_reader.h"

namespace racebeam {

namespace {

constexpr int MaxPictures = 16383, StandardPictures = 120;
constexpr int MaxCraters = 1000, MaxRadius = 4096, MaxCentre = 1000000;

/// Reads all; the tables of one kind at a time.
class Reader : TablesReader {
 public:
  Reader(const VoxelFile& split, const SceneText& file, VoxelProgram& program, Faults& faults)
      : TablesReader(split.own, voxel_scene_keys(), faults),
        split_(split),
        file_(file),
        program_(program) {}

  void read(std::string& name, std::vector<std::string>& parts, std::string& what) {
    const TableReader top(split_.own, "", faults_, voxel_scene_keys());
    top.read("name", name);
    VoxelGround ground = read_voxel_ground(split_, file_, faults_);
    int pictures = ground.pictures.value_or(StandardPictures);
    top.read("frames", 1, MaxPictures, pictures);
    program_.size = ground.size;
    program_.voxel = ground.voxel;
    read_picture(ground);
    all("material", VoxelMaterials, "a column has three bits for it",
        [&](const TableReader& from) { read_material(from, ground.colours); });
    all("crater", MaxCraters, "", [&](const TableReader& from) { read_crater(from, pictures); });
    program_.palette = palette_of(ground.colours);
    read_light();
    program_.columns = std::move(ground.columns);
    program_.objects = std::move(ground.objects);
    const VoxelCamera camera = read_camera(ground, pictures);
    what = ground.what;
    for (int n = 0; n < pictures; ++n) {
      const std::string& shot = camera.shot_at(n).name;
      parts.push_back(shot.empty() ? what : shot);
    }
  }

 private:
  void read_picture(const VoxelGround& ground) {
    std::array<int, 2> size = ground.shown.value_or(std::array{640, 480});
    one("picture", [&](const TableReader& from) {
      const TomlNode* const node = from.find("size");
      if (!node) return;
      if (node->kind != TomlNode::Array || node->items.size() != 2)
        return wrong_type(*node, "size", "two whole numbers: [640, 480]", faults_);
      read_number(node->items[0], "size", 8, 640, size[0], faults_);
      read_number(node->items[1], "size", 1, 480, size[1], faults_);
    });
    program_.width = size[0];
    program_.height = size[1];
  }

  void read_material(const TableReader& from, VoxelColours& colours) {
    int number = -1;
    const TomlNode* const node = from.require("number", "write number = 0, of 0..7");
    if (!from.read("number", 0, VoxelMaterials - 1, number)) return;
    MaterialColours& of = colours[static_cast<std::size_t>(number)];
    if (materials_ >> number & 1)
      faults_.add(node->place, fmt::format("there are two tables of material {}", number),
                  "leave one of them");
    materials_ |= 1u << number;
    from.read_rgb("low", of.low);
    from.read_rgb("high", of.high);
  }

  void read_crater(const TableReader& from, int pictures) {
    VoxelCrater crater;
    from.read("picture", 0, MaxPictures - 1, crater.picture);
    const TomlNode* const centre = from.require("centre", "write centre = [x, y]");
    from.require("radius", "write radius = 12");
    from.require("depth", "write depth = 9");
    if (centre && (centre->kind != TomlNode::Array || centre->items.size() != 2)) {
      wrong_type(*centre, "centre", "two whole numbers: [256, 100]", faults_);
    } else if (centre) {
      read_number(centre->items[0], "centre", -MaxCentre, MaxCentre, crater.x, faults_);
      read_number(centre->items[1], "centre", -MaxCentre, MaxCentre, crater.y, faults_);
    }
    const int side = std::min(program_.size[0], program_.size[1]);
    if (from.read("radius", 1, MaxRadius, crater.radius) && 2 * crater.radius > side)
      faults_.add(from.find("radius")->place,
                  fmt::format("the crater is {} wide; the world is {}", 2 * crater.radius, side),
                  "make the radius smaller: the world repeats");
    from.read("depth", 1, VoxelMaxHeight - 1, crater.depth);
    if (crater.picture >= pictures)
      faults_.add(from.find("picture")->place, "the crater is dug after the end of the scene",
                  "'frames' is " + std::to_string(pictures) + "; raise it");
    program_.craters.push_back(crater);
  }

  void read_light() {
    Vector3 direction{1, 2, 4};
    one("light", [&](const TableReader& from) {
      if (from.read("direction", -FarAway, FarAway, direction) && length(direction) < 1e-6)
        faults_.add(from.find("direction")->place, "the light comes from nowhere",
                    "write a direction towards it: [1, 2, 4]");
    });
    if (length(direction) >= 1e-6) light_ = voxel_light(direction);
  }

  VoxelCamera read_camera(const VoxelGround& ground, int pictures) {
    const vec3& size = ground.size;
    const VoxelCamera camera =
        read_voxel_camera(split_.own, {size[0] / 2.0, 0, size[2] * 0.9}, pictures, faults_);
    const bool of_other = !camera.given && !ground.pinholes.empty();
    bool good = true, told = false;
    for (int n = 0; good && n < pictures; ++n) {
      const VoxelPinhole pinhole =
          of_other ? ground.pinholes[static_cast<std::size_t>(n) % ground.pinholes.size()]
                   : camera.pinhole(n);
      const Place at = of_other ? ground.place : camera.shot_at(n).place;
      good = check_pinhole(pinhole, n, at, faults_);
      if (!good) break;
      voxel_view view = pinhole_view(pinhole, program_.width, program_.height, size);
      if (camera.raw) {
        view.d00 = camera.raw->d00;
        view.dx = camera.raw->dx;
        view.dy = camera.raw->dy;
      }
      view.light = light_;
      if (!told) told = warn_of_ground(view.origin, n, at);
      program_.views.push_back(view);
    }
    if (camera.raw)
      check_rays(*camera.raw, program_.width, program_.height, camera.shots.front().place, faults_);
    return camera;
  }

  bool warn_of_ground(const vec3& at, int picture, Place place) {
    if (program_.columns.empty()) return true;  // a fault of its own
    const auto whole = [](int coordinate) {
      return static_cast<std::size_t>(coordinate >> VoxelPositionFraction);
    };
    const voxel_column c = unpacked_column(
        program_.columns[whole(at[1]) * static_cast<std::size_t>(program_.size[0]) + whole(at[0])]);
    if (!voxel_solid(c.low, c.middle, c.high, at[2])) return false;
    faults_.warn(place, fmt::format("the camera is inside the ground in picture {}", picture),
                 fmt::format("the picture is that ground; it is solid from {} to {} there",
                             at[2] >> VoxelPositionFraction < c.low ? 0 : c.middle,
                             at[2] >> VoxelPositionFraction < c.low ? c.low : c.high));
    return true;
  }

  const VoxelFile& split_;
  const SceneText& file_;
  VoxelProgram& program_;
  unsigned materials_ = 0;  // that have a table
  vec3 light_{};
};

}  // namespace

const racebeam::engine& VoxelScene::engine() const { return voxel_engine(); }

std::string VoxelScene::part(int picture) const {
  return parts_[static_cast<std::size_t>(picture) % parts_.size()];
}

std::string VoxelScene::counts() const {
  const vec3& size = program_.size;
  std::string text = fmt::format("{} of {} x {} x {}", what_, size[0], size[1], size[2]);
  if (!program_.craters.empty()) text += ", " + counted(program_.craters.size(), "crater");
  return text;
}

std::vector<SceneFact> VoxelScene::facts() const {
  const auto by = [](const vec3& v) { return fmt::format("{}x{}x{}", v[0], v[1], v[2]); };
  return {{"terrain", what_},
          {"size", by(program_.size)},
          {"voxel", by(program_.voxel)},
          {"pictures", frames()},
          {"picture", fmt::format("{}x{}", program_.width, program_.height)},
          {"craters", static_cast<int>(program_.craters.size())}};
}

std::shared_ptr<const AnyScene> read_voxel_scene(const SceneText& file, Faults& faults) {
  const auto scene = std::make_shared<VoxelScene>();
  scene->name_ = file.name;
  const VoxelFile split = split_voxel_file(file, faults);
  if (!faults.none()) return nullptr;
  Reader(split, file, scene->program_, faults).read(scene->name_, scene->parts_, scene->what_);
  if (!faults.none()) return nullptr;
  return scene;
}

}  // namespace racebeam
