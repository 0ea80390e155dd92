// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "sc/base/constants.h"
#include "sc/beam/engine.h"
#include "tb/base/errors.h"
#include "tb/judge/error_causes.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

constexpr double Pixels = double(VisibleColumns) * VisibleRows;
/// Pixels of a line before its first visible one, of all pixels of a frame: what `clocks` is
/// multiplied with for the head start of the tracer, whatever clocks a pixel has.
constexpr double HeadStart =
    double(LinePixels - VisibleColumns) / (double(LinePixels) * FrameLines);
/// Clocks of a line on the chip, for lines in which a clock never came.
constexpr double LineClocks = 2.0 * LinePixels;

double divisor(PointFigure::Kind kind) {
  switch (kind) {
    case PointFigure::PerLine: return VisibleRows;
    case PointFigure::Percent: return Pixels / 100;
    default: return 1;
  }
}

/// Of the picture.
std::vector<PointFigure> picture_figures() {
  return {
      {"picture_error",
       "%",
       "pixels that differ from the reference picture, of all visible ones",
       PointFigure::Percent,
       {{"error_pixels", 1}}},
      {"error.visible",
       "%",
       "pixels that an edge moved by one pixel does not explain",
       PointFigure::Percent,
       {{"visible_error_pixels", 1}}},
  };
}

/// The causes on the ways to all references, each once.
std::vector<PointFigure> cause_figures() {
  std::vector<PointFigure> figures;
  for (const auto reference : {PictureReference::Geometry, PictureReference::Trace4})
    for (const ErrorCause& cause : error_causes(reference)) {
      const std::string name = std::string("error.") + cause.name;
      if (std::none_of(figures.begin(), figures.end(),
                       [&](const PointFigure& one) { return one.name == name; }))
        figures.push_back(
            {name, "%", cause.meaning, PointFigure::Percent, {{cause.name, 1}}, {}, true});
    }
  return figures;
}

/// Of the race with the beam.
std::vector<PointFigure> beam_figures() {
  return {
      {"starved",
       "%",
       "visible pixels without a colour of their own, none hidden by a pattern",
       PointFigure::Percent,
       {{"seen_starved_pixels", 1}}},
      {"starved.frames",
       "% of frames",
       "frames in which any pixel is so",
       PointFigure::Frames,
       {{"seen_starved_pixels", 1}}},
      {"starved.max",
       "%",
       "of the pixels of the worst frame",
       PointFigure::Largest,
       {{"seen_starved_pixels", 100 / Pixels}}},
      {"slack.p1",
       "clocks",
       "from known to shown, that 99 of 100 pixels of a frame have; 0: known too late",
       PointFigure::Mean,
       {{"slack.p1", 1}}},
      {"slack.p50",
       "clocks",
       "the same of the middle one of all pixels",
       PointFigure::Mean,
       {{"slack.p50", 1}}},
  };
}

/// Of the tracer's work.
std::vector<PointFigure> work_figures() {
  return {
      {"decisions",
       "a line",
       "decisions on which side of a corner a ray passes",
       PointFigure::PerLine,
       {{"decisions", 1}}},
      {"bisections",
       "a line",
       "steps of the search for an edge",
       PointFigure::PerLine,
       {{"bisection_steps", 1}}},
      {"restarts",
       "a line",
       "restarts after the interval stack lost entries",
       PointFigure::PerLine,
       {{"restarts", 1}}},
      {"give_ups",
       "a line",
       "hits accepted in a hurry, without a wall",
       PointFigure::PerLine,
       {{"give_ups", 1}}},
      {"sign_splits",
       "a line",
       "decisions at the right end whose rays differ in a sign from those at the left",
       PointFigure::PerLine,
       {{"sign_splits", 1}}},
      {"walk.mean",
       "steps",
       "of dr2 along the line before a decision",
       PointFigure::Mean,
       {{"walk_steps.sum", 1}},
       {{"left_decisions", 1}}},
      {"rooms",
       "a line",
       "rooms entered through portals",
       PointFigure::PerLine,
       {{"rooms_entered", 1}}},
      {"returns",
       "a line",
       "returns to an interval on the stack",
       PointFigure::PerLine,
       {{"returns", 1}}},
      {"emits", "a line", "intervals given to the FIFO", PointFigure::PerLine, {{"emits", 1}}},
      {"merges",
       "a line",
       "intervals that the FIFO's newest entry takes in",
       PointFigure::PerLine,
       {{"merges", 1}}},
      {"busy",
       "clocks a line",
       "clocks of the tracer before a line is done",
       PointFigure::PerLine,
       {{"busy_clocks.sum", 1}}},
      {"busy.p99",
       "clocks",
       "busy clocks that 99 of 100 lines of a frame do not exceed",
       PointFigure::Mean,
       {{"busy_clocks.p99", 1}}},
      {"busy.max",
       "clocks",
       "busy clocks of the longest line",
       PointFigure::Largest,
       {{"busy_clocks.max", 1}}},
      {"lines_not_done",
       "lines a frame",
       "lines that the beam ended before the tracer",
       PointFigure::Mean,
       {{"done_clock.never", 1}}},
      {"stack.mean",
       "entries",
       "on the interval stack, mean over the clocks of the tracer",
       PointFigure::Mean,
       {{"stack_depth.sum", 1}},
       {{"busy_clocks.sum", 1}, {"fifo_full_stalls", 1}}},
      {"stack.needed",
       "entries",
       "that an endless interval stack would hold at most",
       PointFigure::Largest,
       {{"stack_needed.max", 1}}},
      {"fifo.p50",
       "entries",
       "in use of the FIFO, in the middle clock of a frame's lines sorted by it",
       PointFigure::Mean,
       {{"fifo_fill.p50", 1}}},
      {"fifo.full_stalls",
       "clocks a line",
       "clocks an interval waits for room in the FIFO",
       PointFigure::PerLine,
       {{"fifo_full_stalls", 1}}},
      {"first_emit",
       "clocks a line",
       "head start left at the first interval; lines without one count as a line late",
       PointFigure::PerLine,
       {{"clocks", VisibleRows * HeadStart},
        {"first_emit_clock.sum", -1},
        {"first_emit_clock.never", -LineClocks}}},
  };
}

