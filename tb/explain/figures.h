// Figures of what the tracer computes, drawn from the numbers of one pixel of a show.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/show/show.h"

namespace racebeam {

/// What a figure is drawn of.
struct FigureSubject {
  const Show& show;
  const knobs k;
  const int frame, y;  ///< y: -240..239
  const int pixel;     ///< 0..639
};

struct Figure {
  const char* name;
  const char* meaning;
  /// The whole SVG file. Throws UsageError if the subject has nothing of the kind.
  std::string (*draw)(const FigureSubject&);
};

/// All of them.
const std::vector<Figure>& figures();

/// Their names, "hexagon, portal".
std::string figure_names();

/// Throws UsageError that names the nearest.
const Figure& figure(const std::string& name);

}  // namespace racebeam
