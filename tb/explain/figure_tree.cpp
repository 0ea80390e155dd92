// The decision tree of a room.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "tb/explain/figure_parts.h"
#include "tb/explain/step_text.h"

namespace racebeam {

namespace {

using Anchor = SvgSheet::Anchor;

constexpr double BoxWidth = 146, BoxHeight = 40, WallWidth = 90;

/// A question, or what is known at the end of a way.
class Tree {
 public:
  Tree(const FigureSubject& subject, RayWalk walk)
      : subject_(subject), walk_(std::move(walk)), room_(walk_.last_room()) {}

  std::string draw() {
    sheet_.text({24, 26}, fmt::format("The questions of room {}", first().step.room), Anchor::Start,
                16, Words, true);
    sheet_.text({24, 48}, subject_text(subject_), Anchor::Start, 12, Faint);
    const SvgPoint root{380, 96};
    question(root, first().step, true);
    for (const bool y_first : {false, true}) {
      const bool taken = exit().step.y_first == y_first;
      const SvgPoint at{y_first ? 570.0 : 190.0, 176};
      TracerStep step = exit().step;
      step.y_first = y_first;
      branch(root, at, answer(first().step, y_first), taken);
      question(at, step, taken);
      for (const int bit : {0, 1}) {
        const SvgPoint end{at.x + (bit ? 95 : -95), 256};
        const bool met = taken && (exit().step.answer & 1) == bit;
        branch(at, end, answer(step, bit), met);
        leaf(end, answer(step, bit) + " face", met);
        if (met) portal(end);
      }
    }
    return sheet_.finish();
  }

 private:
  const RayQuestion& first() const { return walk_.questions[room_]; }
  const RayQuestion& exit() const { return walk_.questions[room_ + 1]; }
  static std::string answer(TracerStep step, int bit) {
    step.answer = bit;
    return answer_text(step);
  }

  // Below the face: the four edges of its portal from left to right, each with a wall beside it.
  void portal(SvgPoint face) {
    const std::size_t begin = room_ + 2;
    if (begin >= walk_.questions.size()) {
      branch(face, {face.x, 336}, "", true);
      leaf({face.x, 336}, "a wall: no room behind", true);
      return;
    }
    SvgPoint before = face;
    bool reached = true;
    std::size_t next = begin;
    for (int level = 0; level < 4; ++level) {
      const SvgPoint at{100 + 186.0 * level, 346}, wall{at.x - 28, 426};
      TracerStep step = walk_.questions[begin].step;
      step.level = level;
      const bool skipped =
          reached && next < walk_.questions.size() && walk_.questions[next].step.level != level;
      const bool asked = reached && !skipped && next < walk_.questions.size();
      branch(before, at, level ? answer(step, 0) : "", reached);
      question(at, step, asked);
      const bool missed = asked && (walk_.questions[next].step.answer & 1);
      branch(at, wall, answer(step, 1), missed);
      leaf(wall, "a wall", missed, WallWidth);
      next += asked;
      reached = reached && !missed;
      before = at;
    }
    const SvgPoint room{before.x, 506};
    sheet_.line({before.x + BoxWidth / 2 - 8, before.y + BoxHeight / 2},
                {room.x + BoxWidth / 2 - 8, room.y - BoxHeight / 2}, reached ? Taken : Faint,
                reached ? 2.5 : 1);
    sheet_.text({room.x + BoxWidth / 2 - 14, room.y - 40}, "inside", Anchor::End, 12,
                reached ? Taken : Faint);
    leaf(room, fmt::format("room {}, and so on", walk_.questions[begin].step.room), reached);
  }

  void branch(SvgPoint from, SvgPoint to, const std::string& label, bool taken) {
    const bool sideways = from.y == to.y;
    const SvgPoint a{from.x + (sideways ? BoxWidth / 2 : 0),
                     from.y + (sideways ? 0 : BoxHeight / 2)};
    const SvgPoint b{to.x - (sideways ? BoxWidth / 2 : 0), to.y - (sideways ? 0 : BoxHeight / 2)};
    sheet_.line(a, b, taken ? Taken : Faint, taken ? 2.5 : 1);
    if (label.empty()) return;
    // Beside a steep line, above a flat one.
    const bool steep = std::abs(b.x - a.x) < std::abs(b.y - a.y);
    const SvgPoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const char* const ink = taken ? Taken : Faint;
    if (sideways) sheet_.text({middle.x, middle.y - 9}, label, Anchor::Middle, 11, ink);
    else if (steep) sheet_.text({middle.x + 8, middle.y}, label, Anchor::Start, 12, ink);
    else if (b.x > a.x) sheet_.text({middle.x + 10, middle.y - 8}, label, Anchor::Start, 12, ink);
    else sheet_.text({middle.x - 10, middle.y - 8}, label, Anchor::End, 12, ink);
  }
  void question(SvgPoint at, const TracerStep& step, bool asked) {
    box(at, fmt::format("{}: {}?", step.level, question_text(step)), asked ? Blue : Pale,
        asked ? Words : Faint, asked);
  }
  void leaf(SvgPoint at, const std::string& text, bool reached, double width = BoxWidth) {
    box(at, text, reached ? TakenPale : "#ffffff", reached ? Taken : Faint, reached, width);
  }
  void box(SvgPoint at, const std::string& text, const char* fill, const char* ink, bool strong,
           double width = BoxWidth) {
    const double w = width / 2, h = BoxHeight / 2;
    sheet_.polygon(
        {{at.x - w, at.y - h}, {at.x + w, at.y - h}, {at.x + w, at.y + h}, {at.x - w, at.y + h}},
        fill, strong ? Line : Faint, strong ? 1.5 : 1);
    sheet_.text(at, text, Anchor::Middle, 12, ink, strong);
  }

  const FigureSubject& subject_;
  const RayWalk walk_;
  const std::size_t room_;
  SvgSheet sheet_{760, 548, "The decision tree of a room"};
};

}  // namespace

std::string draw_tree(const FigureSubject& subject) {
  return Tree(subject, {subject.show, subject.k, subject.frame, subject.y, subject.pixel}).draw();
}

}  // namespace racebeam
