// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/report_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "sc/base/constants.h"
#include "sc/beam/frame_stats.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t MostInFocus = 8;

Json number(double value) {
  if (!std::isfinite(value)) return {};
  return std::strtod(fmt::format("{:.7g}", value).c_str(), nullptr);
}

std::string shell_word(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) || std::string("._/=,+%-").find(char(c)) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

Json points_json(const ReportedSweep& sweep) {
  Json names = Json::array(), standings = names, reasons = names, frames = names;
  for (const ReportedPoint& point : sweep.points) {
    names.push_back(point.name);
    standings.push_back(point.standing);
    reasons.push_back(point.reason);
    frames.push_back(point.frames);
  }
  return {{"name", names}, {"standing", standings}, {"reason", reasons}, {"frames", frames}};
}

Json knobs_json(const ReportedSweep& sweep) {
  Json all = Json::array();
  for (const std::size_t knob : sweep.knobs) {
    const knob_row& row = sweep.built().knobs[knob];
    Json words = Json::array(), order = Json::array();
    std::vector<int> values;
    for (const ReportedPoint& point : sweep.points) {
      words.push_back(row.text(point.k.front()[knob]));
      values.push_back(point.k.front()[knob]);
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const int value : values) order.push_back(row.text(value));
    all.push_back({{"name", row.name}, {"order", order}, {"value", words}});
  }
  return all;
}

Json figures_json(const ReportedSweep& sweep) {
  Json all = Json::array();
  for (std::size_t i = 0; i < sweep.figures.size(); ++i) {
    const PointFigure& figure = *sweep.figures[i];
    Json value = Json::array(), half = value, change = value, change_half = value;
    for (const ReportedPoint& point : sweep.points) {
      const ReportedFigure& of = point.figures[i];
      const bool sampled = of.there && figure.sampled();
      value.push_back(of.there ? number(of.value.value) : Json());
      half.push_back(sampled ? number(of.value.half_width) : Json());
      change.push_back(of.there && of.change ? number(of.change->value) : Json());
      change_half.push_back(sampled && of.change ? number(of.change->half_width) : Json());
    }
    Json one = {{"name", figure.name}, {"unit", figure.unit}, {"meaning", figure.meaning}};
    one["value"] = value;
    if (figure.sampled()) one["half"] = half;
    if (figure.kind != PointFigure::Largest) one["change"] = change;
    if (figure.sampled()) one["change_half"] = change_half;
    all.push_back(one);
  }
  return all;
}

Json effects_json(const ReportedSweep& sweep, const ReportParts& parts) {
  Json all = Json::array();
  for (std::size_t led = 0; led < sweep.led.size(); ++led) {
    Json names = Json::array(), values = names, halves = names, counts = names, knobs = names;
    const auto add = [&](const std::string& knob, const std::string& text, double value,
                         double half, int count) {
      knobs.push_back(knob);
      names.push_back(text);
      values.push_back(number(value));
      halves.push_back(number(half));
      counts.push_back(count);
    };
    for (const KnobStep& step : parts.steps)
      if (const auto& change = step.changes[led])
        add(step.knob, step.from + " \u2192 " + step.to, change->value, change->half_width,
            step.pairs);
    for (const KnobMean& mean : parts.means)
      if (const auto& of = mean.means[led])
        add(mean.knob, mean.value, of->value, of->half_width, of->points);
    if (values.empty()) continue;
    all.push_back({{"figure", sweep.led[led]->name},
                   {"knob", knobs},
                   {"step", names},
                   {"value", values},
                   {"half", halves},
                   {"count", counts}});
  }
  return all;
}

Json units_json(const ReportedSweep& sweep, const ReportParts& parts) {
  Json points = Json::array(), units = points, cells = points, flip_flops = points;
  for (const std::size_t point : parts.focus)
    for (const ReportedUnit& unit : sweep.points[point].units) {
      points.push_back(point);
      units.push_back(unit.unit);
      cells.push_back(unit.cells);
      flip_flops.push_back(unit.flip_flops);
    }
  return {{"point", points}, {"unit", units}, {"cells", cells}, {"flip_flops", flip_flops}};
}

Json slack_json(const ReportParts& parts) {
  Json all = Json::array();
  for (const SlackShares& one : parts.slack) {
    Json shares = Json::array();
    for (const double percent : one.percent) shares.push_back(number(percent));
    all.push_back({{"point", one.point}, {"percent", shares}});
  }
  return {{"step", SlackBin}, {"points", all}};
}

