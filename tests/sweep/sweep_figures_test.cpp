// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "sc/beam/engine.h"
#include "sc/beam/frame_stats.h"
#include "sc/sphere/engine.h"
#include "tb/base/errors.h"
#include "tb/judge/error_causes.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/figures.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A frame by names of columns.
struct Rows {
  std::vector<std::string> columns;
  FrameRow row;

  explicit Rows(const std::map<std::string, std::int64_t>& values) {
    for (const auto& [name, value] : values) {
      columns.push_back(name);
      row.values.push_back(value);
    }
  }
};

double value_of(const char* figure, const std::map<std::string, std::int64_t>& values) {
  const Rows rows(values);
  return FigureReader(*figure_named(figure), rows.columns).value(rows.row);
}

TEST(FiguresTest, NamesAreUniqueToAnEngineAndExplained) {
  std::set<std::pair<const engine*, std::string>> names;
  for (const PointFigure& figure : figure_table()) {
    for (const engine* one : engines_with(figure)) {
      EXPECT_TRUE(names.emplace(one, figure.name).second) << figure.name << " of " << one->name;
      EXPECT_EQ(figure_named(figure.name, *one), &figure);
    }
    EXPECT_STRNE(figure.unit, "") << figure.name;
    EXPECT_NE(figure.meaning, "") << figure.name;
    EXPECT_EQ(figure.terms.empty(), figure.kind == PointFigure::Exact) << figure.name;
    EXPECT_NE(figure_named(figure.name), nullptr);
  }
  EXPECT_EQ(figure_named("errors"), nullptr);
}

