// PlanGrid: where the columns and rows of a plan stand, and how wide they are.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tb/scene/plan_rows.h"
#include "tb/scene/plan_style.h"

namespace racebeam {

/// Of columns from the west [0] and of rows from the south [1].
struct PlanGrid {
  std::array<std::vector<int>, 2> edges;    ///< even
  std::array<std::vector<int>, 2> middles;  ///< on the axes x and z

  /// The distance between the closest cells; that of a lone cell is its edge. A shaft may be wider
  /// than its cell, but no wider than this: those of neighbours would overlap.
  int closest() const;
};

/// The grid of a drawing. Lists of edges that are longer than the drawing are faults, and so is an
/// opening wider than closest().
PlanGrid lay_out(const TableReader& plan, const PlanStyle& style, const PlanRows& rows);

}  // namespace racebeam
