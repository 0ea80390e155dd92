// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/explain_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tb/explain/step_text.h"

namespace racebeam {

namespace {

std::string rgb(int colour) {
  return fmt::format("{}{}{}", colour >> 4, colour >> 2 & 3, colour & 3);
}

std::string row(const char* title, const std::string& text) {
  return fmt::format("{:<10} {}\n", title, text);
}

std::string colour_text(const Explanation& e) {
  const ShownColumn& c = e.shown();
  std::string palette;
  for (const int colour : c.colours) palette += " " + rgb(colour);
  const std::string of =
      c.palette == TablePalette ? "the scene's palette" : fmt::format("palette {}", c.palette);
  return row("colour", fmt::format("RGB {} (0..3 each): index {} of {}:{}", rgb(c.colour), c.index,
                                   of, palette)) +
         row("", fmt::format("index {}: {}", c.index, e.why_index()));
}

std::string time_text(const Explanation& e) {
  std::string text = row("shown", fmt::format("clock {} of line {}", e.shown().clock, e.story.y));
  const bool known = e.interval && e.interval->known();
  if (e.fate == PixelFate::InTime)
    text += row("known",
                fmt::format("clock {}: {} clocks before the beam", e.interval->clock, e.slack()));
  else
    text += row("known", (known ? fmt::format("clock {}: ", e.interval->clock)
                          : e.fate == PixelFate::Never   ? "never: "
                          : e.fate == PixelFate::Pattern ? "not traced: "
                                                         : "from the first clock: ") +
                             e.why_unknown());
  return text;
}

std::string way_text(const Explanation& e) {
  const std::vector<RoomOnWay>& way = e.interval->way;
  std::string text;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const std::string through =
        i ? fmt::format("through {} into ", face_text(way[i].axis, way[i].negative)) : "camera in ";
    text += row(i ? "" : "way", fmt::format("{:>2}  {}room {}", i, through, e.room(way[i].room)));
  }
  return text;
}

std::string end_text(const Explanation& e) {
  const TracedInterval& i = *e.interval;
  const std::string room = "room " + e.room(i.way.back().room);
  const std::string behind = i.behind == SolidRoom ? "" : "room " + e.room(i.behind);
  switch (i.end) {
    case IntervalEnd::Solid:
      return fmt::format("{} wall of {}, which is solid", face_text(i.axis, i.negative), room);
    case IntervalEnd::Missed:
      return fmt::format("{} wall of {}, beside the opening to {}", face_text(i.axis, i.negative),
                         room, behind);
    case IntervalEnd::TooDeep:
      return fmt::format("{} face of {}: no ray looks deeper", face_text(i.axis, i.negative), room);
    case IntervalEnd::GivenUp:
      return fmt::format(
          "given up in {}{}: the beam was starving, and the interval short", room,
          behind.empty() ? "" : ", before the opening to " + behind + " was decided");
    case IntervalEnd::Never: break;
  }
  return "";
}

std::string totals_text(const StepTotals& t) {
  return row("cost", fmt::format("{} decisions ({} left, {} right, {} bisecting) in {} clocks",
                                 t.decisions(), t.left, t.right, t.bisect, t.clocks())) +
         row("", fmt::format("{} walking, {} changing rooms, {} returning, {} waiting for the "
                             "FIFO; {} pushed, {} restarts",
                             t.walks, t.room_changes, t.returns, t.waits, t.pushes, t.restarts));
}

constexpr const char* StepRow =
    "{:>5} {:>5}  {:<6} {:>3}..{:<3} {:>5}  {:>4}  {:>2}.{} {:<16}  {:<8} {}\n";

std::string steps_text(const Explanation& e) {
  std::string text = fmt::format(
      "\n{:>5} {:>5}  {:<6} {:>3}  {:<3} {:>5}  {:>4}  {:>4} {:<16}  {:<8} {}\n", "clock", "times",
      "state", "i1", "i2", "pixel", "room", "tree", "question", "answer", "so");
  for (std::size_t i = e.interval->step_begin; i < e.interval->step_end; ++i) {
    const TracerStep& s = e.story.steps[i];
    std::string line =
        fmt::format(StepRow, s.clock, s.clocks, state_name(s.state), s.first, s.last, s.asked(),
                    s.room, s.depth, s.level, s.decision ? question_text(s) : "", answer_text(s),
                    fmt::join(outcomes(s), ", "));
    while (line.size() > 1 && line[line.size() - 2] == ' ') line.erase(line.size() - 2, 1);
    text += line;
  }
  return text;
}

}  // namespace

std::string explain_text(const Explanation& e, const std::string& repeat) {
  std::string text =
      row("pixel", fmt::format("{},{} of frame {} of {}: column {}, line {}", e.column, e.row(),
                               e.story.frame, e.show.name(), e.column, e.story.y));
  text += colour_text(e) + time_text(e);
  if (e.interval) {
    const TracedInterval& i = *e.interval;
    text +=
        row("interval", fmt::format("pixels {}..{}, {} long, in columns {}..{}; this is pixel {}",
                                    i.first, i.last, i.length(), i.first + 1,
                                    std::min(i.last + 1, LastPixel), e.pixel()));
    if (i.known()) {
      text += row("hit", end_text(e));
      text +=
          row("depth", fmt::format("{} (the tracer at {}.{})", i.way.size() - 1, i.depth, i.level));
      text += way_text(e);
    }
    text += totals_text(totals(e.story, i));
  }
  text += row("trace", trace_command(e, repeat));
  if (e.interval) text += steps_text(e);
  return text;
}

}  // namespace racebeam
