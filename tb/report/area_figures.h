// What yosys counted of an engine's RTL, all units wired: `scripts/area --write` measures it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/knob_values.h"

namespace racebeam {

struct AreaFigures {
  std::string engine, top;
  std::string parameters;  ///< "Cores=1": those that are not as in the RTL; ""
  int registers, cells;
};

/// A line each of tb/report/area_figures.inc.
const std::vector<AreaFigures>& area_table();

/// Of a chip with these knobs; nullptr: nobody measured that.
const AreaFigures* area_of(const knob_values& k);

}  // namespace racebeam
