// What the viewer says in words: statistics and title.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

#include "tb/base/counted.h"
#include "tb/view/viewer.h"

namespace racebeam {

namespace {

constexpr double MessageSeconds = 2;

std::string pace(int speed) {
  return speed < 0 ? fmt::format("1/{}", 1 << -speed) : std::to_string(1 << speed);
}

}  // namespace

void Viewer::say(const std::string& message) {
  message_ = message;
  message_left_ = MessageSeconds;
  changed_ = true;
}

void Viewer::say_and_tell(const std::string& message) {
  say(message);
  news_.push_back(message);
}

void Viewer::age_message(double elapsed) {
  message_left_ -= elapsed;
  if (message_.empty() || message_left_ > 0) return;
  message_.clear();
  changed_ = true;
}

// What keys have changed that the picture itself does not show. A step tells where it has come.
void Viewer::say_changes(bool acted) {
  const ViewState& now = control.state;
  const ViewState before = std::exchange(before_, now).value_or(now);
  if (now.paused && !before.paused && !acted) say("paused");
  if (now.speed != before.speed) say("speed " + pace(now.speed) + " x");
  if (now.muted == before.muted) return;
  say(now.muted ? "sound off" : now.speed == 0 ? "sound on" : "sound on, heard at speed 1 x only");
}

// Where the beam stands, by itself.
std::string Viewer::place() const {
  const FrameWatch& watch = stage_.source->watch();
  if (fill_) return fmt::format("frame {}", sound_frame_);
  if (watch.whole()) return fmt::format("frame {}", watch.frame());
  const int y = watch.screen().y(), clock = watch.screen().clock_of_line();
  return fmt::format("line {}{}, clock {}", y,
                     watch.raster().visible_line(y) ? "" : ", not visible", clock);
}

std::string Viewer::statistics() const {
  const FrameWatch& watch = stage_.source->watch();
  const int frame = watch.frame();
  std::string text = fmt::format("{:.32}\n", stage_.show.name());
  const auto row = [&](const char* name, const std::string& value) {
    text += fmt::format("{:<14}{:>18.18}\n", name, value);
  };
  row("frame", control.state.inputs ? std::to_string(frame)
                                    : fmt::format("{} of {}", frame, stage_.show.frames()));
  if (!control.state.inputs) row("part", stage_.show.part(frame));
  row("level", stage_.source->level());
  row("speed", control.state.paused ? "paused" : pace(control.state.speed) + " x");
  row("frames/s", control.state.paused ? "-" : fmt::format("{:.1f}", rate_));
  const BeamScreen& screen = watch.screen();
  row("beam", watch.whole() ? "end of frame"
                            : fmt::format("line {} : {}", screen.y(), screen.clock_of_line()));
  text += "\n";
  for (const auto& [name, value] : stage_.source->rows())
    if (name.empty()) text += "\n";
    else row(name.c_str(), value);
  if (flight_) {
    const Pose pose = flight_->pose();
    text += "\n";
    row("room", stage_.show.scene()->rooms[pose.room].id);
    row("place", fmt::format("{} {} {}", pose.position[0], pose.position[1], pose.position[2]));
    row("yaw, pitch", fmt::format("{}, {}", pose.yaw, pose.pitch));
  }
  return text;
}

RgbImage Viewer::picture() const {
  const int frame = stage_.source->watch().frame();
  ViewWords words{fmt::format("{} frame {}", stage_.show.name(), frame), "", error_};
  if (control.state.text) words.statistics = statistics();
  return view_picture(*stage_.source, control.state, words);
}

RgbImage Viewer::picture_with_message() const {
  RgbImage image = picture();
  if (!message_.empty()) paint_message(image, message_, stage_.source->watch());
  return image;
}

RgbImage Viewer::bare_picture() const {
  ViewState bare = control.state;
  bare.gauges = bare.text = bare.help = false;
  const Raster& raster = stage_.source->watch().raster();
  const RgbImage image = view_picture(*stage_.source, bare, {});
  return image.top(raster.columns, raster.rows);
}

std::vector<std::string> Viewer::words() const {
  std::string text = error_.empty() ? "" : error_ + "\n";
  if (control.state.help)
    for (const KeyHelp& row : control.help_on_show())
      text += fmt::format("{:<12}{}\n", row.keys, row.meaning);
  if (control.state.text || control.state.gauges) text += statistics();
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The beam has come there in the frame on show.
bool Viewer::drawn(ViewControl::Pixel pixel) const {
  const FrameWatch& watch = stage_.source->watch();
  if (watch.whole()) return true;
  const int row = watch.screen().y() - watch.raster().first_visible_line;
  if (pixel.row != row) return pixel.row < row;
  return pixel.column < watch.raster().column_at[watch.screen().clock_of_line()];
}

// Names the command that explains the clicked pixel, and the interval that showed it.
void Viewer::explain() {
  const auto [column, row] = control.clicked();
  const FrameWatch& watch = stage_.source->watch();
  if (options_.explain.empty()) return say("no pixel of this chip can be explained");
  if (!stage_.source->as_in_scene())
    return say("the board was touched: the scene alone does not say what this picture is");
  if (flight_) return say("a free flight cannot be explained; f: back to the path");
  if (!drawn({column, row}))
    return say(fmt::format("pixel {},{}: the beam has not come there yet", column, row));
  const std::string command = fmt::format("racebeam {} --frame {} --pixel {},{}", options_.explain,
                                          watch.frame(), column, row);
  news_.push_back("to know why: " + command);
  std::string text = command;
  for (const IntervalEvent& event : stage_.source->intervals())
    if (event.y == row + FirstVisibleLine && event.from < column && column <= event.to + 1)
      text += fmt::format("\npixels {}..{}: {} entered, {}, {}", event.from, event.to,
                          counted(event.depth, "room"), event.wall ? "a wall hit" : "given up",
                          counted(event.decisions, "decision"));
  say(text);
}

std::string Viewer::title() const {
  const int frame = stage_.source->watch().frame();
  std::string title =
      fmt::format("racebeam: {} {} {}", stage_.show.name(), frame, stage_.show.part(frame));
  if (const auto& in = control.state.inputs)
    title += fmt::format("ui {:08b} uio {:08b}{}", in->ui, in->uio,
                         control.state.uio_keys ? " - keys: uio" : "");
  if (control.state.high_switches) title += " - numbers: SW10 to SW17";
  if (flight_) title += " - free flight";
  if (control.state.paused) title += " - paused";
  if (recorder_.recording()) title += " - recording";
  if (!message_.empty()) title += " - " + message_.substr(0, message_.find('\n'));
  return title;
}

}  // namespace racebeam
