// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tb/base/counted.h"
#include "tb/report/html.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/verdict_words.h"

namespace racebeam {

namespace {

std::string column_unit(const PointFigure& figure) { return figure.unit; }

const char* points_of(const PointFigure& figure) {
  return figure.kind == PointFigure::Percent ? "points" : "";
}

std::string sort_key(double value) { return fmt::format("{:.9g}", value); }

HtmlCell number_cell(const std::string& text, double value) {
  return {html(text), sort_key(value), true};
}

HtmlCell figure_cell(const PointFigure& figure, const ReportedFigure* of) {
  if (!of) return {"-", "", true};
  const double value = of->value.value;
  if (figure.kind == PointFigure::Exact) return number_cell(text_of(value), value);
  if (!figure.sampled()) return number_cell(text_of(value) + "*", value);
  return number_cell(text_of(of->value), value);
}

HtmlCell change_cell(const PointFigure& figure, const std::optional<Estimate>& change) {
  if (!change) return {"-", "", true};
  const std::string text =
      figure.kind == PointFigure::Exact ? text_of(change->value) : text_of(*change);
  return number_cell((change->value > 0 ? "+" : "") + text, change->value);
}

void add_led(HtmlTable& table, const ReportedSweep& sweep) {
  for (const PointFigure* figure : sweep.led)
    table.column(figure->name, column_unit(*figure), figure->meaning, true);
}

/// "front", "dominated by p10 after 48 frames", "failed: died: Aborted, twice".
std::string standing_text(const ReportedPoint& point) {
  if (point.reason.empty() || point.reason.rfind(point.standing, 0) == 0)
    return point.reason.empty() ? point.standing : point.reason;
  return point.standing + ": " + point.reason;
}

/// What tells the point from the base; of the base nothing.
std::string setting_text(const ReportedSweep& sweep, std::size_t point) {
  std::string text;
  const knob_values &of = sweep.points[point].k.front(), &base = sweep.points.front().k.front();
  for (std::size_t row = 0; row < of.rows().size(); ++row)
    if (of[row] != base[row])
      text += (text.empty() ? "" : " ") + std::string(of.rows()[row].name) + "=" +
              of.rows()[row].text(of[row]);
  return text;
}

std::string worst_note(const ReportedSweep& sweep) {
  for (std::size_t i = 0; i < sweep.figures.size(); ++i)
    if (sweep.figures[i]->kind == PointFigure::Largest && sweep.points.front().figures[i].there)
      return fmt::format(
          "<p class=\"note\">* worst of the {} frames of {} that are there; other points may have "
          "fewer.</p>\n",
          grouped(sweep.points.front().figures[i].value.frames), html(sweep.points.front().name));
  return "";
}

/// The surest step of a knob: with the largest change for its interval.
const KnobStep* surest_step(const std::vector<KnobStep>& steps, const std::string& knob,
                            std::size_t led) {
  const KnobStep* best = nullptr;
  double most = 0;
  for (const KnobStep& step : steps) {
    if (step.knob != knob || !step.changes[led] || !step.changes[led]->differs_from(0)) continue;
    if (const double size = std::abs(step.changes[led]->value); size > most) {
      most = size;
      best = &step;
    }
  }
  return best;
}

void add_steps(const ReportedSweep& sweep, const ReportParts& parts,
               std::vector<std::string>& all) {
  std::set<std::string> knobs;
  for (const KnobStep& step : parts.steps) knobs.insert(step.knob);
  for (std::size_t led = 0; led < sweep.led.size(); ++led) {
    const PointFigure& figure = *sweep.led[led];
    if (!figure.sampled()) continue;
    for (const std::string& knob : knobs) {
      const KnobStep* step = surest_step(parts.steps, knob, led);
      if (!step) {
        const bool any = std::any_of(parts.steps.begin(), parts.steps.end(), [&](const auto& one) {
          return one.knob == knob && one.changes[led];
        });
        if (any) all.push_back(fmt::format("No step of {} surely changes {}.", knob, figure.name));
        continue;
      }
      const Estimate& change = *step->changes[led];
      all.push_back(fmt::format(
          "{} from {} to {} {} {} by {}{}: the largest of its steps.", knob, step->from, step->to,
          change.value < 0 ? "lowers" : "raises", figure.name, change_words(figure, change),
          step->pairs > 1 ? fmt::format(" (mean of {} pairs of points)", step->pairs) : ""));
    }
    return;  // of the first figure of frames; the table has the others
  }
}

}  // namespace

std::vector<std::string> report_sentences(const ReportedSweep& sweep, const ReportParts& parts) {
  std::vector<std::string> all = sweep.remarks;
  const auto add = [&](std::string words) {
    if (!words.empty()) words.back() = '.';  // its newline
    if (!words.empty()) all.push_back(words);
  };
  const int measured = sweep.measured();
  if (measured == 0) {
    all.push_back("Nothing has been measured yet.");
    return all;
  }
  add(best_words(sweep.plan.file, sweep.candidates, sweep.verdicts,
                 static_cast<int>(sweep.points.size())));
  add(counts_words(sweep.plan.file, sweep.verdicts, sweep.failed()));
  const int missing = static_cast<int>(sweep.points.size()) - measured - sweep.failed();
  if (missing > 0) all.push_back(counted(missing, "point") + " not measured yet.");
  add_steps(sweep, parts, all);
  for (std::size_t led = 0; led < sweep.led.size(); ++led)
    for (const KnobShare& share : parts.shares)
      if (share.shares[led] && *share.shares[led] >= 0.5)
        all.push_back(fmt::format("{} explains {:.0f} % of the differences in {} between points.",
                                  share.knob, 100 * *share.shares[led], sweep.led[led]->name));
  return all;
}

std::string front_table(const ReportedSweep& sweep) {
  HtmlTable table("front-table", sweep.plan.file.goals.empty() ? "Points as they are measured"
                                                               : "The base and the front");
  table.column("point");
  table.column("stands");
  table.column("frames", "", "", true);
  add_led(table, sweep);
  table.column("unlike the base");
  bool any = false;
  for (std::size_t at = 0; at < sweep.points.size(); ++at) {
    const ReportedPoint& point = sweep.points[at];
    const bool shown = sweep.plan.file.goals.empty() || at == 0 || point.on_front();
    if (!point.measured() || !shown) continue;
    any = true;
    std::vector<HtmlCell> cells = {{html(point.name), "", false, true},
                                   {point.standing},
                                   number_cell(grouped(point.frames), point.frames)};
    for (const PointFigure* figure : sweep.led)
      cells.push_back(figure_cell(*figure, sweep.figure(point, figure->name)));
    cells.push_back({html(setting_text(sweep, at)), "", false, false, true});
    table.row(cells);
  }
  return any ? table.text() + worst_note(sweep) : "";
}

std::string scenes_table(const ReportedSweep& sweep) {
  if (sweep.plan.scenes.size() < 2) return "";
  HtmlTable table("scenes-table", "The base and the front by scene");
  table.column("point");
  table.column("scene");
  add_led(table, sweep);
  for (std::size_t at = 0; at < sweep.points.size(); ++at) {
    const ReportedPoint& point = sweep.points[at];
    if (!point.measured() || (at != 0 && !point.on_front())) continue;
    for (std::size_t scene = 0; scene < sweep.plan.scenes.size(); ++scene) {
      std::vector<HtmlCell> cells = {{html(point.name), "", false, true},
                                     {html(sweep.plan.scenes[scene].name)}};
      for (std::size_t led = 0; led < sweep.led.size(); ++led) {
        const PointReading& read = point.led[led];
        ReportedFigure figure;
        figure.there = read.there;
        if (read.there && read.reading.kind == Reading::Sampled)
          figure.value = mean_of({read.reading.frames[scene]});
        else if (read.there && read.reading.kind == Reading::Largest)
          figure.value.value = worst_of({read.reading.frames[scene]}).value;
        else if (read.there) figure.value.value = read.reading.exact;
        cells.push_back(figure_cell(*sweep.led[led], figure.there ? &figure : nullptr));
      }
      table.row(cells);
    }
  }
  return table.text();
}

std::string effects_table(const ReportedSweep& sweep, const ReportParts& parts) {
  if (parts.steps.empty() && parts.means.empty()) return "";
  HtmlTable table("effects-table", parts.means.empty() ? "The change by each step of a knob"
                                                       : "The mean of the points with each value");
  table.column("knob");
  table.column(parts.means.empty() ? "step" : "value");
  table.column(parts.means.empty() ? "pairs" : "points", "", "", true);
  add_led(table, sweep);
  for (const KnobStep& step : parts.steps) {
    std::vector<HtmlCell> cells = {
        {html(step.knob), "", false, true},
        {html(step.from) + " \u2192 " + html(step.to)},
        number_cell(std::to_string(step.pairs) +
                        (step.left_out ? fmt::format(" ({} left out)", step.left_out) : ""),
                    step.pairs)};
    for (std::size_t led = 0; led < sweep.led.size(); ++led)
      cells.push_back(change_cell(*sweep.led[led], step.changes[led]));
    table.row(cells);
  }
  for (const KnobMean& mean : parts.means) {
    int points = 0;
    for (const auto& of : mean.means)
      if (of) points = std::max(points, of->points);
    std::vector<HtmlCell> cells = {{html(mean.knob), "", false, true},
                                   {html(mean.value)},
                                   number_cell(std::to_string(points), points)};
    for (const auto& of : mean.means)
      cells.push_back(of ? number_cell(fmt::format("{:.4g}{}", of->value,
                                                   std::isfinite(of->half_width)
                                                       ? fmt::format(" +/- {:.2g}", of->half_width)
                                                       : " (one point)"),
                                       of->value)
                         : HtmlCell{"-", "", true});
    table.row(cells);
  }
  std::string text = table.text();
  if (parts.shares.empty()) return text;
  HtmlTable shares("shares-table",
                   "What each knob explains of the points' differences, eta squared");
  shares.column("knob");
  for (const PointFigure* figure : sweep.led)
    shares.column(figure->name, "%", figure->meaning, true);
  for (const KnobShare& share : parts.shares) {
    std::vector<HtmlCell> cells = {{html(share.knob), "", false, true}};
    for (const auto& of : share.shares)
      cells.push_back(of ? number_cell(fmt::format("{:.0f}", 100 * *of), *of)
                         : HtmlCell{"-", "", true});
    shares.row(cells);
  }
  return text + shares.text();
}

std::string units_table(const ReportedSweep& sweep, const ReportParts& parts) {
  std::vector<std::string> units;
  for (const std::size_t point : parts.focus)
    for (const ReportedUnit& unit : sweep.points[point].units)
      if (std::find(units.begin(), units.end(), unit.unit) == units.end())
        units.push_back(unit.unit);
  if (units.empty()) return "";
  HtmlTable table("units-table", "Cells and flip-flops by unit");
  table.column("unit");
  for (const std::size_t point : parts.focus)
    if (!sweep.points[point].units.empty())
      table.column(sweep.points[point].name, "cells / flip-flops", "", true);
  for (const std::string& name : units) {
    std::vector<HtmlCell> cells = {{html(name), "", false, true}};
    for (const std::size_t point : parts.focus)
      for (const ReportedUnit& unit : sweep.points[point].units)
        if (unit.unit == name)
          cells.push_back(number_cell(grouped(unit.cells) + " / " + grouped(unit.flip_flops),
                                      double(unit.cells)));
    table.row(cells);
  }
  return table.text();
}

std::string slack_table(const ReportedSweep& sweep, const ReportParts& parts) {
  const PointFigure* p1 = figure_named("slack.p1", sweep.built());
  const PointFigure* p50 = figure_named("slack.p50", sweep.built());
  if (parts.slack.empty() || !p1 || !p50) return "";
  HtmlTable table("slack-table", "Slack of pixels");
  table.column("point");
  for (const PointFigure* figure : {p1, p50})
    table.column(figure->name, figure->unit, figure->meaning, true);
  for (const SlackShares& one : parts.slack) {
    const ReportedPoint& point = sweep.points[one.point];
    table.row({{html(point.name), "", false, true},
               figure_cell(*p1, sweep.figure(point, p1->name)),
               figure_cell(*p50, sweep.figure(point, p50->name))});
  }
  return table.text();
}

std::string causes_table(const ReportedSweep& sweep, const ReportParts& parts) {
  if (parts.causes.empty()) return "";
  HtmlTable table("causes-table", "Errors by cause, % of the pixels");
  table.column("cause");
  for (const std::size_t point : parts.focus) table.column(sweep.points[point].name, "", "", true);
  for (const PointFigure* figure : parts.causes) {
    std::vector<HtmlCell> cells = {
        {fmt::format("<abbr title=\"{}\">{}</abbr>", html(figure->meaning), html(figure->name)), "",
         false, true}};
    for (const std::size_t point : parts.focus)
      cells.push_back(figure_cell(*figure, sweep.figure(sweep.points[point], figure->name)));
    table.row(cells);
  }
  return table.text();
}

std::string points_table(const ReportedSweep& sweep, const ReportPictures& pictures) {
  HtmlTable table("points-table", "Each point, with the command that repeats it");
  table.column("point");
  table.column("stands");
  table.column("frames", "", "", true);
  for (const std::size_t knob : sweep.knobs) table.column(sweep.built().knobs[knob].name);
  add_led(table, sweep);
  const PointFigure* changed = nullptr;
  for (const PointFigure* figure : sweep.led)
    if (!changed && figure->sampled()) changed = figure;
  if (changed)
    table.column("change of " + changed->name, points_of(*changed), "against the base", true);
  table.column("again");
  for (std::size_t at = 0; at < sweep.points.size(); ++at) {
    const ReportedPoint& point = sweep.points[at];
    std::vector<HtmlCell> cells = {{html(point.name), "", false, true},
                                   {html(standing_text(point)), "", false, false, true},
                                   number_cell(grouped(point.frames), point.frames)};
    for (const std::size_t knob : sweep.knobs)
      cells.push_back({html(sweep.built().knobs[knob].text(point.k.front()[knob])),
                       std::to_string(point.k.front()[knob])});
    for (const PointFigure* figure : sweep.led)
      cells.push_back(figure_cell(*figure, sweep.figure(point, figure->name)));
    if (changed) {
      const ReportedFigure* of = sweep.figure(point, changed->name);
      cells.push_back(change_cell(*changed, of && at != 0 ? of->change : std::nullopt));
    }
    cells.push_back({"<code>" + html(repeat_command(sweep, at, pictures)) + "</code>"});
    table.row(cells, fmt::format(" data-point=\"{}\"", at));
  }
  return table.text();
}

}  // namespace racebeam
