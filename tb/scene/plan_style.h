// PlanStyle: what the keys of a [plan] say of its cells, apart from the drawing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "tb/scene/plan_rows.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

/// A kind of cell.
struct CellKind {
  int height = 512;       ///< even
  int floor = 0;          ///< above that of the storey, even
  bool skylight = false;  ///< opens the ceiling
  bool hole = false;      ///< opens the floor
  std::string id{};       ///< empty: named by its place
};

struct PlanStyle {
  /// Of columns from the west, of rows from the south; even. They repeat.
  std::array<std::vector<int>, 2> edges{{{256}, {256}}};
  int height = 512;                  ///< of a cell, even
  int slab = 32;                     ///< between storeys, even
  int opening = 192;                 ///< edge of skylights and floor holes, even
  Vector origin{};                   ///< floor of the lowest south-west cell, in its middle
  std::string set;                   ///< of all its rooms
  std::map<Letter, CellKind> kinds;  ///< '.', '@' and those of plan.cells

  /// `name` as rooms of this plan are called: after the set, if that has a name.
  std::string named(const std::string& name) const { return set.empty() ? name : set + "." + name; }
};

/// Reads all keys of a [plan] but 'storeys'. Faults leave the standard values.
PlanStyle read_style(const TableReader& plan);

}  // namespace racebeam
