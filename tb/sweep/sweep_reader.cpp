// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/scene/input_file.h"
#include "tb/scene/table_reader.h"
#include "tb/sweep/frames_reader.h"
#include "tb/sweep/knob_reader.h"
#include "tb/sweep/point_reader.h"
#include "tb/sweep/sweep_keys.h"
#include "tb/sweep/sweep_points.h"

namespace racebeam {

namespace {

void read_scenes(const TomlNode& node, const SweepNames& names, std::vector<std::string>& to,
                 Faults& faults) {
  if (node.kind != TomlNode::Array || node.items.empty()) {
    wrong_type(node, "scenes", "a list of names, [\"demo\"]", faults);
    return;
  }
  to.clear();
  for (const TomlNode& item : node.items) {
    if (item.kind != TomlNode::String) wrong_type(item, "scenes", "a list of names", faults);
    else if (std::find(to.begin(), to.end(), item.text) != to.end())
      faults.add(item.place, "scene " + racebeam::quoted(item.text) + " is there twice",
                 "leave one out");
    else if (!names.is_scene(item.text))
      faults.add(item.place, "unknown scene " + racebeam::quoted(item.text),
                 name_help(item.text, names.scenes));
    else to.push_back(item.text);
  }
}

// Whose knobs and figures the file may name. Scenes are opened only for that.
void read_engine(const TomlNode* node, const SweepNames& names, SweepFile& file, Faults& faults) {
  if (!names.engine_of || !faults.none()) return;
  std::vector<const engine*> built;
  for (const std::string& scene : file.scenes) built.push_back(names.engine_of(scene));
  for (std::size_t at = 0; at < built.size(); ++at)
    if (built[at] != built.front())
      faults.add(
          node->items[at].place,
          fmt::format("scene {} is for {}, and {} is for {}", racebeam::quoted(file.scenes[at]),
                      built[at]->name, racebeam::quoted(file.scenes.front()), built.front()->name),
          "points are settings of one engine: write a sweep for each");
  file.built = built.front();
  file.base = {"chip", file.built->standard(nullptr)};
}

void check_measure(const TableReader& table, const SweepNames& names, const engine& built,
                   const SweepMeasure& measure, Faults& faults) {
  if (!names.measures) return;
  const EngineMeasures kind = names.measures(built);
  const auto refuse = [&](const char* key, const std::string& why, const std::string& help) {
    if (const TomlNode* node = table.find(key)) faults.add(node->place, why, help);
  };
  if (measure.causes && !kind.causes)
    refuse("causes", fmt::format("errors of {} have no causes", built.name),
           "leave it out: the figures picture_error and error.levels say how many there are");
  if (measure.reference > kind.reference)
    refuse("reference",
           fmt::format("pictures of {} are not compared with {}", built.name,
                       reference_words()[static_cast<std::size_t>(measure.reference)]),
           "leave it out: they are compared with its golden tracer");
}

void check_population(const TableReader& table, const SweepSearch& search, Faults& faults) {
  const auto place = [&](const char* key) {
    const TomlNode* const node = table.find(key);
    return (node ? node : table.find("method"))->place;
  };
  if (search.population % 4 != 0)
    faults.add(place("population"), fmt::format("'population' is {}", search.population),
               "nsga2 pairs its points by fours: write a multiple of 4");
  if (std::int64_t{search.population} * (search.generations + 1) > SweepFile::MostPoints)
    faults.add(place("generations"),
               fmt::format("'generations' is {} and 'population' is {}", search.generations,
                           search.population),
               fmt::format("with the first generation they may ask for {} points together",
                           int{SweepFile::MostPoints}));
  if (const TomlNode* race = table.find("race"); race && search.race)
    faults.warn(race->place, "'race' has no effect with nsga2",
                "all points of a search have the same frames");
}

void read_search(const TomlNode& node, SweepSearch& search, Faults& faults) {
  const TableReader table(node, "search", faults, sweep_keys());
  int number = 0;
  if (table.read_choice("method", method_words(), number))
    search.method = static_cast<SearchMethod>(number);
  table.read("points", 1, SweepFile::MostPoints, search.points);
  table.read("population", SweepFile::SmallestPopulation, SweepFile::MostPoints, search.population);
  table.read("generations", 1, SweepFile::MostPoints, search.generations);
  if (table.read("seed", 0, std::numeric_limits<int>::max(), number))
    search.seed = static_cast<std::uint32_t>(number);
  table.read("race", search.race);
  if (const TomlNode* points = table.find("points"); points && search.method != SearchMethod::Sobol)
    faults.warn(points->place, "'points' counts for sobol only",
                search.adapts() ? "'population' and 'generations' say how many nsga2 looks at"
                                : "the other methods take the points that the knobs make");
  if (search.adapts()) check_population(table, search, faults);
  else
    for (const char* key : {"population", "generations"})
      if (const TomlNode* node = table.find(key))
        faults.warn(node->place, fmt::format("'{}' counts for nsga2 only", key),
                    "the other methods have one generation");
}

void read_pictures(const TomlNode& node, SweepMeasure& measure, Faults& faults) {
  if (node.kind != TomlNode::Array) {
    wrong_type(node, "pictures", "a list of frames, [512, \"worst\"]", faults);
    return;
  }
  for (const TomlNode& item : node.items) {
    int number = 0;
    if (item.kind == TomlNode::String)
      measure.worst_picture |= read_word(item, "pictures", {"worst"}, number, faults);
    else if (read_number(item, "pictures", 0, MaxFrames - 1, number, faults,
                         "a frame, or \"worst\""))
      measure.pictures.push_back(number);
  }
}

void read_measure(const TomlNode& node, const SweepNames& names, const engine& built,
                  SweepMeasure& measure, Faults& faults) {
  const TableReader table(node, "measure", faults, sweep_keys());
  int number = 0;
  table.read("causes", measure.causes);
  if (table.read_choice("silicon", {"off", "generic"}, number)) measure.silicon = number == 1;
  if (table.read_choice("timing", {"off", "front", "all"}, number))
    measure.timing = static_cast<SweepTiming>(number);
  if (const TomlNode* pictures = table.find("pictures")) read_pictures(*pictures, measure, faults);
  if (table.read_choice("reference", reference_words(), number))
    measure.reference = static_cast<SweepReference>(number);
  check_measure(table, names, built, measure, faults);
}

// Those of an engine; one of another engine is told from one that nobody has.
std::vector<SweepFigure> figures_of(const SweepNames& names, const engine& built) {
  std::vector<SweepFigure> figures = names.figures;
  for (SweepFigure& figure : figures)
    figure.foreign =
        !figure.engines.empty() &&
        std::find(figure.engines.begin(), figure.engines.end(), &built) == figure.engines.end();
  return figures;
}

// Goals that nsga2 trades against each other.
void check_goals(const SweepFile& file, const TomlNode* search, Faults& faults) {
  const auto traded = std::count_if(file.goals.begin(), file.goals.end(),
                                    [](const Goal& goal) { return goal.kind != GoalKind::Limit; });
  if (file.search.adapts() && traded < 2)
    faults.add(search->find("method")->place, "nsga2 has " + counted(traded, "goal"),
               "it looks for the front of two or more: [goals] picture_error = \"min\", "
               "decisions = \"min\"");
}

void check_first_generation(const SweepFile& file, const TomlNode& search, Faults& faults) {
  const int wanted = file.search.population;
  const bool few = grid_points(file) < wanted;
  const int first = few ? static_cast<int>(grid_points(file)) : sweep_points(file).of_search;
  if (first < wanted)
    faults.add(
        file.knobs.empty() ? search.find("method")->place
        : few              ? file.knobs_place
                           : file.where_place,
        fmt::format("{} {}, and a generation has {}", few ? "the knobs make" : "'where' leaves",
                    counted(first, "point"), wanted),
        "method = \"grid\" measures all of them; or name more values, or a smaller "
        "'population'");
}

// Of a file without faults.
void check_points(const SweepFile& file, const TomlNode* search, Faults& faults) {
  const double grid = grid_points(file);
  if (file.search.method == SearchMethod::Grid && grid > SweepFile::MostPoints) {
    faults.add(
        file.knobs_place, fmt::format("the grid has {:.0f} points", grid),
        fmt::format("it may have {}; [search] method = \"sobol\" spreads as many as you want "
                    "over all knobs",
                    int{SweepFile::MostPoints}));
    return;
  }
  if (file.search.adapts()) {
    check_first_generation(file, *search, faults);
    return;
  }
  if (!file.where.empty() && sweep_points(file).of_search == 0)
    faults.add(file.where_place, "'where' leaves no point", "allow more, or name other values");
}

}  // namespace

SweepResult read_sweep(std::string_view text, const std::string& name, const SweepNames& names,
                       const std::vector<std::string>& narrowed) {
  SweepResult result;
  SweepFile& file = result.file;
  Faults& faults = result.faults;
  file.name = name;
  const std::optional<TomlNode> root = parse_toml(text, faults);
  if (!root) return result;
  const TableReader top(*root, "", faults, sweep_keys());
  top.read("name", file.name);
  if (const TomlNode* node = top.find("scenes")) read_scenes(*node, names, file.scenes, faults);
  read_engine(top.find("scenes"), names, file, faults);
  const std::vector<SweepFigure> figures = figures_of(names, *file.built);
  if (const TomlNode* node = top.find("frames")) read_frames(*node, figures, file.frames, faults);
  if (const TomlNode* node = top.find("knobs")) read_swept_knobs(*node, file, faults);
  read_points(top.find("base"), top.find("point"), file, faults);
  if (const TomlNode* node = top.find("search")) read_search(*node, file.search, faults);
  if (const TomlNode* node = top.find("measure"))
    read_measure(*node, names, *file.built, file.measure, faults);
  if (const TomlNode* node = top.find("goals"))
    file.goals = read_goals(*node, figures, file.measure, faults);
  if (!faults.none()) return result;
  check_goals(file, top.find("search"), faults);
  if (!faults.none()) return result;
  for (const std::string& assignment : narrowed) narrow(file, assignment);
  check_points(file, top.find("search"), faults);
  return result;
}

SweepResult read_sweep_file(const std::string& path, const SweepNames& names,
                            const std::vector<std::string>& narrowed) {
  Faults faults;
  std::optional<std::string> text = read_input_file(path, "sweep", faults);
  if (!text) return {{}, std::move(faults)};
  SweepResult result =
      read_sweep(*text, std::filesystem::path(path).stem().string(), names, narrowed);
  result.text = std::move(*text);
  return result;
}

SweepResult load_sweep(const std::string& path, const SweepNames& names,
                       const std::vector<std::string>& narrowed) {
  SweepResult result = read_sweep_file(path, names, narrowed);
  std::fputs((result.faults.text(path) + result.faults.warnings(path)).c_str(), stderr);
  if (!result.faults.none())
    throw UsageError(counted(result.faults.count(), "fault") + " in " + path);
  return result;
}

}  // namespace racebeam
