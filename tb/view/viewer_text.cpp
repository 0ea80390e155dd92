// What the viewer says in words: statistics and title.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdint>
#include <sstream>
#include <string>

#include "tb/view/viewer.h"

namespace racebeam {

std::string Viewer::place() const {
  const BeamScreen& screen = stage_.source->watch().screen();
  if (stage_.source->watch().whole()) return "end of frame";
  return fmt::format("line {} : {}", screen.y(), screen.clock_of_line());
}

std::string Viewer::statistics() const {
  const FrameWatch& watch = stage_.source->watch();
  const int frame = watch.frame(), speed = control.state.speed;
  const std::string pace =
      speed < 0 ? fmt::format("1/{}", 1 << -speed) : std::to_string(1 << speed);
  std::string text = fmt::format("{:.32}\n", stage_.show.name());
  const auto row = [&](const char* name, const std::string& value) {
    text += fmt::format("{:<14}{:>18.18}\n", name, value);
  };
  row("frame", control.state.inputs ? std::to_string(frame)
                                    : fmt::format("{} of {}", frame, stage_.show.frames()));
  if (!control.state.inputs) row("part", stage_.show.part(frame));
  row("level", stage_.source->level());
  row("speed", control.state.paused ? "paused" : pace + " x");
  row("frames/s", control.state.paused ? "-" : fmt::format("{:.1f}", rate_));
  row("beam", place());
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

RgbImage Viewer::bare_picture() const {
  ViewState bare = control.state;
  bare.gauges = bare.text = bare.help = false;
  return view_picture(stage_.source->watch(), stage_.k, bare, {});
}

std::vector<std::string> Viewer::words() const {
  std::string text = error_.empty() ? "" : error_ + "\n";
  if (control.state.help)
    for (const KeyHelp& row : ViewControl::help(control.state.inputs.has_value()))
      text += fmt::format("{:<12}{}\n", row.keys, row.meaning);
  if (control.state.text || control.state.gauges) text += statistics();
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string Viewer::title() const {
  const int frame = stage_.source->watch().frame();
  std::string title =
      fmt::format("racebeam: {} {} {}", stage_.show.name(), frame, stage_.show.part(frame));
  if (const auto& in = control.state.inputs)
    title += fmt::format("ui {:08b} uio {:08b}{}", in->ui, in->uio,
                         control.state.uio_keys ? " - keys: uio" : "");
  if (flight_) title += " - free flight";
  if (control.state.paused) title += " - paused";
  if (recorder_.recording()) title += " - recording";
  if (!note_.empty()) title += " - " + note_;
  return title;
}

}  // namespace racebeam
