// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/plan_grid.h"

#include <algorithm>
#include <limits>

namespace racebeam {

int PlanGrid::closest() const {
  int distance = std::numeric_limits<int>::max();
  for (int i = 0; i < 2; ++i) {
    if (middles[i].size() == 1) distance = std::min(distance, edges[i][0]);
    for (std::size_t n = 1; n < middles[i].size(); ++n)
      distance = std::min(distance, middles[i][n] - middles[i][n - 1]);
  }
  return distance;
}

PlanGrid lay_out(const TableReader& plan, const PlanStyle& style, const PlanRows& rows) {
  static const char* const keys[2] = {"widths", "depths"};
  const int counts[2] = {rows.columns, rows.rows};
  PlanGrid grid;
  for (int i = 0; i < 2; ++i) {
    const std::vector<int>& listed = style.edges[i];
    if (static_cast<int>(listed.size()) > counts[i])
      plan.faults().add(plan.find(keys[i])->place,
                        std::string("'") + keys[i] + "' has " + std::to_string(listed.size()) +
                            " numbers for " + std::to_string(counts[i]) +
                            (i == 0 ? " columns" : " rows"),
                        "write one for each, or the first ones, which repeat");
    int middle = style.origin[2 * i];
    for (int n = 0; n < counts[i]; ++n) {
      const int edge = listed[n % listed.size()];
      if (n > 0) middle += (grid.edges[i].back() + edge) / 2;
      grid.edges[i].push_back(edge);
      grid.middles[i].push_back(middle);
    }
  }
  if (style.opening > grid.closest())
    plan.faults().add(plan.find("opening")->place, "'opening' is too large for the cells",
                      "it must be at most " + std::to_string(grid.closest() / 2 * 2) +
                          ", the distance from cell to cell");
  return grid;
}

}  // namespace racebeam
