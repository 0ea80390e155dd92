// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/figures.h"

#include "tb/base/nearest.h"
#include "tb/explain/figure_parts.h"

namespace racebeam {

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all = {
      {"hexagon", "a room as the ray sees it, and the two questions that find its way out",
       draw_hexagon},
      {"portal", "the face that the ray meets, and the four edges of the portal in it",
       draw_portal},
      {"decision-tree", "the six questions of a room, and how the pixel answered them", draw_tree},
      {"ray-pyramid", "the rays of a frame, and of one line", draw_pyramid},
      {"step-table", "what each bit of a pixel's number adds to its ray", draw_steps},
      {"pins", "a line as it leaves the pins, in each of its clocks", draw_pins},
      {"platform", "the chip in a virtual platform, and what goes over its sockets", draw_platform},
  };
  return all;
}

std::string figure_names() {
  std::string names;
  for (const Figure& one : figures()) names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names;
}

const Figure& figure(const std::string& name) {
  std::vector<std::string> known;
  for (const Figure& one : figures()) {
    if (one.name == name) return one;
    known.emplace_back(one.name);
  }
  throw unknown_name("figure", name, known);
}

}  // namespace racebeam
