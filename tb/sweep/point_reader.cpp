// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/point_reader.h"

#include <algorithm>
#include <map>
#include <string>

#include "tb/scene/engines.h"
#include "tb/scene/table_reader.h"
#include "tb/sweep/knob_reader.h"
#include "tb/sweep/sweep_keys.h"

namespace racebeam {

namespace {

/// "p31": as the points of a search are called.
bool is_number_of_search(const std::string& name) {
  return name.size() > 1 && name[0] == 'p' &&
         std::all_of(name.begin() + 1, name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// The name of a point that others do not have; a fault if it is none.
void read_name(const TableReader& table, std::map<std::string, int>& lines, std::string& to) {
  if (!table.read("name", to)) return;
  const Place place = table.find("name")->place;
  if (is_number_of_search(to))
    table.faults().add(place, "the name " + quoted(to) + " is one of the search's points",
                       "choose another than p and a number");
  const auto [known, is_new] = lines.emplace(to, place.line);
  if (!is_new)
    table.faults().add(
        place, "the name " + quoted(to) + " is used twice",
        "the other one is " + (known->second > 0 ? "in line " + std::to_string(known->second)
                                                 : std::string("the base point")));
}

void read_base(const TomlNode& node, SweepPoint& base, std::map<std::string, int>& lines,
               Faults& faults) {
  const TableReader table(node, "base", faults, sweep_keys());
  if (const TomlNode* given = table.find("knobs")) read_point_knobs(*given, base, faults);
  if (base.k != engine_of(base.k).standard(nullptr)) base.name = "base";
  read_name(table, lines, base.name);
}

}  // namespace

void read_points(const TomlNode* base, const TomlNode* points, SweepFile& file, Faults& faults) {
  std::map<std::string, int> lines;  // of names
  if (base) read_base(*base, file.base, lines, faults);
  lines.emplace(file.base.name, 0);
  if (!points) return;
  if (points->kind != TomlNode::Array) {
    wrong_type(*points, "point", "written below a line [[point]]", faults);
    return;
  }
  for (const TomlNode& item : points->items) {
    const TableReader table(item, "point", faults, sweep_keys());
    if (item.kind != TomlNode::Table) continue;
    SweepPoint point = file.base;
    point.name.clear();
    table.require("name", "it tells the point from others: name = \"no limits\"");
    read_name(table, lines, point.name);
    if (const TomlNode* given = table.find("knobs")) read_point_knobs(*given, point, faults);
    file.points.push_back(point);
  }
}

}  // namespace racebeam
