// The pyramid of a frame's rays, and the table by which a ray is stepped.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tb/explain/figure_parts.h"

namespace racebeam {

namespace {

using Anchor = SvgSheet::Anchor;

std::string vector_text(const vec3& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); }

/// How the camera stands in the world, drawn from behind, above and to the right of it: what the
/// camera has to its right, below it and ahead of it.
class Stand {
 public:
  Stand(const vec3& middle, const vec3& ddr) {
    const double wide = std::sqrt(ddr[0] * ddr[0] + ddr[1] * ddr[1] + ddr[2] * ddr[2]);
    for (int a = 0; a < 3; ++a) right[a] = ddr[a] / wide;
    double along = 0, deep = 0;
    for (int a = 0; a < 3; ++a) along += middle[a] * right[a];
    for (int a = 0; a < 3; ++a) {
      ahead[a] = middle[a] - along * right[a];
      deep += ahead[a] * ahead[a];
    }
    for (double& one : ahead) one /= std::sqrt(deep);
    for (int a = 0; a < 3; ++a)
      down[a] = ahead[(a + 1) % 3] * right[(a + 2) % 3] - ahead[(a + 2) % 3] * right[(a + 1) % 3];
  }
  /// Makes the ends of these rays, and the camera, fill the place for them.
  void fit(const std::vector<vec3>& rays) {
    SvgPoint low = plain({0, 0, 0}), high = low;
    for (const vec3& ray : rays) {
      const SvgPoint p = plain(ray);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    scale = std::min(Width / (high.x - low.x), Height / (high.y - low.y));
    origin = {Left - scale * low.x, Top - scale * low.y};
  }
  SvgPoint at(const vec3& ray) const {
    const SvgPoint p = plain(ray);
    return {origin.x + scale * p.x, origin.y + scale * p.y};
  }

  static constexpr double Left = 80, Top = 80, Width = 440, Height = 380;

 private:
  SvgPoint plain(const vec3& ray) const {
    double r = 0, d = 0, f = 0;
    for (int a = 0; a < 3; ++a) {
      r += ray[a] * right[a];
      d += ray[a] * down[a];
      f += ray[a] * ahead[a];
    }
    return {r + 1.6 * f, d - 0.5 * f + 0.3 * r};
  }

  std::array<double, 3> right, ahead, down;
  double scale = 1;
  SvgPoint origin{0, 0};
};

/// The middle of a box of half the size `half` near a point where lines to `ends` begin: in the
/// widest gap between them, as near as it touches none.
SvgPoint clear_place(SvgPoint from, const std::vector<SvgPoint>& ends, SvgPoint half) {
  constexpr double Turn = 2 * M_PI, Nearest = 14, Farthest = 90;
  std::vector<double> angles;
  for (const SvgPoint& end : ends) angles.push_back(std::atan2(end.y - from.y, end.x - from.x));
  std::sort(angles.begin(), angles.end());
  double begin = 0, gap = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + Turn;
    if (next - angles[i] > gap) begin = angles[i], gap = next - angles[i];
  }
  const double ahead = begin + gap / 2;
  const auto within = [&](double x, double y) {
    return std::abs(std::remainder(std::atan2(y, x) - ahead, Turn)) < gap / 2;
  };
  double away = Nearest;
  for (; away < Farthest; ++away) {
    const double x = away * std::cos(ahead), y = away * std::sin(ahead);
    if (std::max(std::abs(x) - half.x, std::abs(y) - half.y) < 6) continue;  // over the point
    if (within(x - half.x, y - half.y) && within(x + half.x, y - half.y) &&
        within(x - half.x, y + half.y) && within(x + half.x, y + half.y))
      break;
  }
  return {from.x + away * std::cos(ahead), from.y + away * std::sin(ahead)};
}

/// The axis along which a line turns most.
int steepest(const vec3& ddr) {
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    if (std::abs(ddr[a]) > std::abs(ddr[axis])) axis = a;
  return axis;
}

}  // namespace

