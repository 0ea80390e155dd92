// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_figures.h"

#include <algorithm>

#include "sc/beam/engine.h"
#include "tb/report/claim_arithmetic.h"
#include "tb/report/claim_golden.h"
#include "tb/sweep/figures.h"

namespace racebeam {

std::optional<SiliconFigure> silicon_figure(const std::string& figure) {
  const std::size_t dot = figure.find('.');
  const std::string what = figure.substr(0, dot);
  const std::string unit = dot == std::string::npos ? "" : figure.substr(dot + 1);
  if (figure == "longest_path") return SiliconFigure{SiliconFigure::LongestPath, ""};
  if (what != "flip_flops" && what != "cells") return {};
  if (dot != std::string::npos && !beam_engine().unit(unit)) return {};
  return SiliconFigure{what == "cells" ? SiliconFigure::Cells : SiliconFigure::FlipFlops, unit};
}

std::optional<ClaimSource> claim_source(const std::string& figure) {
  if (silicon_figure(figure)) return ClaimSource::Silicon;
  if (arithmetic_figure(figure)) return ClaimSource::Arithmetic;
  if (golden_figure(figure)) return ClaimSource::Golden;
  const PointFigure* const of_frames = figure_named(figure, beam_engine());
  if (of_frames && of_frames->sampled() && !of_frames->of_cause) return ClaimSource::Frames;
  return {};
}

std::vector<std::string> claim_figure_names() {
  std::vector<std::string> names = {"cells", "flip_flops", "longest_path"};
  for (const ArithmeticFigure& figure : arithmetic_figures()) names.emplace_back(figure.name);
  for (const GoldenSet& set : golden_sets())
    names.insert(names.end(), set.columns.begin(), set.columns.end());
  for (const PointFigure& figure : figure_table())
    if (claim_source(figure.name) == ClaimSource::Frames) names.push_back(figure.name);
  return names;
}

}  // namespace racebeam
