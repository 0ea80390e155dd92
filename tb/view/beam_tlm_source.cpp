// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/beam_tlm_source.h"

#include <algorithm>
#include <utility>

namespace racebeam {

TlmSource::TlmSource(const knobs& k, const scene_program* program, bool wraps)
    : BeamSource(k), program_(program), wraps_(wraps), now_(k) {
  seek(0);
}

// From reset: a chip that stands before the first clock of a frame.
void TlmSource::restart() {
  lines_.emplace(chip_lines::options{now_, program_, false, false, &log_});
  watch_.restart();
}

void TlmSource::seek(int frame) {
  now_ = knobs_;
  flying_ = false;
  restart();
  lines_->deposit(frame);
}

// The last line clock by clock: it shows the wires at its end.
void TlmSource::run_frame() {
  std::vector<std::uint8_t> colours;
  colours.reserve(VisibleColumns * VisibleRows);
  log_.take();
  for (int y = FirstLine; y < LastLine; ++y) {
    lines_->run_line();
    if (lines_->visible())
      colours.insert(colours.end(), lines_->pixels().begin(), lines_->pixels().end());
  }
  frame_stats stats = lines_->take_stats();
  chip_view last;
  for (int clock = 0; clock < lines_->line_clocks(); ++clock) chip().clock(true, now_, &last);
  stats.clocks += static_cast<std::uint64_t>(lines_->line_clocks());
  watch_.whole_frame(std::move(colours), log_.take(), std::move(stats), last);
}

int TlmSource::advance(int clocks) {
  const int count = std::min(clocks, clocks_left());
  if (count == watch_.raster().frame_clocks()) {
    run_frame();
    return count;
  }
  chip_view view;
  for (int i = 0; i < count; ++i) {
    const int room = chip().decision_datapath.room_q, face = chip().decision_datapath.hit_face_q;
    const int uo = chip().clock(true, now_, &view).uo;
    watch_.clock(uo, view, room, face);
  }
  return count;
}

// The timeline stands still at the frame, or just after it where it would restart the flight.
void TlmSource::fly(int frame, const Pose& pose) {
  if (!can_fly()) return FrameSource::fly(frame, pose);
  if (!flying_) {
    flying_ = true;
    now_.navigator_bits = NavigatorPortBits;
    if (!wraps_) now_.corner_bits = CornerPortBits;
    restart();
  }
  chip().timeline.seek(frame, *program_);
  const shot_row& shot = chip().timeline.shot(*program_);
  if (shot.restart && shot.frame == frame) ++chip().timeline.frame_q;
  chip().timeline.turns_q[AngleYaw] = {pose.yaw, 0};
  chip().timeline.turns_q[AnglePitch] = {pose.pitch, 0};
  chip().timeline.turns_q[AngleFov] = {pose.fov, 0};
  for (int axis = 0; axis < 3; ++axis) chip().navigator.position_q[axis] = -pose.position[axis];
  chip().navigator.room_q = pose.room;
}

}  // namespace racebeam
