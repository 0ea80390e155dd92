// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "sc/base/constants.h"
#include "tb/base/errors.h"

namespace racebeam {

namespace {

constexpr double Pixels = double(VisibleColumns) * VisibleRows;
/// Pixels of a line before its first visible one, of all pixels of a frame: what `clocks` is
/// multiplied with for the head start of the tracer, whatever clocks a pixel has.
constexpr double HeadStart =
    double(LinePixels - VisibleColumns) / (double(LinePixels) * FrameLines);
/// Clocks of a line on the chip, for lines in which a clock never came.
constexpr double LineClocks = 2.0 * LinePixels;

double divisor(Figure::Kind kind) {
  switch (kind) {
    case Figure::PerLine: return VisibleRows;
    case Figure::Percent: return Pixels / 100;
    default: return 1;
  }
}

}  // namespace

const std::vector<Figure>& figure_table() {
  static const std::vector<Figure> table = {
      {"picture_error",
       "%",
       "pixels that differ from the reference picture, of all visible ones",
       Figure::Percent,
       {{"error_pixels", 1}}},
      {"error.visible",
       "%",
       "pixels that an edge moved by one pixel does not explain",
       Figure::Percent,
       {{"visible_error_pixels", 1}}},
      {"starved",
       "%",
       "visible pixels without a colour of their own, none hidden by a pattern",
       Figure::Percent,
       {{"seen_starved_pixels", 1}}},
      {"decisions",
       "a line",
       "decisions on which side of a corner a ray passes",
       Figure::PerLine,
       {{"decisions", 1}}},
      {"bisections",
       "a line",
       "steps of the search for an edge",
       Figure::PerLine,
       {{"bisection_steps", 1}}},
      {"restarts",
       "a line",
       "restarts after the interval stack lost entries",
       Figure::PerLine,
       {{"restarts", 1}}},
      {"give_ups",
       "a line",
       "hits accepted in a hurry, without a wall",
       Figure::PerLine,
       {{"give_ups", 1}}},
      {"returns",
       "a line",
       "returns to an interval on the stack",
       Figure::PerLine,
       {{"returns", 1}}},
      {"emits", "a line", "intervals given to the FIFO", Figure::PerLine, {{"emits", 1}}},
      {"busy",
       "clocks a line",
       "clocks of the tracer before a line is done",
       Figure::PerLine,
       {{"busy_clocks.sum", 1}}},
      {"busy.p99",
       "clocks",
       "busy clocks that 99 of 100 lines of a frame do not exceed",
       Figure::Mean,
       {{"busy_clocks.p99", 1}}},
      {"busy.max",
       "clocks",
       "busy clocks of the longest line",
       Figure::Largest,
       {{"busy_clocks.max", 1}}},
      {"lines_not_done",
       "lines a frame",
       "lines that the beam ended before the tracer",
       Figure::Mean,
       {{"done_clock.never", 1}}},
      {"fifo.full_stalls",
       "clocks a line",
       "clocks an interval waits for room in the FIFO",
       Figure::PerLine,
       {{"fifo_full_stalls", 1}}},
      {"first_emit",
       "clocks a line",
       "head start left at the first interval; lines without one count as a line late",
       Figure::PerLine,
       {{"clocks", VisibleRows * HeadStart},
        {"first_emit_clock.sum", -1},
        {"first_emit_clock.never", -LineClocks}}},
      {"flip_flops", "bits", "flip-flops of the chip without sound", Figure::Exact, {}},
      {"cells", "cells", "generic cells of the chip without sound", Figure::Exact, {}},
  };
  return table;
}

const Figure* figure_named(const std::string& name) {
  for (const Figure& figure : figure_table())
    if (figure.name == name) return &figure;
  return nullptr;
}

const char* Figure::missing(const std::vector<std::string>& columns) const {
  for (const Term& term : terms)
    if (std::find(columns.begin(), columns.end(), term.column) == columns.end()) return term.column;
  return nullptr;
}

FigureReader::FigureReader(const Figure& figure, const std::vector<std::string>& columns)
    : figure_(figure) {
  if (figure.kind == Figure::Exact)
    throw UsageError(fmt::format("{} is not a figure of frames", figure.name));
  if (const char* column = figure.missing(columns))
    throw UsageError(
        fmt::format("{} needs the column {}, which this sweep does not have", figure.name, column));
  for (const Figure::Term& term : figure.terms) {
    const auto at = std::find(columns.begin(), columns.end(), term.column) - columns.begin();
    parts_.push_back({std::size_t(at), term.factor / divisor(figure.kind)});
  }
}

double FigureReader::value(const FrameRow& row) const {
  double value = 0;
  for (const Part& part : parts_) value += part.factor * double(row.values.at(part.column));
  return value;
}

Stratum FigureReader::stratum(const std::vector<FrameRow>& rows, int population) const {
  std::vector<const FrameRow*> taken;
  for (const FrameRow& row : rows)
    if (!row.guard || figure_.kind == Figure::Largest) taken.push_back(&row);
  std::sort(taken.begin(), taken.end(),
            [](const FrameRow* a, const FrameRow* b) { return a->frame < b->frame; });
  Stratum stratum;
  stratum.population = population;
  for (const FrameRow* row : taken) {
    stratum.frames.push_back(row->frame);
    stratum.values.push_back(value(*row));
  }
  return stratum;
}

}  // namespace racebeam