/// What the clocks of a line are spent on: together they are all of them.
std::vector<PointFigure> line_figures() {
  std::vector<PointFigure> figures;
  for (const line_info& line : beam_engine().lines)
    if (const std::string part = line.part; !part.empty())
      figures.push_back({"line." + part,
                         "clocks a line",
                         "what '" + part + "' takes of a line's clocks",
                         PointFigure::PerLine,
                         {{std::string(line.name) + ".sum", 1}}});
  return figures;
}

/// Of pictures that take their time.
std::vector<PointFigure> ray_figures() {
  const auto a_pixel = [](const char* name, const char* unit, const char* meaning,
                          const std::vector<const char*>& columns, double factor = 1) {
    PointFigure figure{name, unit, meaning, PointFigure::Mean, {}, {{"pixels", 1}}};
    for (const char* column : columns) figure.terms.push_back({column, factor});
    return figure;
  };
  return {
      a_pixel("picture_error", "%", "pixels that differ from the golden tracer's picture, of all",
              {"golden_error_pixels"}, 100),
      a_pixel("error.levels", "%", "pixels that do so by more than one level in some channel",
              {"golden_level_pixels"}, 100),
      a_pixel("clocks", "a pixel", "clocks of a picture, from its start to its end", {"clocks"}),
      {"frames",
       "a picture",
       "frames of the raster that a picture takes",
       PointFigure::Mean,
       {{"frames", 1}}},
      {"clocks.max", "clocks", "of the slowest picture", PointFigure::Largest, {{"clocks", 1}}},
      a_pixel("rays", "a pixel", "rays from the eye, from mirrors and to the light",
              {"primary_rays", "reflected_rays", "shadow_rays"}),
      a_pixel("tests", "a pixel", "tests of a ray against a sphere or a plane",
              {"sphere_tests", "plane_tests"}),
      {"cores.busy",
       "cores",
       "cores that draw, of all, on average",
       PointFigure::Mean,
       {{"busy_clocks", 1}},
       {{"clocks", 1}}},
      {"cleared",
       "%",
       "blocks that are cleared without a ray",
       PointFigure::Mean,
       {{"cleared", 100}},
       {{"blocks", 1}}},
      a_pixel("groups", "a pixel", "groups of lanes that a ray meets", {"groups"}),
      a_pixel("shades", "a pixel", "spheres that are shaded", {"shades"}),
      a_pixel("bus", "clocks a pixel", "clocks that a core waits with a word, of all cores",
              {"bus_stalls"}),
      a_pixel("roots", "a pixel", "square roots", {"roots"}),
      a_pixel("divisions", "a pixel", "divisions", {"divisions"}),
      a_pixel("stalls", "clocks a pixel", "clocks that a word waits for the write buffer",
              {"buffer_stalls"}),
      {"lost",
       "%",
       "words that the write buffer loses, of all",
       PointFigure::Mean,
       {{"buffer_lost", 100}},
       {{"words", 1}}},
      {"overflows",
       "a picture",
       "numbers that leave their bits",
       PointFigure::Mean,
       {{"overflows", 1}}},
  };
}

std::vector<PointFigure> silicon_figures() {
  const auto exact = [](const char* name, const char* unit, const char* meaning,
                        const char* tool = "") {
    return PointFigure{name, unit, meaning, PointFigure::Exact, {}, {}, false, tool};
  };
  return {
      exact("register_bits", "bits", "registers of the chip without sound, by its model"),
      exact("memory_bits", "bits", "queues, stacks and tables, registers or not, by its model"),
      exact("partial_products", "bits", "products of two bits of all multipliers, by its model"),
      exact("flip_flops", "bits", "flip-flops of the chip without sound", "silicon"),
      exact("cells", "cells", "generic cells of the chip without sound", "silicon"),
      exact("area", "um2", "cells of osu018, without sound, before layout", "timing"),
      exact("multipliers", "%", "of that area, multipliers mapped alone", "timing"),
      exact("tiles", "tiles", "of Tiny Tapeout, an estimate from the area", "timing"),
      exact("longest_path", "ns", "in osu018, without wires; 0.2 ns are noise", "timing"),
      exact("ice40.flip_flops", "bits", "flip-flops in an iCE40, without sound", "timing"),
      exact("ice40.luts", "LUTs", "of four inputs in an iCE40, without sound", "timing"),
      exact("ice40.clock", "MHz", "of an iCE40 HX8K, placed and routed", "timing"),
  };
}

}  // namespace

