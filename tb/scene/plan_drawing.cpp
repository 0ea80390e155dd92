// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_drawing.h"

#include <algorithm>
#include <cmath>

#include "tb/scene/plan_panels.h"
#include "tb/scene/plan_storeys.h"

namespace racebeam {

namespace {

constexpr Ink Wall{0.25, 0.27, 0.30}, Low{0.93, 0.95, 0.97}, High{0.74, 0.81, 0.89};
constexpr Ink Door{0.13, 0.62, 0.33}, Vertical{0.13, 0.35, 0.75}, Way{0.84, 0.20, 0.12};
constexpr Ink Begin{1.0, 0.83, 0.25}, Words{0.1, 0.1, 0.12}, Pale{0.45, 0.47, 0.5};
constexpr double Margin = PlanSheet::Margin;
constexpr double Letters = 12, SmallestLetters = 8;
constexpr int MostMarks = 40;

Vector lows(const Room& room) { return {room.low(0), room.low(1), room.low(2)}; }
Vector highs(const Room& room) { return {room.high(0), room.high(1), room.high(2)}; }

class Drawing {
 public:
  explicit Drawing(const SceneFile& scene)
      : scene_(scene),
        storeys_(storeys_of(scene)),
        strands_(strands_of(scene, fly(scene), storeys_)),
        sheet_(scene, storeys_) {
    while (scene.frames / step_ > MostMarks) step_ = next_step(step_);
  }

  PlanDrawing draw(PlanFormat format) {
    PlanPen pen(format, sheet_.width, sheet_.height);
    draw_head(pen);
    for (PlanPanel& panel : sheet_.panels) draw_panel(pen, panel);
    return {pen.finish(), sheet_.width, sheet_.height};
  }

 private:
  // 1, 2, 5, 10, 20 ...
  static int next_step(int step) {
    int power = 1;
    while (step >= 10 * power) power *= 10;
    return step / power == 2 ? 5 * power : 2 * step;
  }

  void draw_head(PlanPen& pen) const {
    left_text(pen, {Margin, 24}, scene_.name, 18, Words, true);
    double x = Margin;
    const double y = 52;
    const auto say = [&](const char* words) {
      x = left_text(pen, {x + 6, y}, words, Letters, Words) + 20;
    };
    pen.line({{x, y}, {x += 20, y}}, Door, 3);
    say("portal");
    for (const bool up : {true, false}) {
      pen.frame({x, y - 7, 14, 14}, Vertical, 1, true);
      pen.triangle({x + 7, y}, 8, up ? 8 : -8, Vertical);
      x += 14;
      say(up ? "way up" : "way down");
    }
    pen.line({{x, y}, {x += 20, y}}, Way, 1.5);
    pen.circle({x - 10, y}, 2, Way, Way);
    say("camera, with frame");
    pen.circle({x + 5, y}, 4, Begin, Way);
    x += 10;
    say("set down by a shot");
    draw_scale(pen);
  }

  void draw_scale(PlanPen& pen) const {
    const double scale = sheet_.panels.front().scale;
    int units = 1;
    while (units * scale < 60) units = next_step(units);
    const double right = sheet_.width - Margin - 40, left = right - units * scale, y = 30;
    pen.line({{left, y - 4}, {left, y}, {right, y}, {right, y - 4}}, Words, 1.5);
    pen.text({(left + right) / 2, y - 11}, std::to_string(units) + " units", Letters, Words);
    pen.triangle({sheet_.width - Margin - 8, 24}, 12, 22, Words);
    pen.text({sheet_.width - Margin - 8, 46}, "N", Letters, Words, true);
  }

  // The end of the text.
  static double left_text(PlanPen& pen, Dot left, const std::string& text, double letters, Ink ink,
                          bool bold = false) {
    const double width = pen.size(text, letters, bold).x;
    pen.text({left.x + width / 2, left.y}, text, letters, ink, bold);
    return left.x + width;
  }

  void draw_panel(PlanPen& pen, PlanPanel& panel) {
    left_text(pen, {panel.left, panel.top - 13}, panel.title, Letters + 1, Words, true);
    for (const int room : panel.rooms) draw_room(pen, panel, scene_.rooms[room]);
    for (const int room : panel.rooms) draw_portals(pen, panel, scene_.rooms[room]);
    for (const Strand& strand : strands_)
      if (shows(panel, strand)) draw_way(pen, panel, strand);
    if (panel.storey < 0) return;
    for (const int room : panel.rooms) draw_name(pen, panel, scene_.rooms[room]);
    for (const bool jumps : {true, false})  // those are the more important ones
      for (const Strand& strand : strands_)
        if (shows(panel, strand)) draw_marks(pen, panel, strand, jumps);
  }

  bool shows(const PlanPanel& panel, const Strand& strand) const {
    if (panel.storey >= 0) return strand.storey == panel.storey;
    return storeys_[strand.storey].set == scene_.rooms[panel.rooms[0]].set;
  }

  void draw_room(PlanPen& pen, const PlanPanel& panel, const Room& room) const {
    int lowest = room.high(1), highest = room.high(1);
    for (const int other : panel.rooms) {
      lowest = std::max(lowest, scene_.rooms[other].high(1));
      highest = std::min(highest, scene_.rooms[other].high(1));
    }
    const double share =
        lowest == highest ? 0 : static_cast<double>(lowest - room.high(1)) / (lowest - highest);
    const auto mix = [&](double low, double high) { return low + (high - low) * share; };
    const Box box = panel.box(lows(room), highs(room));
    pen.fill(box, {mix(Low.r, High.r), mix(Low.g, High.g), mix(Low.b, High.b)});
    pen.frame(box, Wall, 1);
  }

