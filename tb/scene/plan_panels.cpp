// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_panels.h"

#include <utility>

namespace racebeam {

namespace {

constexpr double LargestPanel = 900, LargestOfMany = 660;  // pixels
constexpr double LargestScale = 1.25;                      // pixels per unit
constexpr double SheetWidth = 1500, Title = 26, Head = 84;

std::string set_title(const std::string& set) { return set.empty() ? "" : "set " + set + ", "; }

}  // namespace

PlanSheet::PlanSheet(const SceneFile& scene, const std::vector<Storey>& storeys)
    : scene_(scene), storeys_(storeys) {
  for (std::size_t i = 0; i < storeys_.size(); ++i) {
    add_storey(static_cast<int>(i));
    if (i + 1 == storeys_.size() || storeys_[i + 1].set != storeys_[i].set)
      add_side(storeys_[i].set);
  }
  place_panels();
}

void PlanSheet::measure(PlanPanel& panel, const std::vector<int>& rooms) const {
  for (int axis = 0; axis < 3; ++axis) {
    panel.low.push_back(scene_.rooms[rooms[0]].low(axis));
    panel.high.push_back(scene_.rooms[rooms[0]].high(axis));
    for (const int room : rooms) {
      panel.low[axis] = std::min(panel.low[axis], scene_.rooms[room].low(axis));
      panel.high[axis] = std::max(panel.high[axis], scene_.rooms[room].high(axis));
    }
  }
}

// All storeys of a set are drawn in the same frame, so that they can be laid on each other.
void PlanSheet::add_storey(int number) {
  const Storey& storey = storeys_[number];
  PlanPanel panel;
  panel.title = set_title(storey.set) + "storey " + std::to_string(storey.number);
  panel.storey = number;
  panel.rooms = storey.rooms;
  measure(panel, rooms_of(storey.set));
  panels.push_back(std::move(panel));
}

void PlanSheet::add_side(const std::string& set) {
  PlanPanel panel;
  panel.title = set_title(set) + "from the south";
  panel.down = 1;
  panel.up = false;
  panel.rooms = rooms_of(set);
  std::stable_sort(panel.rooms.begin(), panel.rooms.end(), [&](int a, int b) {
    return scene_.rooms[a].centre[2] > scene_.rooms[b].centre[2];
  });
  measure(panel, panel.rooms);
  panels.push_back(std::move(panel));
}

std::vector<int> PlanSheet::rooms_of(const std::string& set) const {
  std::vector<int> rooms;
  for (std::size_t i = 0; i < scene_.rooms.size(); ++i)
    if (scene_.rooms[i].set == set) rooms.push_back(static_cast<int>(i));
  return rooms;
}

// In rows from the left, all in one scale.
void PlanSheet::place_panels() {
  double scale = LargestScale, right = 0;
  const double largest = panels.size() > 2 ? LargestOfMany : LargestPanel;
  for (const PlanPanel& panel : panels)
    scale = std::min(scale, largest / std::max(panel.width(), panel.height()));
  double x = Margin, y = Head, row = 0;
  for (PlanPanel& panel : panels) {
    panel.scale = scale;
    const double space = std::max(panel.width(), 160.0) + 2 * Margin;
    if (x > Margin && x + space > SheetWidth) {
      y += row;
      x = Margin, row = 0;
    }
    panel.left = x;
    panel.top = y + Title;
    x += space;
    row = std::max(row, panel.height() + Title + Margin);
    right = std::max(right, x - Margin);
  }
  width = static_cast<int>(std::ceil(std::max(right, 760.0)));
  height = static_cast<int>(std::ceil(y + row));
}

}  // namespace racebeam
