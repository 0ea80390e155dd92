// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/figure_parts.h"

#include <fmt/format.h>

namespace racebeam {

std::string subject_text(const FigureSubject& s) {
  return fmt::format("pixel {} of line {}, frame {} of {}", s.pixel, s.y, s.frame, s.show.name());
}

std::string svg_colour(int colour) {
  const auto light = [colour](int shift) { return (colour >> shift & 3) * 85; };
  return fmt::format("#{:02x}{:02x}{:02x}", light(4), light(2), light(0));
}

SvgPoint middle(const std::vector<SvgPoint>& points) {
  SvgPoint sum{0, 0};
  for (const SvgPoint& p : points) sum = {sum.x + p.x, sum.y + p.y};
  const auto n = static_cast<double>(points.size());
  return {sum.x / n, sum.y / n};
}

int chosen_face(const TracerStep& exit) {
  return exit.y_first ? (exit.answer & 1 ? 2 : 1) : (exit.answer & 1 ? 0 : 2);
}

void draw_legend(SvgSheet& sheet, double top, const std::string& title,
                 const FigureSubject& subject, const RayWalk& walk) {
  sheet.text({24, top}, title, SvgSheet::Anchor::Start, 16, Words, true);
  sheet.text(
      {24, top + 22},
      fmt::format("{}: ray {} {} {}", subject_text(subject), walk.ray[0], walk.ray[1], walk.ray[2]),
      SvgSheet::Anchor::Start, 12, Faint);
}

}  // namespace racebeam
