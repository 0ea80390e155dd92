// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/goal_reader.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "tb/scene/table_reader.h"
#include "tb/sweep/sweep_keys.h"

namespace racebeam {

namespace {

const SweepFigure* figure_of(const TomlEntry& entry, const std::vector<SweepFigure>& figures,
                             Faults& faults) {
  std::vector<std::string> known;
  const engine* owner = nullptr;
  for (const SweepFigure& figure : figures) {
    if (figure.foreign) {
      if (figure.name == entry.key) owner = figure.engines.front();
      continue;
    }
    if (figure.name == entry.key) return &figure;
    known.push_back(figure.name);
  }
  faults.add(entry.place,
             owner ? "figure " + quoted(entry.key) + " is one of " + owner->name
                   : "unknown figure " + quoted(entry.key),
             name_help(entry.key, known));
  return nullptr;
}

// Whether `unit` is that of the figure, or its first words.
bool is_unit(const std::string& unit, const std::string& of_figure) {
  return unit.empty() || (of_figure + " ").rfind(unit + " ", 0) == 0;
}

// "0.5 %", "1530 clocks", 1530; or a fault.
bool read_quantity(const TomlNode& node, const std::string& name, const std::string& unit,
                   double& to, Faults& faults) {
  const std::string example = "\"0.5" + (unit.empty() ? "" : " " + unit) + "\"";
  double value = 0;
  if (node.kind == TomlNode::Integer) {
    value = static_cast<double>(node.integer);
  } else if (node.kind == TomlNode::Float) {
    value = node.number;
  } else if (node.kind == TomlNode::String) {
    const char* const end = node.text.data() + node.text.size();
    const auto [rest, error] = std::from_chars(node.text.data(), end, value);
    const std::string behind(rest, end);
    const auto word = behind.find_first_not_of(' ');
    if (error != std::errc() ||
        !is_unit(word == std::string::npos ? "" : behind.substr(word), unit)) {
      faults.add(node.place, "'" + name + "' is " + quoted(node.text),
                 "it must be a number and its unit, " + example);
      return false;
    }
  } else {
    wrong_type(node, name, "a number, or one with its unit, " + example, faults);
    return false;
  }
  if (!std::isfinite(value)) {
    faults.add(node.place, "'" + name + "' is not a finite number", "write one, " + example);
    return false;
  }
  to = value;
  return true;
}

// { least = ..., most = ... }
void read_limits(const TomlNode& node, const SweepFigure& figure, Goal& goal, Faults& faults) {
  const TableReader limits(node, "goal", faults, sweep_keys());
  const auto read = [&](const std::string& key, std::optional<double>& to) {
    double value = 0;
    const TomlNode* limit = limits.find(key);
    if (limit && read_quantity(*limit, key, figure.unit, value, faults)) to = value;
  };
  read("least", goal.least);
  read("most", goal.most);
  if (node.entries.empty())
    faults.add(node.place, quoted(figure.name) + " has no limit",
               "write { most = 1 }, { least = 1 } or both");
  if (goal.least && goal.most && *goal.least > *goal.most)
    faults.add(limits.find("least")->place, "'least' is more than 'most'",
               "no point can be wanted: exchange them");
}

void require_measure(const TomlEntry& entry, const SweepFigure& figure, const SweepMeasure& measure,
                     Faults& faults) {
  if (figure.measure == "silicon" && !measure.silicon)
    faults.add(entry.place, "goal " + quoted(figure.name) + " is not measured",
               "write [measure] silicon = \"generic\"");
  if (figure.measure == "timing" && measure.timing != SweepTiming::All)
    faults.add(entry.place, "goal " + quoted(figure.name) + " is not measured of all points",
               "write [measure] timing = \"all\"");
  if (figure.measure == "causes" && !measure.causes)
    faults.add(entry.place, "goal " + quoted(figure.name) + " is not measured",
               "write [measure] causes = true");
}

bool is_table(const TomlNode& node, const std::string& name, Faults& faults) {
  if (node.kind == TomlNode::Table) return true;
  wrong_type(node, name, "a table of figures", faults);
  return false;
}

}  // namespace

std::vector<Goal> read_goals(const TomlNode& node, const std::vector<SweepFigure>& figures,
                             const SweepMeasure& measure, Faults& faults) {
  std::vector<Goal> goals;
  if (!is_table(node, "goals", faults)) return goals;
  for (const TomlEntry& entry : node.entries) {
    const SweepFigure* figure = figure_of(entry, figures, faults);
    if (!figure) continue;
    require_measure(entry, *figure, measure, faults);
    Goal goal{figure->name};
    if (entry.value.kind == TomlNode::Table) {
      read_limits(entry.value, *figure, goal, faults);
    } else if (entry.value.kind == TomlNode::String) {
      int word = 0;
      if (read_word(entry.value, figure->name, goal_words(), word, faults))
        goal.kind = static_cast<GoalKind>(word + static_cast<int>(GoalKind::Min));
    } else {
      wrong_type(entry.value, figure->name, "\"min\", \"max\" or { most = 1 }", faults);
    }
    goals.push_back(goal);
  }
  return goals;
}

std::vector<std::pair<std::string, double>> read_until(const TomlNode& node,
                                                       const std::vector<SweepFigure>& figures,
                                                       Faults& faults) {
  constexpr double Widest = 100;  // %
  std::vector<std::pair<std::string, double>> until;
  if (!is_table(node, "until", faults)) return until;
  for (const TomlEntry& entry : node.entries) {
    const SweepFigure* figure = figure_of(entry, figures, faults);
    if (!figure) continue;
    if (!figure->sampled) {
      faults.add(entry.place, quoted(figure->name) + " has no interval",
                 "leave it out: no more frames make it surer");
      continue;
    }
    double width = 0;
    if (!read_quantity(entry.value, figure->name, "%", width, faults)) continue;
    if (width <= 0 || width > Widest)
      faults.add(entry.value.place, quoted(figure->name) + " is not in 0..100 %",
                 "how far the mean may be off, in % of it: \"5 %\"");
    until.emplace_back(figure->name, width);
  }
  return until;
}

}  // namespace racebeam
