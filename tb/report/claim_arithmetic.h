// Claims about arithmetic: the chip's own functions over all that may be put into them.
//
// No frame is rendered and nothing is sampled: milliseconds, and no interval.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/beam/knobs.h"

namespace racebeam {

struct ArithmeticFigure {
  const char* name;
  double (*value)(const knobs& k);  ///< of a chip
};

const std::vector<ArithmeticFigure>& arithmetic_figures();
/// nullptr: there is none of that name.
const ArithmeticFigure* arithmetic_figure(const std::string& name);

}  // namespace racebeam
