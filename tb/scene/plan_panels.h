// Panels of a plan: which rooms are seen from where, and their places on the sheet.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tb/scene/plan_pen.h"
#include "tb/scene/plan_storeys.h"

namespace racebeam {

/// A view of some rooms: the axes of the scene that go right and down on the sheet.
struct PlanPanel {
  std::string title;
  int right = 0, down = 2;
  bool up = true;  // large values of `down` are up
  int storey = -1;
  std::vector<int> rooms;       // drawn as boxes, from back to front
  std::vector<int> low, high;   // of all that is drawn, per axis
  double scale = 1;             // pixels per unit
  double left = 0, top = 0;     // of the drawing
  std::vector<Box> taken = {};  // by words

  double width() const { return (high[right] - low[right]) * scale; }
  double height() const { return (high[down] - low[down]) * scale; }
  Dot at(const Vector& place) const {
    const int y = up ? high[down] - place[down] : place[down] - low[down];
    return {left + (place[right] - low[right]) * scale, top + y * scale};
  }
  Box box(const Vector& from, const Vector& to) const {
    const Dot a = at(from), b = at(to);
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(b.x - a.x), std::abs(b.y - a.y)};
  }
};

/// A sheet with all panels of a scene. Lengths are pixels.
struct PlanSheet {
  static constexpr double Margin = 26;  ///< around a panel

  PlanSheet(const SceneFile& scene, const std::vector<Storey>& storeys);

  std::vector<PlanPanel> panels;
  int width = 0, height = 0;

 private:
  void measure(PlanPanel& panel, const std::vector<int>& rooms) const;
  void add_storey(int number);
  void add_side(const std::string& set);
  std::vector<int> rooms_of(const std::string& set) const;
  void place_panels();

  const SceneFile& scene_;
  const std::vector<Storey>& storeys_;
};

}  // namespace racebeam
