// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/point_reading.h"

#include <algorithm>

namespace racebeam {

namespace {

// Of the first frames that may be taken, and guard frames; one may be both.
std::vector<FrameRow> rows_of(const FrameTable& table, const SceneFrames& scene,
                              const std::vector<std::string>& columns, bool causes, int frames) {
  const std::vector<int>& order = *scene.order;
  const auto taken = std::min(order.size(), static_cast<std::size_t>(frames));
  std::vector<int> first(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(taken));
  std::sort(first.begin(), first.end());
  std::vector<FrameRow> rows =
      causes ? table.read_causes(scene.key, columns) : table.read(scene.key, columns);
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [&](FrameRow& row) {
                              const bool sample =
                                  std::binary_search(first.begin(), first.end(), row.frame);
                              row.guard = row.guard && !sample;
                              return !sample && !row.guard;
                            }),
             rows.end());
  return rows;
}

}  // namespace

Reading::Kind reading_kind(const PointFigure& figure) {
  if (figure.kind == PointFigure::Exact) return Reading::Exact;
  return figure.sampled() ? Reading::Sampled : Reading::Largest;
}

std::vector<PointReading> read_figures(const FrameTable& table,
                                       const std::vector<SceneFrames>& scenes,
                                       const std::vector<const PointFigure*>& figures, int frames) {
  std::vector<std::string> columns[2];  // of frames, and causes
  std::vector<PointReading> all;
  for (const PointFigure* figure : figures) {
    PointReading& result = all.emplace_back();
    result.there = figure->kind != PointFigure::Exact;
    result.reading.kind = reading_kind(*figure);
    for (const std::string& column : figure->columns())
      if (auto& names = columns[figure->of_cause];
          std::find(names.begin(), names.end(), column) == names.end())
        names.push_back(column);
  }
  for (const SceneFrames& scene : scenes)
    for (const bool causes : {false, true}) {
      if (columns[causes].empty()) continue;
      const std::vector<FrameRow> rows = rows_of(table, scene, columns[causes], causes, frames);
      for (std::size_t i = 0; i < figures.size(); ++i) {
        if (figures[i]->kind == PointFigure::Exact || figures[i]->of_cause != causes) continue;
        Strata& strata = all[i].reading.frames;
        strata.push_back(FigureReader(*figures[i], columns[causes])
                             .stratum(rows, static_cast<int>(scene.order->size())));
        all[i].there = all[i].there && !strata.back().frames.empty();
      }
    }
  return all;
}

}  // namespace racebeam
