// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_camera_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>

#include "tb/scene/turn_reader.h"
#include "tb/scene/voxel_scene.h"

namespace racebeam {

namespace {

constexpr double FarAway = 1000000, Fastest = 1000;
constexpr int Highest = 16383, LongestFocal = 4096;
constexpr int FocalModulus = 1 << 24;  // none: of numbers below 0 it is taken away again

class Reader {
 public:
  Reader(VoxelCamera& camera, int pictures, Faults& faults)
      : camera_(camera), pictures_(pictures), faults_(faults) {}

  void read(const TomlNode& root, const Vector3& start) {
    VoxelShot first;
    first.position = start;
    first.place = {1, 1};
    const TomlNode* camera = root.find("camera");
    camera_.given = camera != nullptr;
    if (camera) read_camera(*camera, first);
    camera_.shots.assign(1, first);
    const TomlNode* shots = root.find("shot");
    if (!shots) return;
    if (shots->kind != TomlNode::Array)
      return wrong_type(*shots, "shot", "tables: write [[shot]]", faults_);
    for (const TomlNode& each : shots->items) read_shot(each);
  }

 private:
  void read_camera(const TomlNode& node, VoxelShot& shot) {
    const TableReader table(node, "camera", faults_, voxel_scene_keys());
    shot.place = node.place;
    if (table.read("position", -FarAway, FarAway, shot.position))
      shot.place = table.find("position")->place;
    table.read("velocity", -Fastest, Fastest, shot.velocity);
    read_turn(table, "yaw", TurnUnits, shot.picture, shot.yaw, voxel_scene_keys());
    read_turn(table, "pitch", TurnUnits, shot.picture, shot.pitch, voxel_scene_keys());
    read_turn(table, "fov", FocalModulus, shot.picture, shot.fov, voxel_scene_keys());
    read_rays(table, shot);
  }

  void read_rays(const TableReader& table, const VoxelShot& shot) {
    constexpr int Least = std::numeric_limits<int>::min(), Most = std::numeric_limits<int>::max();
    voxel_view view;
    int given = 0;
    const TomlNode* last = nullptr;
    const auto take = [&](const char* key, vec3& to) {
      if (!table.find(key)) return;
      last = table.find(key);
      ++given;
      Vector numbers{};
      table.read(key, Least, Most, numbers);
      to = {numbers[0], numbers[1], numbers[2]};
    };
    take("d00", view.d00);
    take("dx", view.dx);
    take("dy", view.dy);
    if (!given) return;
    if (shot.picture > 0)
      faults_.add(last->place, "a shot has rays of its own",
                  "d00, dx and dy are of all pictures: write them in [camera]");
    else if (given < 3)
      faults_.add(last->place, "of 'd00', 'dx' and 'dy' there are not all",
                  "write all three, or none of them: then fov, yaw and pitch count");
    else camera_.raw = view;
  }

  void read_shot(const TomlNode& node) {
    const TableReader table(node, "shot", faults_, voxel_scene_keys());
    if (node.kind != TomlNode::Table) return;
    const VoxelShot& before = camera_.shots.back();
    VoxelShot shot = before;
    shot.name.clear();
    shot.place = node.place;
    table.read("name", shot.name);
    const TomlNode* frame = table.require("frame", "say from which picture on: frame = 60");
    if (!frame || !table.read("frame", 1, MaxFrames - 1, shot.picture)) return;
    if (shot.picture <= before.picture)
      return faults_.add(frame->place, "the shot is not after the one before it",
                         "order the shots by frame; frame 0 is [camera]");
    if (shot.picture >= pictures_)
      faults_.add(frame->place, "the shot is after the end of the scene",
                  "'frames' is " + std::to_string(pictures_) + "; raise it");
    shot.position = camera_.pinhole(shot.picture).position;
    if (const TomlNode* camera = table.find("camera")) read_camera(*camera, shot);
    camera_.shots.push_back(shot);
  }

  VoxelCamera& camera_;
  int pictures_;
  Faults& faults_;
};

}  // namespace

const VoxelShot& VoxelCamera::shot_at(int picture) const {
  const auto after =
      std::upper_bound(shots.begin(), shots.end(), picture,
                       [](int wanted, const VoxelShot& shot) { return wanted < shot.picture; });
  return *std::prev(after);
}

VoxelPinhole VoxelCamera::pinhole(int picture) const {
  const VoxelShot& shot = shot_at(picture);
  VoxelPinhole pinhole;
  for (std::size_t k = 0; k < 3; ++k)
    pinhole.position[k] = shot.position[k] + (picture - shot.picture) * shot.velocity[k];
  pinhole.yaw = shot.yaw.value(picture, 0, TurnUnits);
  pinhole.pitch = shot.pitch.value(picture, 0, TurnUnits);
  const int focal = shot.fov.value(picture, 0, FocalModulus);
  pinhole.focal_length = focal < FocalModulus / 2 ? focal : focal - FocalModulus;
  return pinhole;
}

VoxelCamera read_voxel_camera(const TomlNode& root, const Vector3& start, int pictures,
                              Faults& faults) {
  VoxelCamera camera;
  Reader(camera, pictures, faults).read(root, start);
  return camera;
}

bool check_pinhole(const VoxelPinhole& pinhole, int picture, Place at, Faults& faults) {
  const int before = faults.count();
  if (pinhole.focal_length < 1 || pinhole.focal_length > LongestFocal)
    faults.add(at,
               fmt::format("the focal length is {:g} in picture {}", pinhole.focal_length, picture),
               "'fov' is in pixels: 1..4096; 320 shows a quarter of all around");
  const double height = pinhole.position[2];
  if (height < 0 || height > Highest)
    faults.add(at, fmt::format("the camera is at height {:g} in picture {}", height, picture),
               "z must be in 0..16383: 0 is the bottom of the world");
  return faults.count() == before;
}

void check_rays(const voxel_view& view, int width, int height, Place at, Faults& faults) {
  constexpr std::int64_t One = 1 << 24;
  for (const int y : {0, height - 1})
    for (const int x : {0, width - 1})
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t d =
            view.d00[k] + std::int64_t{x} * view.dx[k] + std::int64_t{y} * view.dy[k];
        if (std::abs(d) <= One) continue;
        return faults.add(
            at, fmt::format("the ray of pixel ({}, {}) is {} along {}", x, y, d, "xyz"[k]),
            "no more than 16777216, which is 1: make d00, dx and dy shorter");
      }
}

}  // namespace racebeam
