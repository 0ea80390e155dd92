// A portal with its four edges, drawn in the mirrored world, in which the ray has no negative
// component.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "tb/base/errors.h"
#include "tb/explain/figure_parts.h"
#include "tb/explain/step_text.h"

namespace racebeam {

std::string draw_portal(const FigureSubject& subject) {
  const RayWalk walk(subject.show, subject.k, subject.frame, subject.y, subject.pixel);
  const std::size_t room = walk.last_room();
  const RayQuestion& exit = walk.questions[room + 1];
  if (room + 2 >= walk.questions.size())
    throw UsageError("there is no portal in the face that this ray meets; try another --pixel");
  const RayQuestion& edge = walk.questions[room + 2];
  const int face = chosen_face(exit.step), across = (face + 1) % 3, down = (face + 2) % 3;
  const vec3 size = walk.magnitudes();
  // In the plane of the face: the room's side, the portal's edges, and where the ray crosses.
  struct Range {
    double low, high;
  };
  const auto range = [](const RayQuestion& q, int axis) {
    return Range{double(q.corner[axis] - 2 * q.half_size[axis]), double(q.corner[axis])};
  };
  const auto inside = [](Range of, Range in) {
    return Range{std::clamp(of.low, in.low, in.high), std::clamp(of.high, in.low, in.high)};
  };
  const Range wall_a = range(exit, across), wall_d = range(exit, down);
  const Range far_a = edge.step.level < 2 ? range(edge, across) : wall_a;
  const Range far_d = edge.step.level < 2 ? range(edge, down) : wall_d;
  const Range hole_a = inside(far_a, wall_a), hole_d = inside(far_d, wall_d);
  const double reach = double(exit.corner[face]) / std::max(size[face], 1);
  const double scale = std::min(370 / (wall_a.high - wall_a.low), 330 / (wall_d.high - wall_d.low));
  const auto at = [&](double a, double d) {
    return SvgPoint{50 + scale * (a - wall_a.low), 90 + scale * (d - wall_d.low)};
  };
  const auto box = [&](Range a, Range d) {
    return std::vector<SvgPoint>{at(a.low, d.low), at(a.high, d.low), at(a.high, d.high),
                                 at(a.low, d.high)};
  };
  SvgSheet sheet(720, 460, "A portal and its four edges");
  draw_legend(sheet, 26,
              fmt::format("The portal in the {} face", face_text(face, walk.negative(face))),
              subject, walk);
  // What each level cuts off from what is left, and the edge that it asks about.
  struct Cut {
    int level;
    std::vector<SvgPoint> area;
    SvgPoint from, to;
  };
  const Cut cuts[] = {
      {0, box(wall_a, {hole_d.high, wall_d.high}), at(wall_a.low, hole_d.high),
       at(wall_a.high, hole_d.high)},
      {1, box({hole_a.high, wall_a.high}, {wall_d.low, hole_d.high}), at(hole_a.high, wall_d.low),
       at(hole_a.high, hole_d.high)},
      {2, box({wall_a.low, hole_a.high}, {wall_d.low, hole_d.low}), at(wall_a.low, hole_d.low),
       at(hole_a.high, hole_d.low)},
      {3, box({wall_a.low, hole_a.low}, {hole_d.low, hole_d.high}), at(hole_a.low, hole_d.low),
       at(hole_a.low, hole_d.high)},
  };
  sheet.polygon(box(wall_a, wall_d), Pale, Line, 2);
  const RayQuestion* answers[4] = {};
  for (std::size_t i = room + 2; i < walk.questions.size() && walk.questions[i].step.level < 4; ++i)
    answers[walk.questions[i].step.level] = &walk.questions[i];
  for (const Cut& cut : cuts)
    sheet.polygon(cut.area,
                  answers[cut.level] && answers[cut.level]->step.answer ? TakenPale : Pale, None);
  sheet.polygon(box(hole_a, hole_d), GreenPale, None);
  for (const Cut& cut : cuts)
    sheet.line(cut.from, cut.to, answers[cut.level] ? Taken : Line, answers[cut.level] ? 2.5 : 1.5);
  for (const Cut& cut : cuts)
    sheet.text(middle(cut.area), std::to_string(cut.level), SvgSheet::Anchor::Middle, 13, Words,
               true);
  sheet.text(middle(box(hole_a, hole_d)), fmt::format("room {}", edge.step.room),
             SvgSheet::Anchor::Middle, 13, Green, true);
  sheet.circle(at(size[across] * reach, size[down] * reach), 5, Taken);
  double y = 100;
  const auto write = [&](const std::string& text, const char* colour, bool bold = false) {
    sheet.text({450, y}, text, SvgSheet::Anchor::Start, 12, colour, bold);
    y += 19;
  };
  for (int level = 0; level < 4; ++level) {
    TracerStep step = edge.step;
    step.level = level;
    write(fmt::format("{}: {}", level, question_text(step)), Words, true);
    write(answers[level] ? answer_text(answers[level]->step) : "not asked",
          answers[level] ? Taken : Faint);
    y += 4;
  }
  y += 8;
  write("The ray is the dot. An edge it is outside", Faint);
  write("of is a wall, and the questions end.", Faint);
  return sheet.finish();
}

}  // namespace racebeam
