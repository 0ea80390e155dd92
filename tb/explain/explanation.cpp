// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tb/explain/line_watcher.h"

namespace racebeam {

namespace {

PixelFate fate_of(const LineStory& story, int column) {
  if (story.columns[column].pattern) return PixelFate::Pattern;
  if (column == 0) return PixelFate::Column0;
  const TracedInterval* interval = story.interval_of(column - 1);
  if (!interval || !interval->known()) return PixelFate::Never;
  return story.columns[column].clock > interval->clock ? PixelFate::InTime : PixelFate::Late;
}

std::string shading_text(const LineStory& story, int column, int axis, bool negative) {
  if (!story.shading_b) return fmt::format("shading by axis: {} faces", "xyz"[axis]);
  const bool checkered = story.dithering == DitheringCheckered;
  const bool odd = (checkered ? column + story.y : story.y) & 1;
  return fmt::format("dithered shading: {} faces, seen by rays towards {}{}, {} {}", "xyz"[axis],
                     negative ? '-' : '+', "xyz"[axis], odd ? "odd" : "even",
                     checkered ? "column plus line" : "line");
}

}  // namespace

const char* fate_name(PixelFate fate) {
  constexpr const char* names[] = {"in_time", "late", "never", "column_0", "pattern"};
  return names[static_cast<int>(fate)];
}

Explanation::Explanation(const Show& show, const knobs& k, int frame, int column, int row)
    : Explanation(show, line_story(frame, row + FirstVisibleLine, k, show.program()), column) {}

Explanation::Explanation(const Show& show, LineStory line, int column)
    : show(show), story(std::move(line)), column(column), fate(fate_of(story, column)) {
  const bool traced = fate != PixelFate::Column0 && fate != PixelFate::Pattern;
  interval = traced ? story.interval_of(pixel()) : nullptr;
  if (fate != PixelFate::Late && fate != PixelFate::Never) return;
  for (const TracedInterval& one : story.intervals)
    if (one.known() && one.clock < shown().clock) before = &one;
}

// A late interval began in time and was shown too early: both belong to the story.
int Explanation::first_clock() const {
  const bool steps = interval && interval->step_begin < interval->step_end;
  return steps ? std::min(story.steps[interval->step_begin].clock, shown().clock) : shown().clock;
}

int Explanation::last_clock() const {
  const int known = interval ? interval->clock : 0;
  return std::max(known, shown().clock);
}

std::string Explanation::room_name(int id) const {
  return show.scene() && id < static_cast<int>(show.scene()->rooms.size())
             ? show.scene()->rooms[id].id
             : "";
}

std::string Explanation::room(int id) const {
  const std::string name = room_name(id);
  return name.empty() ? std::to_string(id) : fmt::format("{} '{}'", id, name);
}

std::string Explanation::why_index() const {
  const std::string inverted = shown().inverse ? "; 2 and 3 inverted" : "";
  if (fate == PixelFate::Pattern)
    return fmt::format("ray pattern of direction {} {} {}{}", shown().ray[0], shown().ray[1],
                       shown().ray[2], inverted);
  if (fate == PixelFate::Column0) return "the FIFO starts every line with index 0" + inverted;
  if (fate != PixelFate::InTime)
    return (before ? fmt::format("left over in the FIFO from pixels {}..{}", before->first,
                                 before->last)
                   : "left over from the FIFO's own pixel") +
           inverted;
  if (interval->starving) return "dark: the beam was starving when the interval came" + inverted;
  return shading_text(story, column, interval->axis, interval->negative) + inverted;
}

std::string Explanation::why_unknown() const {
  switch (fate) {
    case PixelFate::InTime: return "";
    case PixelFate::Late:
      return slack() == 0 ? "the FIFO took it in the very clock in which it was sampled"
                          : fmt::format("the beam was {} clocks ahead of the tracer", -slack());
    case PixelFate::Never:
      return fmt::format("the line ended {}: pixels {}..{} were never known",
                         still_offered() ? "with an interval on offer that the FIFO did not take"
                                         : "before the tracer was done",
                         interval ? interval->first : 0, LastPixel);
    case PixelFate::Column0:
      return "pixel i of a line is shown in column i + 1; column 0 belongs to the FIFO, which "
             "starts with one pixel of its own";
    case PixelFate::Pattern:
      return "the ray pattern is shown: the bits of the ray's direction, whatever it hits";
  }
  return "";
}

bool Explanation::still_offered() const {
  if (story.steps.empty()) return false;
  const TracerStep& last = story.steps.back();
  return last.offers && !last.emits;
}

std::string trace_command(const Explanation& e, const std::string& repeat) {
  const auto moment = [&](int clock) {
    return fmt::format("{}:{}:{}", e.story.frame, e.story.y, clock);
  };
  return fmt::format("racebeam trace {} --from {} --to {} -o pixel.vcd", repeat,
                     moment(e.first_clock()), moment(e.last_clock()));
}

}  // namespace racebeam
