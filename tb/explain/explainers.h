// How a pixel is explained, in a row for each engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/show/run.h"

namespace racebeam {

/// Which pixel; it is in the picture.
struct ExplainedPixel {
  int frame, column, row;
};

struct Explainer {
  struct Size {
    int columns, rows;
  };
  const racebeam::engine& engine;
  /// Of a picture.
  Size (*size)(const Run& run, int frame);
  /// For people and for programs. `repeat`: the command line's scene and knobs.
  std::string (*text)(const Run& run, const ExplainedPixel& pixel, const std::string& repeat);
  std::string (*json)(const Run& run, const ExplainedPixel& pixel, const std::string& repeat);
};

const std::vector<Explainer>& explainers();

/// The row of an engine; nullptr: it has none.
const Explainer* explainer_of(const engine& built);

}  // namespace racebeam
