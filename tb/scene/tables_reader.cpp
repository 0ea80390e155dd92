// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/tables_reader.h"

#include <fmt/format.h>

#include "tb/base/counted.h"

namespace racebeam {

const std::vector<TomlNode>& TablesReader::items(const std::string& kind, int most,
                                                 const std::string& why) const {
  static const std::vector<TomlNode> none;
  const TomlNode* node = root_.find(kind);
  if (!node) return none;
  if (node->kind != TomlNode::Array) {
    wrong_type(*node, kind, "tables: write [[" + kind + "]]", faults_);
    return none;
  }
  const int count = static_cast<int>(node->items.size());
  if (count > most)
    faults_.add(node->items[static_cast<std::size_t>(most)].place,
                "the scene has " + counted(count, kind.c_str()),
                "at most " + std::to_string(most) + (why.empty() ? "" : ": " + why));
  return node->items;
}

void TablesReader::check_id(const TableReader& from) {
  std::string id;
  if (!from.read("id", id)) return;
  const Place at = from.find("id")->place;
  const auto [first, fresh] = ids_.emplace(id, at.line);
  if (!fresh)
    faults_.add(
        at, "two spheres are called " + quoted(id),
        "the first is in line " + std::to_string(first->second) + "; give each a name of its own");
}

void TablesReader::read_box(const TableReader& box, MotionBox& walls) const {
  place(box, "low", walls.low);
  place(box, "high", walls.high);
  for (std::size_t n = 0; n < 3; ++n)
    if (walls.low[n] > walls.high[n]) {
      faults_.add(box.place(), fmt::format("'low' is above 'high' in {}", "xyz"[n]),
                  "the box goes from low to high in each axis");
      return;
    }
}

void TablesReader::expect_spheres(bool some, const std::string& engine) const {
  if (some || !faults_.none()) return;
  faults_.add({1, 1}, "the scene has no spheres",
              "write [[sphere]]; `racebeam scene new --engine " + engine +
                  " FILE` makes a file to start from");
}

void TablesReader::check_inside(const Place& at, const Vector3& centre,
                                const MotionBox& box) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (centre[k] < box.low[k] || centre[k] > box.high[k]) {
      faults_.warn(at, "the sphere stands outside of the box",
                   "in picture 1 it jumps to the wall; make the [box] larger");
      return;
    }
}

}  // namespace racebeam