TEST(FiguresTest, PixelsAreSharesOfThePicture) {
  EXPECT_DOUBLE_EQ(value_of("picture_error", {{"error_pixels", 3'072}}), 1);
  EXPECT_DOUBLE_EQ(value_of("error.visible", {{"visible_error_pixels", 307'200}}), 100);
  EXPECT_DOUBLE_EQ(value_of("starved", {{"seen_starved_pixels", 1'536}}), 0.5);
}

TEST(FiguresTest, WorkIsALine) {
  EXPECT_DOUBLE_EQ(value_of("decisions", {{"decisions", 480 * 7}}), 7);
  EXPECT_DOUBLE_EQ(value_of("bisections", {{"bisection_steps", 240}}), 0.5);
  EXPECT_DOUBLE_EQ(value_of("restarts", {{"restarts", 48}}), 0.1);
  EXPECT_DOUBLE_EQ(value_of("give_ups", {{"give_ups", 960}}), 2);
  EXPECT_DOUBLE_EQ(value_of("returns", {{"returns", 4'800}}), 10);
  EXPECT_DOUBLE_EQ(value_of("emits", {{"emits", 4'800}}), 10);
  EXPECT_DOUBLE_EQ(value_of("busy", {{"busy_clocks.sum", 127'979}}), 127'979 / 480.0);
  EXPECT_DOUBLE_EQ(value_of("fifo.full_stalls", {{"fifo_full_stalls", 4'800}}), 10);
}

TEST(FiguresTest, LinesAndClocksAreAsTheyAre) {
  EXPECT_DOUBLE_EQ(value_of("busy.max", {{"busy_clocks.max", 840}}), 840);
  EXPECT_DOUBLE_EQ(value_of("busy.p99", {{"busy_clocks.p99", 833}}), 833);
  EXPECT_DOUBLE_EQ(value_of("lines_not_done", {{"done_clock.never", 3}}), 3);
}

// 160 pixels before the first visible one: 320 clocks on the chip, 160 with one clock a pixel.
TEST(FiguresTest, FirstEmitIsWhatIsLeftOfTheHeadStart) {
  const auto first_emit = [](int clocks, int sum, int never) {
    return value_of(
        "first_emit",
        {{"clocks", clocks}, {"first_emit_clock.sum", sum}, {"first_emit_clock.never", never}});
  };
  EXPECT_DOUBLE_EQ(first_emit(840'000, 480 * 100, 0), 220);
  EXPECT_DOUBLE_EQ(first_emit(420'000, 480 * 100, 0), 60);
  EXPECT_DOUBLE_EQ(first_emit(840'000, 480 * 400, 0), -80);  // behind the beam
  EXPECT_DOUBLE_EQ(first_emit(840'000, 240 * 100, 240), (220 + 320 - 1'600) / 2.0);
}

TEST(FiguresTest, MeansAreOverWhatWasCounted) {
  EXPECT_DOUBLE_EQ(
      value_of("stack.mean",
               {{"stack_depth.sum", 300}, {"busy_clocks.sum", 140}, {"fifo_full_stalls", 10}}),
      2);
  EXPECT_DOUBLE_EQ(value_of("walk.mean", {{"walk_steps.sum", 7}, {"left_decisions", 2}}), 3.5);
  EXPECT_DOUBLE_EQ(value_of("walk.mean", {{"walk_steps.sum", 0}, {"left_decisions", 0}}), 0)
      << "a frame in which nothing was decided";
}

TEST(FiguresTest, AShareOfFramesIsOfThoseThatHaveAny) {
  EXPECT_DOUBLE_EQ(value_of("starved.frames", {{"seen_starved_pixels", 1}}), 100);
  EXPECT_DOUBLE_EQ(value_of("starved.frames", {{"seen_starved_pixels", 0}}), 0);
  EXPECT_DOUBLE_EQ(value_of("starved.max", {{"seen_starved_pixels", 307'200}}), 100);
}

TEST(FiguresTest, EveryCauseOfAnErrorIsAFigure) {
  for (const auto reference : {PictureReference::Geometry, PictureReference::Trace4})
    for (const ErrorCause& cause : error_causes(reference)) {
      const PointFigure* const figure = figure_named(std::string("error.") + cause.name);
      ASSERT_NE(figure, nullptr) << cause.name;
      EXPECT_TRUE(figure->of_cause && figure->sampled());
      EXPECT_STREQ(figure->measure(), "causes");
      EXPECT_DOUBLE_EQ(value_of(figure->name.c_str(), {{cause.name, 3'072}}), 1);
    }
}

TEST(FiguresTest, AllFiguresOfFramesAreKept) {
  for (const PointFigure& figure : figure_table())
    EXPECT_FALSE(engines_with(figure).empty()) << figure.name;
}

TEST(FiguresTest, AnEngineHasFiguresOfItsOwn) {
  EXPECT_EQ(figure_named("starved", sphere_engine()), nullptr);
  EXPECT_EQ(figure_named("stalls", beam_engine()), nullptr);
  EXPECT_NE(figure_named("picture_error", sphere_engine()),
            figure_named("picture_error", beam_engine()));
}

TEST(FiguresTest, PartsOfALineAddUpToIt) {
  std::map<std::string, std::int64_t> values;
  for (const line_info& line : beam_engine().lines)
    if (*line.part) values[std::string(line.name) + ".sum"] = 480 * 200;
  EXPECT_EQ(values.size(), LineParts);
  double sum = 0;
  for (const PointFigure& figure : figure_table())
    if (figure.name.rfind("line.", 0) == 0) sum += value_of(figure.name.c_str(), values);
  EXPECT_DOUBLE_EQ(sum, 200.0 * LineParts);
}

/// A column of a frame in which a histogram has these bins.
std::int64_t column_of(const char* column, const char* histogram,
                       const std::map<int, std::uint64_t>& bins) {
  const engine& beam = beam_engine();
  frame_counts counts;
  counts.counters.resize(beam.counters.size());
  counts.lines.resize(beam.lines.size());
  for (const histogram_info& info : beam.histograms) {
    counts.histograms.emplace_back(65);
    if (std::string(info.name) == histogram)
      for (const auto& [value, count] : bins)
        counts.histograms.back().at(static_cast<std::size_t>(value)) = count;
  }
  const std::vector<std::string> names = sweep_columns(beam);
  const auto at = std::find(names.begin(), names.end(), column);
  if (at == names.end()) throw std::invalid_argument(column);
  return column_values(beam, counts, {}, {}).at(static_cast<std::size_t>(at - names.begin()));
}

TEST(SweepColumnsTest, HistogramsHaveSumsAndPercentiles) {
  EXPECT_EQ(column_of("stack_depth.sum", "stack_depth", {{0, 9}, {1, 5}, {4, 2}}), 13);
  EXPECT_EQ(column_of("fifo_fill.p50", "fifo_fill", {{0, 2}, {3, 3}, {10, 1}}), 3);
  EXPECT_EQ(column_of("fifo_fill.p50", "fifo_fill", {{0, 3}, {10, 3}}), 0);
  EXPECT_EQ(column_of("fifo_fill.p50", "fifo_fill", {}), 0);
}

// Of 307,200 pixels; bins of 32 clocks.
TEST(SweepColumnsTest, PixelsThatAreKnownTooLateHaveNoSlack) {
  const auto slack = [](const char* column, const std::map<int, std::uint64_t>& bins) {
    return column_of(column, "slack", bins);
  };
  EXPECT_EQ(slack("slack.p50", {{2, 307'200}}), 64 + 15) << "they lie evenly in a bin";
  EXPECT_EQ(slack("slack.p1", {{2, 307'200}}), 64);
  EXPECT_EQ(slack("slack.p1", {{5, 307'200 - 3'072}}), 0) << "1 % starve";
  EXPECT_EQ(slack("slack.p1", {{5, 307'200 - 3'071}}), 160);
  EXPECT_EQ(slack("slack.p50", {{5, 1'000}, {6, 152'600}}), 0);
  EXPECT_EQ(slack("slack.p50", {{5, 1'000}, {6, 152'601}}), 160);
}

TEST(FiguresTest, ColumnsAreFoundByName) {
  EXPECT_DOUBLE_EQ(value_of("restarts", {{"clocks", 1}, {"restarts", 480}, {"zebra", 3}}), 1);
}

TEST(FiguresTest, MissingColumnIsNamed) {
  const PointFigure& figure = *figure_named("first_emit");
  EXPECT_EQ(figure.missing({"clocks", "first_emit_clock.never", "first_emit_clock.sum"}), nullptr);
  EXPECT_STREQ(figure.missing({"clocks", "first_emit_clock.never"}), "first_emit_clock.sum");
  try {
    FigureReader(figure, {"clocks"});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("first_emit_clock.sum"));
  }
}

TEST(FiguresTest, ExactFiguresAreNotOfFrames) {
  EXPECT_THROW(FigureReader(*figure_named("cells"), {"cells"}), UsageError);
  EXPECT_FALSE(figure_named("flip_flops")->sampled());
  EXPECT_FALSE(figure_named("busy.max")->sampled());
  EXPECT_TRUE(figure_named("picture_error")->sampled());
}

std::vector<FrameRow> rows_of_frames() {
  return {{70, false, 0, {480}}, {7, true, 0, {480'000}}, {3, false, 0, {960}}};
}

TEST(FiguresTest, SampleIsSortedByFrameWithoutGuards) {
  const Stratum stratum =
      FigureReader(*figure_named("decisions"), {"decisions"}).stratum(rows_of_frames(), 100);
  EXPECT_THAT(stratum.frames, ElementsAre(3, 70));
  EXPECT_THAT(stratum.values, ElementsAre(2, 1));
  EXPECT_EQ(stratum.population, 100);
}

TEST(FiguresTest, WorstLooksAtGuardsToo) {
  const FigureReader reader(*figure_named("busy.max"), {"busy_clocks.max"});
  const Worst worst = worst_of({reader.stratum(rows_of_frames(), 100)});
  EXPECT_EQ(worst.value, 480'000);
  EXPECT_EQ(worst.frame, 7);
  EXPECT_EQ(worst.frames, 3);
}

}  // namespace
}  // namespace racebeam