  void draw_portals(PlanPen& pen, const PlanPanel& panel, const Room& room) const {
    for (int face = 0; face < FaceCount; ++face)
      for (const int number : room.portals[face]) {
        const Room& next = scene_.rooms[number];
        const int axis = face_axis(face);
        Vector from, to;
        for (int i = 0; i < 3; ++i) {
          from[i] = std::max(room.low(i), next.low(i));
          to[i] = std::min(room.high(i), next.high(i));
          if (from[i] > to[i]) from[i] = room.low(i), to[i] = room.high(i);  // it leads elsewhere
        }
        from[axis] = to[axis] = face == 2 * axis ? room.high(axis) : room.low(axis);
        if (axis == panel.right || axis == panel.down)
          pen.line({panel.at(from), panel.at(to)}, Door, 3);
        else if (axis == 1) draw_vertical(pen, panel.box(from, to), face == Up);
      }
  }

  static void draw_vertical(PlanPen& pen, const Box& box, bool up) {
    const double size = std::min({9.0, box.width / 3, box.height / 3});
    pen.frame(box, Vertical, 1, true);
    // In the upper left corner or beside it, for there may be a way down in the same place.
    pen.triangle({box.left + size * (up ? 1 : 2.2), box.top + size}, size, up ? size : -size,
                 Vertical);
  }

  void draw_way(PlanPen& pen, const PlanPanel& panel, const Strand& strand) const {
    std::vector<Dot> dots;
    const auto bends = [&](std::size_t i) {
      if (i == 0 || i + 1 == strand.points.size()) return true;
      for (int axis = 0; axis < 3; ++axis)
        if (strand.points[i].place[axis] - strand.points[i - 1].place[axis] !=
            strand.points[i + 1].place[axis] - strand.points[i].place[axis])
          return true;
      return false;
    };
    for (std::size_t i = 0; i < strand.points.size(); ++i)
      if (bends(i)) dots.push_back(panel.at(strand.points[i].place));
    pen.line(dots, Way, 1.5);
  }

  // Smaller and smaller letters, then upwards, then not at all.
  void draw_name(PlanPen& pen, PlanPanel& panel, const Room& room) const {
    const std::string& set = room.set;
    const bool prefixed = !set.empty() && room.id.rfind(set + ".", 0) == 0;
    const std::string name = prefixed ? room.id.substr(set.size() + 1) : room.id;
    const Box box = panel.box(lows(room), highs(room));
    const bool numbered = name.find_first_not_of("0123456789.") == std::string::npos;
    for (const bool turned : {false, true})
      for (double letters = Letters; letters >= SmallestLetters; --letters) {
        const Dot size = pen.size(name, letters);
        const double width = turned ? size.y : size.x, height = turned ? size.x : size.y;
        if (width + 10 > box.width || height + 10 > box.height) continue;
        // In the corner, since the camera mostly flies through the middle.
        const Box place{box.left + 5, box.top + box.height - height - 5, width, height};
        pen.text({place.middle_x(), place.middle_y()}, name, letters, numbered ? Pale : Words,
                 false, turned);
        panel.taken.push_back(place);
        return;
      }
  }

  void draw_marks(PlanPen& pen, PlanPanel& panel, const Strand& strand, bool jumps) const {
    for (const StrandPoint& point : strand.points) {
      const bool begins = strand.jumps && &point == &strand.points.front();
      if (begins != jumps || (!begins && point.frame % step_ != 0)) continue;
      const Dot at = panel.at(point.place);
      if (begins) pen.circle(at, 4, Begin, Way);
      else pen.circle(at, 2, Way, Way);
      label(pen, panel, at, std::to_string(point.frame), begins);
    }
  }

  // Beside a mark, where there is room for it.
  static void label(PlanPen& pen, PlanPanel& panel, Dot at, const std::string& text, bool bold) {
    const double letters = 10, gap = 4;
    const Dot size = pen.size(text, letters, bold);
    const double aside = size.x / 2 + gap + 2, away = size.y / 2 + gap;
    for (const Dot shift :
         {Dot{aside, 0}, Dot{-aside, 0}, Dot{0, -away}, Dot{0, away}, Dot{aside, -away},
          Dot{-aside, -away}, Dot{aside, away}, Dot{-aside, away}}) {
      const Box box{at.x + shift.x - size.x / 2, at.y + shift.y - size.y / 2, size.x, size.y};
      if (std::any_of(panel.taken.begin(), panel.taken.end(),
                      [&](const Box& other) { return box.meets(other); }))
        continue;
      panel.taken.push_back(box);
      pen.text({box.middle_x(), box.middle_y()}, text, letters, Way, bold);
      return;
    }
  }

  const SceneFile& scene_;
  const std::vector<Storey> storeys_;
  const std::vector<Strand> strands_;
  PlanSheet sheet_;
  int step_ = 10;  // frames from mark to mark
};

}  // namespace

PlanDrawing draw_plan(const SceneFile& scene, PlanFormat format) {
  return Drawing(scene).draw(format);
}

}  // namespace racebeam