Json pictures_json(const ReportedSweep& sweep, const ReportPictures& pictures) {
  Json points = Json::array(), scenes = points, frames = points, why = points;
  for (const ReportPicture& picture : pictures.taken) {
    points.push_back(picture.point);
    scenes.push_back(sweep.plan.scenes[picture.scene].name);
    frames.push_back(picture.frame);
    why.push_back(picture.why);
  }
  return {{"point", points}, {"scene", scenes}, {"frame", frames}, {"why", why}};
}

std::vector<SlackShares> slack_of(const SweepReader& reader, const ReportParts& parts) {
  constexpr double Pixels = double(VisibleColumns) * VisibleRows;
  std::vector<SlackShares> all;
  for (const std::size_t point : parts.focus) {
    Histogram sum;
    for (const FrameKey& key : reader.sweep().points[point].keys) {
      const auto histograms = reader.frames().histograms(key);
      if (const auto at = histograms.find("slack"); at != histograms.end())
        sum.add(at->second.frames, at->second.bins);
    }
    if (sum.frames == 0) continue;
    SlackShares& shares = all.emplace_back();
    shares.point = point;
    for (const std::int64_t pixels : sum.bins)
      shares.percent.push_back(100 * double(pixels) / (Pixels * double(sum.frames)));
  }
  return all;
}

}  // namespace

ReportParts report_parts(const SweepReader& reader) {
  const ReportedSweep& sweep = reader.sweep();
  ReportParts parts;
  for (std::size_t point = 0; point < sweep.points.size(); ++point) {
    if (!sweep.points[point].measured() || (point != 0 && !sweep.points[point].on_front()))
      continue;
    if (parts.focus.size() == MostInFocus) ++parts.front_left_out;
    else parts.focus.push_back(point);
  }
  if (has_steps(sweep)) {
    parts.steps = knob_steps(sweep);
  } else {
    parts.means = knob_means(sweep);
    parts.shares = knob_shares(sweep);
  }
  parts.slack = slack_of(reader, parts);
  for (const PointFigure* figure : sweep.figures) {
    if (!figure->of_cause) continue;
    const bool any = std::any_of(parts.focus.begin(), parts.focus.end(), [&](std::size_t point) {
      const ReportedFigure* of = sweep.figure(sweep.points[point], figure->name);
      return of && of->value.value != 0;
    });
    if (any) parts.causes.push_back(figure);
  }
  return parts;
}

std::string repeat_command(const ReportedSweep& sweep, std::size_t point,
                           const ReportPictures& pictures) {
  const SweepScene& scene = sweep.plan.scenes.front();
  const ReportedPoint& of = sweep.points[point];
  int frame = scene.order.front();
  for (const ReportPicture& picture : pictures.taken)
    if (picture.point == point && picture.scene == 0) {
      frame = picture.frame;
      break;
    }
  std::string command = fmt::format("racebeam render {} --at {}", shell_word(scene.name), frame);
  const knob_values standard = scene.show.standard_knobs();
  for (std::size_t row = 0; row < standard.rows().size(); ++row)
    if (const int value = of.k.front()[row];
        value != standard[row] && !standard.rows()[row].of_scene)
      command += " --set " + shell_word(std::string(standard.rows()[row].name) + "=" +
                                        standard.rows()[row].text(value));
  return command + " -o " + shell_word(file_name_of(of.name) + ".png");
}

std::string report_data(const ReportedSweep& sweep, const ReportParts& parts,
                        const ReportPictures& pictures) {
  Json goals = Json::array(), led = Json::array(), causes = Json::array();
  for (const Goal& goal : sweep.plan.file.goals) goals.push_back(goal.figure);
  for (const PointFigure* figure : sweep.led)
    if (std::find(sweep.figures.begin(), sweep.figures.end(), figure) != sweep.figures.end())
      led.push_back(figure->name);
  for (const PointFigure* figure : parts.causes) causes.push_back(figure->name);
  const Json data = {{"goals", goals},
                     {"led", led},
                     {"focus", parts.focus},
                     {"points", points_json(sweep)},
                     {"knobs", knobs_json(sweep)},
                     {"figures", figures_json(sweep)},
                     {"steps", has_steps(sweep)},
                     {"effects", effects_json(sweep, parts)},
                     {"units", units_json(sweep, parts)},
                     {"slack", slack_json(parts)},
                     {"causes", causes},
                     {"pictures", pictures_json(sweep, pictures)}};
  return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace racebeam
