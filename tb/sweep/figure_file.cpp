// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/figure_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tb/judge/error_causes.h"
#include "tb/sweep/export.h"
#include "tb/sweep/figures.h"

namespace racebeam {

namespace {

constexpr int AllScenes = -1;

bool is_cause(const PointFigure& figure, PictureReference reference) {
  const auto& causes = error_causes(reference);
  return std::any_of(causes.begin(), causes.end(), [&](const ErrorCause& cause) {
    return figure.terms.front().column == cause.name;
  });
}

std::string cell(double number) {
  return std::isfinite(number) ? fmt::format("{:.7g}", number) : "";
}

// ",value,half width"
std::string cells(const Estimate& estimate) {
  return "," + cell(estimate.value) + "," + cell(estimate.half_width);
}

Strata of_scene(const PointReading& read, int scene) {
  if (scene == AllScenes) return read.reading.frames;
  return {read.reading.frames[static_cast<std::size_t>(scene)]};
}

// ",frames,value,half width,change,half width"
std::string numbers(const PointFigure& figure, const PointReading& of, const PointReading& base,
                    int scene) {
  if (figure.kind == PointFigure::Exact)
    return ",," + cell(of.reading.exact) + ",," + cell(of.reading.exact - base.reading.exact) + ",";
  const Strata strata = of_scene(of, scene);
  if (!figure.sampled()) {
    const Worst worst = worst_of(strata);
    return fmt::format(",{},{},,,", worst.frames, cell(worst.value));
  }
  const Estimate mean = mean_of(strata);
  return fmt::format(",{}{}{}", mean.frames, cells(mean),
                     cells(difference_of(strata, of_scene(base, scene))));
}

}  // namespace

std::vector<const PointFigure*> sweep_figures(const SweepFile& file) {
  std::vector<const PointFigure*> figures;
  for (const PointFigure& figure : figure_table())
    if (figure.is_of(*file.built) && (!figure.of_cause || is_cause(figure, file.measure.reference)))
      figures.push_back(&figure);
  return figures;
}

std::string figures_csv(const SweepPlan& plan, const Measurer& measurer, const SweepState& state,
                        int frames) {
  const std::vector<const PointFigure*> figures = sweep_figures(plan.file);
  std::string text = "point,scene,figure,unit,frames,value,half_width,change,change_half_width\n";
  const std::vector<PointReading> base = state.read(0, figures, frames);
  const int scenes = static_cast<int>(plan.scenes.size());
  for (int point = 0; point < static_cast<int>(plan.points.size()); ++point) {
    if (!measurer.failure(point).empty()) continue;
    const std::vector<PointReading> readings = state.read(point, figures, frames);
    const std::string name = csv_cell(plan.points[static_cast<std::size_t>(point)].point.name);
    for (int scene = scenes > 1 ? AllScenes : 0; scene < scenes; ++scene) {
      const std::string of =
          scene == AllScenes ? "all" : csv_cell(plan.scenes[static_cast<std::size_t>(scene)].name);
      for (std::size_t i = 0; i < figures.size(); ++i)
        if (readings[i].there && base[i].there)
          text += fmt::format("{},{},{},{}{}\n", name, of, figures[i]->name, figures[i]->unit,
                              numbers(*figures[i], readings[i], base[i], scene));
    }
  }
  return text;
}

}  // namespace racebeam