std::string draw_pyramid(const FigureSubject& subject) {
  const auto line = [&](int y) { return line_rays(subject.show, subject.k, subject.frame, y); };
  const LineRays top = line(-240), here = line(subject.y), bottom = line(239);
  const auto ray = [&](const LineRays& rays, int pixel) { return rays.ray(pixel, subject.k); };
  Stand camera(ray(line(0), 320), line(0).ddr);
  camera.fit({ray(top, 0), ray(top, 639), ray(bottom, 0), ray(bottom, 639)});
  const SvgPoint eye = camera.at({0, 0, 0});
  SvgSheet sheet(640, 570, "The rays of a frame");
  sheet.text({24, 26}, "The rays of a frame, and of one line", Anchor::Start, 16, Words, true);
  sheet.text({24, 48},
             fmt::format("line {}, frame {} of {}", subject.y, subject.frame, subject.show.name()),
             Anchor::Start, 12, Faint);
  const SvgPoint left_top = camera.at(ray(top, 0)), right_top = camera.at(ray(top, 639));
  const SvgPoint left_low = camera.at(ray(bottom, 0)), right_low = camera.at(ray(bottom, 639));
  sheet.polygon({left_top, right_top, right_low, left_low}, Pale, Line, 1.5);
  for (const SvgPoint& corner : {left_top, right_top, right_low, left_low})
    sheet.line(eye, corner, Line, 1);
  const SvgPoint first = camera.at(ray(here, 0)), last = camera.at(ray(here, 639));
  for (int pixel = 0; pixel < 640; pixel += 64)
    sheet.line(eye, camera.at(ray(here, pixel)), Blue, 1);
  sheet.line(first, last, Taken, 2.5);
  const SvgPoint one = camera.at(ray(here, subject.pixel));
  sheet.line(eye, first, Taken, 1.5);
  sheet.line(eye, last, Taken, 1.5);
  sheet.line(eye, one, Taken, 2.5);
  sheet.circle(one, 4, Taken);
  sheet.circle(eye, 6, Words);
  sheet.text(
      clear_place(eye, {left_top, right_top, right_low, left_low, first, last, one}, {30, 8}),
      "camera", Anchor::Middle, 13, Words, true);
  sheet.text({first.x - 8, first.y}, "dr(0)", Anchor::End, 13, Taken, true);
  sheet.text({last.x + 8, last.y}, "dr(639)", Anchor::Start, 13, Taken, true);
  const bool falls = last.y > first.y;
  sheet.text({one.x + (falls ? 4 : -4), one.y - 13}, fmt::format("dr({})", subject.pixel),
             falls ? Anchor::Start : Anchor::End, 13, Taken, true);
  double y = 486;
  const auto row = [&](const std::string& name, const std::string& value) {
    sheet.text({24, y}, name, Anchor::Start, 12, Words, true);
    sheet.text({110, y}, value, Anchor::Start, 12, Words);
    y += 20;
  };
  row("dr(0)", vector_text(here.dr_0));
  row("ddr", vector_text(here.ddr) + " / 512 for each pixel");
  row(fmt::format("dr({})", subject.pixel), vector_text(ray(here, subject.pixel)));
  row("dr(639)", vector_text(ray(here, 639)));
  return sheet.finish();
}

std::string draw_steps(const FigureSubject& subject) {
  constexpr int Columns = DdrFractionBits + 2, Rows = PixelBits;
  constexpr double Left = 96, Top = 138, Wide = 54, High = 28;
  const LineRays rays = line_rays(subject.show, subject.k, subject.frame, subject.y);
  const int axis = steepest(rays.ddr), ddr = rays.ddr[axis];
  SvgSheet sheet(Left + Wide * Columns + 90, Top + High * Rows + 78, "The step table");
  sheet.text({24, 26}, "What each bit of a pixel's number adds to its ray, without fractions",
             Anchor::Start, 16, Words, true);
  sheet.text({24, 48}, fmt::format("{}: {}, ddr {}", subject_text(subject), "xyz"[axis], ddr),
             Anchor::Start, 12, Faint);
  sheet.text(
      {24, 70},
      "A row: a bit of the pixel. A column: a bit of ddr; the highest is its sign. Red: those "
      "that are set here.",
      Anchor::Start, 12, Faint);
  const auto has = [](int word, int bit) { return (word >> bit & 1) != 0; };
  for (int c = 0; c < Columns; ++c)
    sheet.text({Left + Wide * (c + 0.5), Top - 16}, fmt::format("ddr.{}", c), Anchor::Middle, 12,
               has(ddr, c) ? Taken : Faint, has(ddr, c));
  int sum = 0;
  for (int r = 0; r < Rows; ++r) {
    const double y = Top + High * (r + 0.5);
    const bool row = has(subject.pixel, r);
    sheet.text({Left - 12, y}, fmt::format("pixel.{}", r), Anchor::End, 12, row ? Taken : Faint,
               row);
    int added = 0;
    for (int c = 0; c < Columns; ++c) {
      const int delta = c == Columns - 1 ? -(1 << c) : 1 << c;
      knobs k = subject.k;
      k.dr_bits = 30;  // no weight wraps
      const int weight = LineRays{{0, 0, 0}, {delta, 0, 0}}.ray(1 << r, k)[0];
      const bool counts = row && has(ddr, c);
      if (counts) added += weight;
      const SvgPoint at{Left + Wide * (c + 0.5), y};
      const double w = Wide / 2 - 1, h = High / 2 - 1;
      sheet.polygon(
          {{at.x - w, at.y - h}, {at.x + w, at.y - h}, {at.x + w, at.y + h}, {at.x - w, at.y + h}},
          counts   ? TakenPale
          : weight ? Pale
                   : "#ffffff",
          None);
      sheet.text(at, std::to_string(weight), Anchor::Middle, 12,
                 counts   ? Taken
                 : weight ? Words
                          : Faint,
                 counts);
    }
    if (row)
      sheet.text({Left + Wide * Columns + 12, y}, std::to_string(added), Anchor::Start, 12, Taken,
                 true);
    sum += added;
  }
  const vec3 ray = rays.ray(subject.pixel, subject.k);
  sheet.text({Left - 60, Top + High * Rows + 32},
             fmt::format("{} in all: {} of the ray goes from {} to {}", sum, "xyz"[axis],
                         rays.dr_0[axis], ray[axis]),
             Anchor::Start, 13, Words, true);
  return sheet.finish();
}

}  // namespace racebeam
