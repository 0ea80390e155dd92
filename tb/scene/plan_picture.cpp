// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_picture.h"

#include <algorithm>

#include "tb/scene/camera_path.h"

namespace racebeam {

namespace {

constexpr int Largest = 1000, Margin = 12, StartSize = 3;  // pixels

// One view: the axes that go right and down on the paper.
class View {
 public:
  View(const SceneFile& scene, const std::vector<int>& rooms, int right, int down, bool flip)
      : right_(right), down_(down), depth_(3 - right - down), flip_(flip) {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = scene.rooms[rooms[0]].low(axis);
      high_[axis] = scene.rooms[rooms[0]].high(axis);
      for (const int room : rooms) {
        low_[axis] = std::min(low_[axis], scene.rooms[room].low(axis));
        high_[axis] = std::max(high_[axis], scene.rooms[room].high(axis));
      }
    }
  }

  int largest() const { return std::max(length(right_), length(down_)); }
  void scale_to(double scale) { scale_ = scale; }
  int width() const { return pixels(length(right_)) + 2 * Margin; }
  int height() const { return pixels(length(down_)) + 2 * Margin; }
  void move_to(int top) { top_ = top; }

  void draw(const SceneFile& scene, std::vector<int> rooms, const CameraPath& path, Canvas& canvas,
            const std::string& set) const {
    // The nearest to the eye last: from above that is the smallest y, from the south the smallest
    // z.
    std::stable_sort(rooms.begin(), rooms.end(), [&](int a, int b) {
      return scene.rooms[a].centre[depth_] > scene.rooms[b].centre[depth_];
    });
    for (const int room : rooms) draw_room(scene.rooms[room], canvas);
    for (const int room : rooms) draw_portals(scene, scene.rooms[room], canvas);
    draw_way(scene, path, canvas, set);
  }

 private:
  int length(int axis) const { return high_[axis] - low_[axis]; }
  int pixels(int units) const { return static_cast<int>(units * scale_); }
  int x(int value) const { return Margin + pixels(value - low_[right_]); }
  int y(int value) const {
    return top_ + Margin + pixels(flip_ ? high_[down_] - value : value - low_[down_]);
  }

  void draw_room(const Room& room, Canvas& canvas) const {
    const int top = std::min(y(room.low(down_)), y(room.high(down_)));
    const int bottom = std::max(y(room.low(down_)), y(room.high(down_)));
    const int left = x(room.low(right_)), right = x(room.high(right_));
    const bool lowest = room.high(1) == high_[1];
    canvas.fill(left, top, right, bottom, lowest ? PlanColours::Low : PlanColours::High);
    canvas.frame(left, top, right, bottom, PlanColours::Wall);
  }

  void draw_portals(const SceneFile& scene, const Room& room, Canvas& canvas) const {
    for (int face = 0; face < FaceCount; ++face)
      for (const int number : room.portals[face]) {
        const Room& next = scene.rooms[number];
        const auto low = [&](int axis) { return std::max(room.low(axis), next.low(axis)); };
        const auto high = [&](int axis) { return std::min(room.high(axis), next.high(axis)); };
        const int axis = face_axis(face);
        const int at = face == 2 * axis ? room.high(axis) : room.low(axis);
        if (axis == right_)
          canvas.line(x(at), y(low(down_)), x(at), y(high(down_)), PlanColours::Portal);
        else if (axis == down_)
          canvas.line(x(low(right_)), y(at), x(high(right_)), y(at), PlanColours::Portal);
        else
          canvas.frame(x(low(right_)), std::min(y(low(down_)), y(high(down_))), x(high(right_)),
                       std::max(y(low(down_)), y(high(down_))), PlanColours::Portal);
      }
  }

  void draw_way(const SceneFile& scene, const CameraPath& path, Canvas& canvas,
                const std::string& set) const {
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const PathPoint& point = path.points[i];
      const Room& room = scene.rooms[point.room];
      if (room.set != set) continue;
      const int px = x(room.centre[right_] + point.position[right_]);
      const int py = y(room.centre[down_] + point.position[down_]);
      canvas.fill(px, py, px + 1, py + 1, PlanColours::Way);
    }
    const PathPoint& first = path.points.front();
    const Room& room = scene.rooms[first.room];
    const int px = x(room.centre[right_] + first.position[right_]);
    const int py = y(room.centre[down_] + first.position[down_]);
    canvas.fill(px - StartSize, py - StartSize, px + StartSize, py + StartSize, PlanColours::Start);
  }

  int right_, down_, depth_;
  bool flip_;  // large values up
  Vector low_{}, high_{};
  double scale_ = 1;
  int top_ = 0;
};

}  // namespace

Canvas draw_plan(const SceneFile& scene) {
  const CameraPath path = fly(scene);
  const std::string& set = scene.rooms[path.points.front().room].set;
  std::vector<int> rooms;
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    if (scene.rooms[i].set == set) rooms.push_back(static_cast<int>(i));
  View above(scene, rooms, 0, 2, true), beside(scene, rooms, 0, 1, false);
  const double scale =
      std::min(1.0, static_cast<double>(Largest) / std::max(above.largest(), beside.largest()));
  above.scale_to(scale);
  beside.scale_to(scale);
  beside.move_to(above.height());
  Canvas canvas(above.width(), above.height() + beside.height(), PlanColours::Paper);
  above.draw(scene, rooms, path, canvas, set);
  beside.draw(scene, rooms, path, canvas, set);
  return canvas;
}

}  // namespace racebeam
