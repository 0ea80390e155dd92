// PlanPen: what a drawing of a scene is made of, on a sheet of cairo's. Lengths are pixels.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "tb/scene/plan_drawing.h"

namespace racebeam {

struct Ink {
  double r, g, b;
};

struct Box {
  double left, top, width, height;

  bool meets(const Box& other) const;
  double middle_x() const { return left + width / 2; }
  double middle_y() const { return top + height / 2; }
};

struct Dot {
  double x, y;
};

class PlanPen {
 public:
  PlanPen(PlanFormat format, int width, int height);

  void fill(const Box& box, Ink ink);
  void frame(const Box& box, Ink ink, double thick, bool dashed = false);
  /// A line through all of them; a single one is a point.
  void line(const std::vector<Dot>& dots, Ink ink, double thick);
  void circle(Dot middle, double radius, Ink inside, Ink edge);
  /// A triangle that points up or, with a negative height, down.
  void triangle(Dot middle, double width, double height, Ink ink);

  /// Size of a text: width, and height of its letters.
  Dot size(const std::string& text, double letters, bool bold = false);
  /// Writes a text around a point, on a pale ground; `turned`: upwards.
  void text(Dot middle, const std::string& text, double letters, Ink ink, bool bold = false,
            bool turned = false);

  /// The whole file. Throws std::runtime_error.
  std::string finish();

 private:
  void ink(Ink ink);
  void font(double letters, bool bold);

  struct End {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* sheet) const { cairo_destroy(sheet); }
  };
  const PlanFormat format_;
  std::string bytes_;
  std::unique_ptr<cairo_surface_t, End> surface_;
  std::unique_ptr<cairo_t, End> sheet_;
};

}  // namespace racebeam
