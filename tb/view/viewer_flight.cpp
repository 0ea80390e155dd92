// The viewer's free flight.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tb/base/errors.h"
#include "tb/golden/golden_camera.h"
#include "tb/view/viewer.h"

namespace racebeam {

namespace {

constexpr double FlightSpeed = 240;    // units a second
constexpr double TurnSpeed = 340;      // 1/2048 turn a second, by keys
constexpr double MouseTurn = 0.8;      // 1/2048 turn a pixel
constexpr double LongestStride = 0.1;  // seconds between two frames of a flight, at most

}  // namespace

void Viewer::toggle_flight() {
  if (flight_) return go_to(flight_frame_);
  finish_frame();
  const int frame = stage_.source->watch().frame();
  try {
    if (!stage_.show.scene()) set_stage(options_.restage(options_.demo_file()), frame);
  } catch (const UsageError& error) {
    return say(error.what());
  }
  if (!stage_.source->can_fly())
    return say(fmt::format("no free flight at the level {}", stage_.source->level()));
  flight_frame_ = frame;
  flight_.emplace(*stage_.show.scene(), stage_.show.path()->points[frame],
                  stage_.show.golden_camera(frame, {}).view(0));
  control.state.flying = true;
  fill_ = true;
  say("free flight: w a s d, e x, arrows, mouse; f: back to the path");
}

// The pause holds the clock, not the camera: whole frames, each from where it is.
void Viewer::fly_while_paused(double elapsed) {
  finish_frame();
  passed_ = std::max(static_cast<int>(std::lround(elapsed * frame_rate())), 1);
  clocks(stage_.source->clocks_left());
}

// By what the keys and the mouse have asked for since the last frame.
void Viewer::steer() {
  const double seconds = std::min(std::exchange(flight_time_, 0), LongestStride);
  const auto motion = control.take_motion();
  const auto look = control.take_mouse();
  flight_->turn(motion.turn * TurnSpeed * seconds + look.right * MouseTurn,
                motion.tilt * TurnSpeed * seconds + look.down * MouseTurn);
  const double way = FlightSpeed * seconds;
  flight_->move(motion.ahead * way, motion.right * way, motion.up * way);
}

std::optional<Pose> Viewer::pose() const {
  if (!flight_) return {};
  return flight_->pose();
}

}  // namespace racebeam
