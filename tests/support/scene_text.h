// Scenes as text for tests: what the reader says of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tb/scene/scene_reader.h"

namespace racebeam {

/// A scene that must be good.
inline SceneFile good_scene(const std::string& text) {
  SceneResult result = read_scene(text, "test");
  EXPECT_EQ(result.faults.text("test.toml"), "") << text;
  return std::move(result.scene);
}

/// All faults, as the program prints them.
inline std::string faults_of(const std::string& text) {
  return read_scene(text, "test").faults.text("f");
}

/// Two rooms one behind the other, north of each other, and a camera: lines 1..9.
inline const std::string TwoRooms = R"([camera]
room = "a"
[[room]]
id = "a"
centre = [0, 0, 0]
half_size = [128, 256, 128]
portals = { north = "b" }
[[room]]
id = "b"
centre = [0, 0, 256]
half_size = [128, 256, 128]
)";

/// The number of a room by its id; fails if there is none.
inline int number_of(const SceneFile& scene, const std::string& id) {
  const auto at = std::find_if(scene.rooms.begin(), scene.rooms.end(),
                               [&](const Room& room) { return room.id == id; });
  EXPECT_NE(at, scene.rooms.end()) << id;
  return at == scene.rooms.end() ? 0 : static_cast<int>(at - scene.rooms.begin());
}

inline const Room& room_of(const SceneFile& scene, const std::string& id) {
  return scene.rooms[number_of(scene, id)];
}

}  // namespace racebeam
