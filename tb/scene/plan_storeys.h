// What a drawing of a scene shows: the rooms by storeys, and the camera's way in strands without
// jumps.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/scene/camera_path.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

/// Rooms of one set that lie beside each other. Steps and landings belong to the storey from which
/// they lead up, and so do shafts.
struct Storey {
  std::string set;
  int number = 1;          ///< from the lowest of its set
  std::vector<int> rooms;  ///< by floor, the lowest first
  /// Rooms that lead nowhere but up or down, to higher or to larger ones: holes in ceilings.
  std::vector<int> shafts{};
};

/// Sets in the order of the file, each from its lowest storey. A room is in exactly one. In a scene
/// whose rooms may overlap, all of a set are one storey. Where all rooms of a set are shafts, they
/// are its rooms.
std::vector<Storey> storeys_of(const SceneFile& scene);

struct StrandPoint {
  int frame;
  Vector place;  ///< in the axes of the scene
};

/// Frames in which the camera moves on within a storey.
struct Strand {
  int storey = 0;      ///< index in storeys_of()
  bool jumps = false;  ///< here a shot has set the camera down
  std::vector<StrandPoint> points;
};

/// The whole way. A strand that goes on in another storey begins there with the last point of the
/// one before.
std::vector<Strand> strands_of(const SceneFile& scene, const CameraPath& path,
                               const std::vector<Storey>& storeys);

}  // namespace racebeam
