// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tb/base/counted.h"
#include "tb/sweep/aligned_rows.h"
#include "tb/sweep/figures.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/verdict_words.h"

namespace racebeam {

namespace {

constexpr std::size_t MostRows = 40;

// Of one scene, or of all (-1).
Strata strata_of(const PointReading& read, int scene) {
  if (scene < 0) return read.reading.frames;
  return {read.reading.frames[static_cast<std::size_t>(scene)]};
}

std::string cell(const PointFigure& figure, const PointReading& read, int scene) {
  if (!read.there) return "-";
  if (figure.kind == PointFigure::Exact) return text_of(read.reading.exact, "");
  const Strata strata = strata_of(read, scene);
  if (figure.sampled()) return text_of(mean_of(strata), figure.unit[0] == '%' ? "%" : "");
  return text_of(worst_of(strata).value) + "*";
}

/// The verdicts of a sweep as text.
class Summary {
 public:
  Summary(const SweepPlan& plan, const Measurer& measurer, const SweepState& state, int frames)
      : plan_(plan),
        measurer_(measurer),
        state_(state),
        frames_(frames),
        all_(state.judge(frames)),
        figures_(shown_figures(plan.file)) {
    choose_rows();
  }

  std::string text() const {
    std::string text = table(-1);
    if (plan_.scenes.size() > 1)
      for (int scene = 0; scene < static_cast<int>(plan_.scenes.size()); ++scene)
        text += "\n" + plan_.scenes[static_cast<std::size_t>(scene)].name + "\n" + table(scene);
    if (left_out_ > 0) text += fmt::format("... and {} more\n", left_out_);
    text += longest_note() +
            best_words(plan_.file, all_.candidates, all_.verdicts,
                       static_cast<int>(plan_.points.size())) +
            counts_words(plan_.file, all_.verdicts, measurer_.failed());
    for (int point = 0; point < static_cast<int>(plan_.points.size()); ++point)
      if (const std::string& why = measurer_.failure(point); !why.empty())
        text += fmt::format("failed: {}: {}\n", name(point), why);
    return text;
  }

 private:
  const std::string& name(int point) const {
    return plan_.points[static_cast<std::size_t>(point)].point.name;
  }

  // The front and the base; without goals all points.
  void choose_rows() {
    const bool goals = !plan_.file.goals.empty();
    for (std::size_t i = 0; i < all_.points.size(); ++i)
      if (!goals || all_.points[i] == 0 || all_.verdicts[i].standing == Verdict::Front)
        rows_.push_back(i);
    if (goals)
      std::stable_sort(rows_.begin(), rows_.end(),
                       [&](std::size_t a, std::size_t b) { return first(a) < first(b); });
    if (rows_.size() > MostRows) {
      left_out_ = rows_.size() - MostRows;
      rows_.resize(MostRows);
    }
  }

  // The first goal's figure.
  double first(std::size_t candidate) const {
    const Reading& reading = all_.candidates[candidate].readings.front();
    if (reading.kind == Reading::Exact) return reading.exact;
    return reading.kind == Reading::Sampled ? mean_of(reading.frames).value
                                            : worst_of(reading.frames).value;
  }

  std::string table(int scene) const {
    std::vector<TextRow> rows = {{"", "point", "frames"}};
    for (const PointFigure* figure : figures_) rows[0].push_back(figure->name);
    for (const std::size_t candidate : rows_) {
      const int point = all_.points[candidate];
      const PointReading any =
          state_.read(point, *figure_named("picture_error", *plan_.file.built), frames_);
      std::size_t frames = 0;
      for (const Stratum& stratum : strata_of(any, scene)) frames += stratum.frames.size();
      TextRow row = {
          plan_.file.goals.empty() ? "" : standing_word(all_.verdicts[candidate].standing),
          name(point), grouped(static_cast<long long>(frames))};
      for (const PointFigure* figure : figures_)
        row.push_back(cell(*figure, state_.read(point, *figure, frames_), scene));
      row.push_back(setting_words(plan_, point));
      rows.push_back(std::move(row));
    }
    return aligned(rows);
  }

  std::string longest_note() const {
    for (const PointFigure* figure : figures_)
      if (figure->kind == PointFigure::Largest) {
        const Worst worst = worst_of(state_.read(0, *figure, frames_).reading.frames);
        return fmt::format("* worst of the {} frames rendered\n", grouped(worst.frames));
      }
    return "";
  }

  const SweepPlan& plan_;
  const Measurer& measurer_;
  const SweepState& state_;
  const int frames_;
  const SweepState::Verdicts all_;
  const std::vector<const PointFigure*> figures_;
  std::vector<std::size_t> rows_{};  // candidates
  std::size_t left_out_ = 0;
};

}  // namespace

std::string setting_words(const SweepPlan& plan, int point) {
  const SweepPoint& base = plan.points.front().point;
  const SweepPoint& of = plan.points[static_cast<std::size_t>(point)].point;
  std::string text;
  for (const knob_row* row : of.set) {
    if (point != 0 && of.value_of(*row) == base.value_of(*row)) continue;
    text += (text.empty() ? "" : " ") + std::string(row->name) + "=" + row->text(of.value_of(*row));
  }
  return text;
}

std::string plan_text(const SweepPlan& plan, int there) {
  std::string text = fmt::format("{}: {}", plan.file.name, counted(plan.points.size(), "point"));
  if (!plan.file.knobs.empty()) text += " of " + counted(plan.file.knobs.size(), "knob");
  if (const SweepSearch& search = plan.file.search; search.adapts())
    text += fmt::format(", then {} of {} by nsga2", counted(search.generations, "generation"),
                        search.population);
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene)
    text +=
        fmt::format("; {}, {} of {} frames", plan.scenes[scene].name, grouped(plan.sample(scene)),
                    grouped(static_cast<long long>(plan.scenes[scene].order.size())));
  if (plan.left_out > 0)
    text += fmt::format(" ({} left out: {})", grouped(plan.left_out),
                        fmt::join(plan.file.frames.skip, ", "));
  if (plan.file.frames.guard > 0) text += fmt::format(" + {} guard frames", plan.file.frames.guard);
  if (there > 0) text += fmt::format("; {} frames are there already", grouped(there));
  return text;
}

std::string summary_text(const SweepPlan& plan, const Measurer& measurer, const SweepState& state,
                         int frames) {
  return Summary(plan, measurer, state, frames).text();
}

}  // namespace racebeam