const std::vector<PointFigure>& figure_table() {
  static const std::vector<PointFigure> table = [] {
    std::vector<PointFigure> all;
    for (auto* const figures : {picture_figures, cause_figures, beam_figures, work_figures,
                                line_figures, ray_figures, silicon_figures})
      for (PointFigure& figure : figures()) all.push_back(std::move(figure));
    return all;
  }();
  return table;
}

const PointFigure* figure_named(const std::string& name) {
  for (const PointFigure& figure : figure_table())
    if (figure.name == name) return &figure;
  return nullptr;
}

const PointFigure* figure_named(const std::string& name, const engine& built) {
  for (const PointFigure& figure : figure_table())
    if (figure.name == name && figure.is_of(built)) return &figure;
  return nullptr;
}

std::vector<const engine*> engines_with(const PointFigure& figure) {
  std::vector<const engine*> all;
  for (const SweepKind& kind : sweep_kinds())
    if (figure.is_of(kind.engine)) all.push_back(&kind.engine);
  return all;
}

bool PointFigure::is_of(const engine& built) const {
  return of_cause ? sweep_kind(built).measures.causes : !missing(sweep_columns(built));
}

std::string figure_row(const PointFigure& figure) {
  return fmt::format("| `{}` | {} | {} |", figure.name, figure.unit, figure.meaning);
}

std::string figures_text(const std::string& before) {
  std::size_t names = 0, units = 0;
  for (const PointFigure& figure : figure_table()) {
    names = std::max(names, figure.name.size());
    units = std::max(units, std::string_view(figure.unit).size());
  }
  std::string text;
  for (const SweepKind& kind : sweep_kinds()) {
    text += fmt::format("{}{}of scenes for {}:\n", text.empty() ? "" : before + "\n", before,
                        kind.engine.name);
    for (const PointFigure& figure : figure_table())
      if (figure.is_of(kind.engine))
        text += fmt::format("{}{:<{}}  {:<{}}  {}\n", before, figure.name, names, figure.unit,
                            units, figure.meaning);
  }
  return text;
}

std::vector<std::string> PointFigure::columns() const {
  std::vector<std::string> names;
  for (const auto* list : {&terms, &per})
    for (const Term& term : *list) names.emplace_back(term.column);
  return names;
}

const char* PointFigure::missing(const std::vector<std::string>& columns) const {
  for (const auto* list : {&terms, &per})
    for (const Term& term : *list)
      if (std::find(columns.begin(), columns.end(), term.column) == columns.end())
        return term.column.c_str();
  return nullptr;
}

FigureReader::FigureReader(const PointFigure& figure, const std::vector<std::string>& columns)
    : figure_(figure) {
  if (figure.kind == PointFigure::Exact)
    throw UsageError(fmt::format("{} is not a figure of frames", figure.name));
  if (const char* column = figure.missing(columns))
    throw UsageError(
        fmt::format("{} needs the column {}, which this sweep does not have", figure.name, column));
  parts_ = parts(figure.terms, columns, figure.per.empty() ? divisor(figure.kind) : 1);
  per_ = parts(figure.per, columns, 1);
}

std::vector<FigureReader::Part> FigureReader::parts(const std::vector<PointFigure::Term>& terms,
                                                    const std::vector<std::string>& columns,
                                                    double divisor) {
  std::vector<Part> parts;
  for (const PointFigure::Term& term : terms) {
    const auto at = std::find(columns.begin(), columns.end(), term.column) - columns.begin();
    parts.push_back({std::size_t(at), term.factor / divisor});
  }
  return parts;
}

double FigureReader::value(const FrameRow& row) const {
  const auto sum = [&row](const std::vector<Part>& parts) {
    double sum = 0;
    for (const Part& part : parts) sum += part.factor * double(row.values.at(part.column));
    return sum;
  };
  const double value = sum(parts_);
  if (figure_.kind == PointFigure::Frames) return value != 0 ? 100 : 0;
  if (per_.empty()) return value;
  const double divisor = sum(per_);
  return divisor == 0 ? 0 : value / divisor;  // nothing happened
}

Stratum FigureReader::stratum(const std::vector<FrameRow>& rows, int population) const {
  std::vector<const FrameRow*> taken;
  for (const FrameRow& row : rows)
    if (!row.guard || figure_.kind == PointFigure::Largest) taken.push_back(&row);
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
