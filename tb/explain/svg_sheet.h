// SvgSheet: a drawing as SVG text, the same bytes on every machine. Lengths are pixels.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct SvgPoint {
  double x, y;
};

class SvgSheet {
 public:
  /// `title` is what a screen reader says.
  SvgSheet(double width, double height, const std::string& title);

  /// Colours are "#rrggbb" or "none".
  void polygon(const std::vector<SvgPoint>& points, const std::string& fill,
               const std::string& stroke, double thick = 1);
  void line(SvgPoint from, SvgPoint to, const std::string& stroke, double thick,
            bool dashed = false);
  void circle(SvgPoint middle, double radius, const std::string& fill);
  enum class Anchor { Start, Middle, End };
  /// `at`: the middle of the letters' height.
  void text(SvgPoint at, const std::string& text, Anchor anchor = Anchor::Middle,
            double letters = 13, const std::string& fill = "#1a1c20", bool bold = false);

  /// The whole file.
  std::string finish();

 private:
  std::string body_;
};

}  // namespace racebeam
