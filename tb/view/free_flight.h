// FreeFlight: a camera that goes where it is steered, through portals, along walls.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/golden_camera.h"
#include "tb/scene/camera_path.h"
#include "tb/view/frame_source.h"

namespace racebeam {

class FreeFlight {
 public:
  /// Distance that is kept from walls, in the chip's units; less in rooms that are too small.
  static constexpr int Margin = 6;

  /// Starts in a room of the scene, which must outlive the flight.
  FreeFlight(const SceneFile& scene, const PathPoint& from, const GoldenView& view);

  /// Turns by 1/2048 of a full turn: to the right, down. Never over the head.
  void turn(double right, double down);
  /// Goes so many units ahead as it looks, to its right, and up (which is up whatever it looks
  /// at). A wall takes the part of the way that leads into it.
  void move(double ahead, double right, double up);

  Pose pose() const;

 private:
  void step(int axis, double by);

  const SceneFile& scene_;
  int room_;
  double position_[3];  // from the centre of the room
  double yaw_, pitch_;
  int fov_;
};

}  // namespace racebeam
