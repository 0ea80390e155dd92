// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/shot_reader.h"

#include <algorithm>
#include <cstdlib>

#include "tb/scene/room_reader.h"
#include "tb/scene/table_reader.h"
#include "tb/scene/turn_reader.h"

namespace racebeam {

namespace {

constexpr int FramesAfterLastShot = 600;  // ten seconds
constexpr int LargestPosition = 8191, LargestVelocity = 1023;

class ShotReader {
 public:
  ShotReader(const std::map<std::string, int>& numbers, SceneFile& scene, Faults& faults)
      : numbers_(numbers), scene_(scene), faults_(faults) {}

  void read(const TomlNode& root) {
    Shot first;
    first.place = {1, 1};
    const TomlNode* camera = root.find("camera");
    if (camera) {
      first.place = camera->place;
      read_camera(*camera, first);
    }
    if (!camera || !camera->find("room")) start_at_mark(first);
    check_position(camera, first);
    if (const TomlNode* look = root.find("look")) read_look(*look, first.look);
    scene_.shots.assign(1, first);
    if (const TomlNode* shots = root.find("shot")) read_timeline(*shots);
    const int last = scene_.shots.back().frame;
    if (scene_.frames == 0) scene_.frames = std::min(last + FramesAfterLastShot, MaxFrames);
  }

 private:
  void start_at_mark(Shot& shot) {
    if (scene_.rooms.empty()) return;  // a fault of its own
    const auto at = numbers_.find("start"), first = numbers_.find("start.1"),
               second = numbers_.find("start.2");
    if (at != numbers_.end()) {
      shot.camera.room = at->second;
    } else if (first != numbers_.end() && second != numbers_.end() && first->second >= 0 &&
               second->second >= 0) {
      const Place one = scene_.rooms[first->second].place, two = scene_.rooms[second->second].place;
      faults_.add(two, "'@' stands " + place_text(one) + " and " + place_text(two),
                  "leave one of them: the camera starts there; or write [camera] room = \"ID\"");
    } else {
      faults_.add(shot.place, "the camera has no room",
                  "mark a cell of the plan with '@', or write [camera] room = \"ID\"; "
                  "that of a plan with a set is \"SET.start\"");
    }
  }

  static std::string place_text(Place place) {
    return "in line " + std::to_string(place.line) + ", column " + std::to_string(place.column);
  }

  void read_camera(const TomlNode& node, Shot& shot) {
    const TableReader table(node, "camera", faults_);
    Camera& camera = shot.camera;
    shot.restart = shot.frame == 0 || table.find("room") || table.find("position");
    std::string id;
    if (table.read("room", id)) {
      const auto at = numbers_.find(id);
      if (at != numbers_.end()) camera.room = at->second;
      else if (!scene_.rooms.empty())  // else a fault of its own
        faults_.add(table.find("room")->place, "there is no room " + quoted(id),
                    room_help(id, numbers_, faults_));
    }
    if (shot.restart) camera.position = {};
    table.read("position", -LargestPosition, LargestPosition, camera.position);
    table.read("velocity", -LargestVelocity, LargestVelocity, camera.velocity);
    read_turn(table, "yaw", TurnUnits, shot.frame, camera.yaw);
    read_turn(table, "pitch", TurnUnits, shot.frame, camera.pitch);
    read_turn(table, "fov", FocalUnits, shot.frame, camera.fov);
    table.read("interlace", camera.interlace);
  }

  // Only for a camera whose place was given or is that of the first frame.
  void check_position(const TomlNode* node, const Shot& shot) {
    const std::size_t room = static_cast<std::size_t>(shot.camera.room);
    if (!shot.restart || room >= scene_.rooms.size()) return;
    const Room& in = scene_.rooms[room];
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(shot.camera.position[axis]) < in.half_size[axis]) continue;
      const TomlNode* position = node ? node->find("position") : nullptr;
      faults_.add(position ? position->place : shot.place,
                  "the camera is outside of its room " + quoted(in.id),
                  "'position' counts from the middle of the room, which reaches to " +
                      std::to_string(in.half_size[0]) + ", " + std::to_string(in.half_size[1]) +
                      ", " + std::to_string(in.half_size[2]));
      return;
    }
  }

  void read_look(const TomlNode& node, Look& look) {
    const TableReader table(node, "look", faults_);
    table.read("palette", look.palette);
    table.read("pattern_palette", look.pattern_palette);
    int choice = 0;
    if (table.read_choice("shading", {"axis", "dithered"}, choice))
      look.shading = static_cast<Shading>(choice);
    if (table.read_choice("pattern", {"off", "partial", "full"}, choice))
      look.pattern = static_cast<Pattern>(choice);
    table.read("inverse", look.inverse);
  }

  void read_timeline(const TomlNode& shots) {
    if (shots.kind != TomlNode::Array) {
      faults_.add(shots.place, std::string("'shot' is ") + shots.kind_name(),
                  "write each shot below a line [[shot]]");
      return;
    }
    for (const TomlNode& item : shots.items) read_shot(item);
  }

  void read_shot(const TomlNode& node) {
    const TableReader table(node, "shot", faults_);
    if (node.kind != TomlNode::Table) return;
    Shot shot = scene_.shots.back();
    shot.restart = false;
    shot.place = node.place;
    shot.name.clear();
    table.read("name", shot.name);
    const TomlNode* frame =
        table.require("frame", "say from when on: frame = 600; 60 frames are a second");
    if (!frame || !table.read("frame", 1, MaxFrames - 1, shot.frame, FrameBitsHelp)) return;
    if (shot.frame <= scene_.shots.back().frame) {
      faults_.add(frame->place, "the shot is not after the one before it",
                  "order the shots by frame; frame 0 is [camera] and [look]");
      return;
    }
    if (scene_.frames > 0 && shot.frame >= scene_.frames)
      faults_.add(frame->place, "the shot is after the end of the scene",
                  "'frames' is " + std::to_string(scene_.frames) + "; raise it");
    const TomlNode* camera = table.find("camera");
    if (camera) read_camera(*camera, shot);
    check_position(camera, shot);
    if (const TomlNode* look = table.find("look")) read_look(*look, shot.look);
    scene_.shots.push_back(shot);
  }

  const std::map<std::string, int>& numbers_;
  SceneFile& scene_;
  Faults& faults_;
};

}  // namespace

void read_shots(const TomlNode& root, const std::map<std::string, int>& numbers, SceneFile& scene,
                Faults& faults) {
  ShotReader(numbers, scene, faults).read(root);
}

}  // namespace racebeam
