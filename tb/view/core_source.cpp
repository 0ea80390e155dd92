// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/core_source.h"

#include <algorithm>

namespace racebeam {

CoreSource::CoreSource(const knobs& k, const scene_program* program, bool wraps)
    : knobs_(k),
      program_(program),
      wraps_(wraps),
      now_(k),
      chip_(program),
      watch_(Raster(k.clocks_per_pixel, k.speed)) {
  seek(0);
}

// From reset: a chip that stands before the first clock of a frame.
void CoreSource::restart() {
  chip_ = chip_core(program_);
  chip_.clock(false, now_);
  watch_.restart();
}

void CoreSource::seek(int frame) {
  now_ = knobs_;
  flying_ = false;
  restart();
  chip_.deposit(frame, now_);
}

int CoreSource::advance(int clocks) {
  const int count = std::min(clocks, clocks_left());
  chip_view view;
  for (int i = 0; i < count; ++i) {
    const int room = chip_.decision_datapath.room_q, face = chip_.decision_datapath.hit_face_q;
    const int uo = chip_.clock(true, now_, &view).uo;
    watch_.clock(uo, view, room, face);
  }
  return count;
}

// The timeline stands still at the frame, or just after it where it would restart the flight.
void CoreSource::fly(int frame, const Pose& pose) {
  if (!can_fly()) return FrameSource::fly(frame, pose);
  if (!flying_) {
    flying_ = true;
    now_.navigator_bits = NavigatorPortBits;
    if (!wraps_) now_.corner_bits = CornerPortBits;
    restart();
  }
  chip_.timeline.seek(frame, *program_);
  const shot_row& shot = chip_.timeline.shot(*program_);
  if (shot.restart && shot.frame == frame) ++chip_.timeline.frame_q;
  chip_.timeline.turns_q[AngleYaw] = {pose.yaw, 0};
  chip_.timeline.turns_q[AnglePitch] = {pose.pitch, 0};
  chip_.timeline.turns_q[AngleFov] = {pose.fov, 0};
  for (int axis = 0; axis < 3; ++axis) chip_.navigator.position_q[axis] = -pose.position[axis];
  chip_.navigator.room_q = pose.room;
}

}  // namespace racebeam
