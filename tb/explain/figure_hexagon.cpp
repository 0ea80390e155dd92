// The hexagon of a room. It is drawn in the mirrored world, in which the ray has no negative
// component.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tb/explain/figure_parts.h"
#include "tb/explain/step_text.h"

namespace racebeam {

namespace {

using Anchor = SvgSheet::Anchor;
using Real = std::array<double, 3>;

double dot(const Real& a, const Real& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Real cross(const Real& a, const Real& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real scaled(const Real& a, double by) { return {a[0] * by, a[1] * by, a[2] * by}; }
Real normal(const Real& a) { return scaled(a, 1 / std::sqrt(dot(a, a))); }
/// The outline around points, in order.
std::vector<SvgPoint> outline(std::vector<SvgPoint> points) {
  std::sort(points.begin(), points.end(),
            [](SvgPoint a, SvgPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto turn = [](SvgPoint o, SvgPoint a, SvgPoint b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  };
  std::vector<SvgPoint> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const SvgPoint& p : points) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double area(const std::vector<SvgPoint>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SvgPoint p = points[i], q = points[(i + 1) % points.size()];
    twice += p.x * q.y - q.x * p.y;
  }
  return std::abs(twice) / 2;
}

/// Where the line from `a` through `b` and beyond leaves an outline.
SvgPoint leaves(SvgPoint a, SvgPoint b, const std::vector<SvgPoint>& hull) {
  double first = 1e9;
  const double dx = b.x - a.x, dy = b.y - a.y;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const SvgPoint p = hull[i], q = hull[(i + 1) % hull.size()];
    const double ex = q.x - p.x, ey = q.y - p.y, det = dx * ey - dy * ex;
    if (std::abs(det) < 1e-9) continue;
    const double t = ((p.x - a.x) * ey - (p.y - a.y) * ex) / det;
    const double s = ((p.x - a.x) * dy - (p.y - a.y) * dx) / det;
    if (t > 1e-6 && s >= -1e-6 && s <= 1 + 1e-6) first = std::min(first, t);
  }
  return {a.x + first * dx, a.y + first * dy};
}

/// A box looked at along the ray: the ray itself is the point 0, 0.
class View {
 public:
  View(const vec3& ray, const RayQuestion& room) : corner_(room.corner), size_(room.half_size) {
    const Real ahead = normal({ray[0] + 0.5, ray[1] + 0.5, ray[2] + 0.5});
    down_ = normal({-ahead[1] * ahead[0], 1 - ahead[1] * ahead[1], -ahead[1] * ahead[2]});
    right_ = cross(down_, ahead);
    std::vector<SvgPoint> corners;
    for (int near = 0; near < 8; ++near) corners.push_back(plain(near));
    hull_ = outline(corners);
    double left = 1e9, top = 1e9, wide = -1e9, high = -1e9;
    for (const SvgPoint& p : hull_) {
      left = std::min(left, p.x), wide = std::max(wide, p.x);
      top = std::min(top, p.y), high = std::max(high, p.y);
    }
    scale_ = std::min(Width / (wide - left), Height / (high - top));
    origin_ = {Middle - scale_ * (left + wide) / 2, Centre - scale_ * (top + high) / 2};
    for (SvgPoint& p : hull_) p = placed(p);
  }

  /// Bit a of `near`: on axis a the corner on the camera's side.
  SvgPoint at(int near) const { return placed(plain(near)); }
  SvgPoint ray() const { return origin_; }
  const std::vector<SvgPoint>& hull() const { return hull_; }
  std::vector<SvgPoint> face(int axis) const {
    const int a = 1 << (axis + 1) % 3, b = 1 << (axis + 2) % 3;
    return {at(0), at(a), at(a | b), at(b)};
  }
  /// Where the line of the z edge goes on over the z face and leaves it.
  SvgPoint beyond_z() const {
    const SvgPoint corner = at(0), end = at(4);
    return leaves(corner, {2 * corner.x - end.x, 2 * corner.y - end.y}, hull_);
  }
  /// For the name of a face: its middle; of the z face, that of its larger part beside that line.
  SvgPoint label(int axis) const {
    if (axis != 2) return middle(face(axis));
    const std::vector<SvgPoint> left = {at(0), at(1), at(3), beyond_z()};
    const std::vector<SvgPoint> right = {at(0), beyond_z(), at(3), at(2)};
    return middle(area(left) > area(right) ? left : right);
  }

  static constexpr double Width = 360, Height = 330, Middle = 225, Centre = 250;

 private:
  SvgPoint plain(int near) const {
    Real p;
    for (int a = 0; a < 3; ++a) p[a] = corner_[a] - (near >> a & 1 ? 2 * size_[a] : 0);
    return {dot(p, right_), dot(p, down_)};
  }
  SvgPoint placed(SvgPoint p) const { return {origin_.x + scale_ * p.x, origin_.y + scale_ * p.y}; }

  vec3 corner_, size_;
  Real right_, down_;
  double scale_;
  SvgPoint origin_;
  std::vector<SvgPoint> hull_;
};

std::string numbers_text(const RayQuestion& q, const vec3& ray) {
  const int axis = q.step.level == 6 ? 2 : q.step.y_first ? 0 : 1;
  const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  return fmt::format("edge {}: {} {} with {} {} against {} {}", "xyz"[axis], "xyz"[a], "xyz"[b],
                     q.corner[a], q.corner[b], ray[a], ray[b]);
}

}  // namespace

std::string draw_hexagon(const FigureSubject& subject) {
  const RayWalk walk(subject.show, subject.k, subject.frame, subject.y, subject.pixel);
  const RayQuestion &first = walk.questions[walk.last_room()],
                    &exit = walk.questions[walk.last_room() + 1];
  const View view(walk.magnitudes(), first);
  const int taken = chosen_face(exit.step);
  SvgSheet sheet(720, 460, "A room as the ray sees it");
  draw_legend(sheet, 26, fmt::format("Room {}, looked at along the ray", first.step.room), subject,
              walk);
  for (int axis = 0; axis < 3; ++axis)
    sheet.polygon(view.face(axis), axis == taken ? TakenPale : Pale, None);
  sheet.polygon(view.hull(), None, Line, 2);
  // Each edge, solid where the faces meet, dashed where its line goes on.
  for (int axis = 0; axis < 3; ++axis) {
    const SvgPoint corner = view.at(0), end = view.at(1 << axis);
    const bool asked = axis == 2 || axis == (exit.step.y_first ? 0 : 1);
    sheet.line(corner, end, asked ? Taken : Line, asked ? 2.5 : 1.5);
    if (axis == 2) sheet.line(corner, view.beyond_z(), Taken, 1.5, true);
    const SvgPoint label = leaves(corner, end, view.hull());
    sheet.text({label.x + (label.x - corner.x) * 0.07, label.y + (label.y - corner.y) * 0.07},
               std::string(1, "xyz"[axis]), Anchor::Middle, 14, asked ? Taken : Words, true);
  }
  const auto clear_of_the_ray = [&](SvgPoint p) {
    const bool near = std::hypot(p.x - view.ray().x, p.y - view.ray().y) < 24;
    return near ? SvgPoint{p.x, view.ray().y + 22} : p;
  };
  for (int axis = 0; axis < 3; ++axis)
    sheet.text(clear_of_the_ray(view.label(axis)), face_text(axis, walk.negative(axis)),
               Anchor::Middle, 13, axis == taken ? Taken : Words, axis == taken);
  sheet.circle(view.ray(), 5, Taken);
  double y = 120;
  const auto write = [&](const std::string& text, const char* colour = Words, bool bold = false) {
    sheet.text({450, y}, text, Anchor::Start, 12, colour, bold);
    y += 19;
  };
  write("6: " + question_text(first.step) + "?", Words, true);
  write(numbers_text(first, walk.magnitudes()), Faint);
  write("answer: " + answer_text(first.step), Taken, true);
  y += 12;
  write("7: " + question_text(exit.step) + "?", Words, true);
  write(numbers_text(exit, walk.magnitudes()), Faint);
  write("answer: " + answer_text(exit.step), Taken, true);
  y += 12;
  write("The ray is the dot. Each question asks", Faint);
  write("on which side of an edge it lies; all", Faint);
  write("three edges go through the far corner.", Faint);
  return sheet.finish();
}

}  // namespace racebeam
