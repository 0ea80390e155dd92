// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/verdict_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tb/sweep/interval_text.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

const char* doubt(const Estimate& change) {
  return !change.differs_from(0) ? ": not surely" : change.so_far() ? ", so far" : "";
}

std::string magnitude(const PointFigure& figure, Estimate change) {
  change.value = std::abs(change.value);
  return text_of(change, figure.kind == PointFigure::Percent ? "points" : figure.unit);
}

std::string sentence(const PointFigure& figure, const std::string& better, const std::string& base,
                     const Estimate& change, int rivals) {
  return fmt::format(
      "{} has {} {} than {} by {}{}{}\n", better, change.value < 0 ? "less" : "more", figure.name,
      base, magnitude(figure, change),
      rivals > 1 && !change.all() ? fmt::format(" (95 % for the best of {})", rivals) : "",
      doubt(change));
}

}  // namespace

const char* standing_word(Verdict::Standing standing) {
  switch (standing) {
    case Verdict::Front: return "front";
    case Verdict::Dominated: return "dominated";
    case Verdict::Undecided: return "undecided";
    case Verdict::Unwanted: return "unwanted";
  }
  return "";
}

std::vector<const PointFigure*> shown_figures(const SweepFile& file) {
  std::vector<const PointFigure*> figures;
  const auto add = [&](const std::string& name) {
    const PointFigure* figure = figure_named(name, *file.built);
    if (std::find(figures.begin(), figures.end(), figure) == figures.end())
      figures.push_back(figure);
  };
  for (const Goal& goal : file.goals) add(goal.figure);
  for (const char* name : sweep_kind(*file.built).shown) add(name);
  if (file.measure.silicon) add("cells");
  if (file.measure.timing != SweepTiming::Off)
    for (const char* name : {"area", "longest_path", "ice40.luts", "ice40.clock"}) add(name);
  return figures;
}

std::string best_words(const SweepFile& file, const std::vector<Candidate>& candidates,
                       const std::vector<Verdict>& verdicts, int points) {
  for (std::size_t n = 0; n < file.goals.size(); ++n) {
    const Goal& goal = file.goals[n];
    const PointFigure& figure = *figure_named(goal.figure, *file.built);
    if (goal.kind == GoalKind::Limit || !figure.sampled()) continue;
    const double sign = goal.kind == GoalKind::Max ? -1 : 1;
    std::size_t best = 0;
    Estimate change;
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      if (verdicts[i].standing != Verdict::Front) continue;
      const Estimate one = difference_of(candidates[i].readings[n].frames,
                                         candidates[0].readings[n].frames, for_best_of(points - 1));
      if (best != 0 && sign * one.value >= sign * change.value) continue;
      best = i;
      change = one;
    }
    if (best == 0 || sign * change.value >= 0) continue;
    return sentence(figure, candidates[best].name, candidates[0].name, change, points - 1);
  }
  return "";
}

std::string counts_words(const SweepFile& file, const std::vector<Verdict>& verdicts, int failed) {
  if (file.goals.empty()) return fmt::format("{} measured, {} failed\n", verdicts.size(), failed);
  int standings[4] = {};
  for (const Verdict& verdict : verdicts) ++standings[verdict.standing];
  return fmt::format("{} on the front, {} undecided, {} dominated, {} unwanted, {} failed\n",
                     standings[Verdict::Front], standings[Verdict::Undecided],
                     standings[Verdict::Dominated], standings[Verdict::Unwanted], failed);
}

std::string change_words(const PointFigure& figure, Estimate change) {
  return magnitude(figure, change) + doubt(change);
}

}  // namespace racebeam
