// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/stats_json.h"

#include <gtest/gtest.h>

#include "sc/beam/counters.h"
#include "sc/beam/engine.h"
#include "tb/report/stats_table.h"
#include "tests/support/json.h"

namespace racebeam {
namespace {

frame_counts frame_of(std::vector<int> busy) {
  frame_stats stats;
  stats.clocks = 840'000;
  stats.left_decisions = 5;
  stats.right_decisions = 3;
  stats.bisection_steps = 2;
  stats.fifo_fill[10] = 7;
  stats.fifo_fill[11] = 9;  // beyond the FIFO: never shown
  stats.camera_clocks = {47, 50};
  stats.first_emit = {-1, 60};
  stats.done_clock = {-1, -1};
  stats.busy_clocks = std::move(busy);
  return counted(stats);
}

Json report_of(const StatsReport& report) { return Json::parse(report.text()); }

TEST(SpreadTest, PercentileIsTheLeastValueThatCoversIt) {
  Spread spread;
  for (int value = 100; value >= 1; --value) spread.add(value);
  EXPECT_EQ(spread.min(), 1);
  EXPECT_EQ(spread.max(), 100);
  EXPECT_EQ(spread.percentile(99), 99);
  EXPECT_EQ(spread.percentile(50), 50);
  EXPECT_DOUBLE_EQ(spread.mean(), 50.5);
  for (int i = 0; i < 10'000; ++i) spread.add(3);
  EXPECT_EQ(spread.percentile(99), 3);
}

TEST(StatsReportTest, WithoutFramesIsStillWhole) {
  const Json document = report_of(StatsReport(beam_engine(), "demo", "signal", knobs()));
  EXPECT_EQ(document.at("frames"), Json::array());
  EXPECT_EQ(document.at("total").at("clocks"), 0);
  EXPECT_TRUE(document.at("total").at("busy_clocks").is_null());
}

TEST(StatsReportTest, LinesWithoutAValueAreCountedNotAveraged) {
  StatsReport report(beam_engine(), "demo", "signal", knobs());
  report.add(9, "pillars", frame_of({100, 300}), {}, false);
  const Json frame = report_of(report).at("frames")[0];
  EXPECT_EQ(frame.at("decisions"), 10);
  EXPECT_EQ(frame.at("fifo_fill").size(), 11);
  EXPECT_EQ(frame.at("camera_clocks"),
            (Json{{"min", 47}, {"mean", 48.5}, {"max", 50}, {"sum", 97}}));
  EXPECT_EQ(frame.at("first_emit_clock"),
            (Json{{"min", 60}, {"mean", 60.0}, {"max", 60}, {"sum", 60}, {"lines_without", 1}}));
  EXPECT_EQ(frame.at("done_clock").at("lines_not_done"), 2);
  EXPECT_TRUE(frame.at("done_clock").at("min").is_null());
  EXPECT_EQ(frame.count("image_crc32"), 0);
}

TEST(StatsReportTest, TotalNamesTheWorstLineOfTheRun) {
  StatsReport report(beam_engine(), "demo", "signal", knobs());
  report.add(9, "pillars", frame_of({100, 300}), {}, false);
  report.add(10, "pillars", frame_of({700, 200}), {}, false);
  const Json document = report_of(report);
  EXPECT_EQ(document.at("frames")[0].at("busy_clocks").at("worst_line"), -239);
  const Json& busy = document.at("total").at("busy_clocks");
  EXPECT_EQ(busy.at("worst_frame"), 10);
  EXPECT_EQ(busy.at("worst_line"), -240);
  EXPECT_EQ(busy.at("min"), 100);
  EXPECT_EQ(busy.at("max"), 700);
  EXPECT_EQ(busy.at("sum"), 1300);
}

TEST(StatsReportTest, AnEngineMayCountNothingButItsOwnCounters) {
  engine other = beam_engine();
  other.counters = {{"words", "words", 8}};
  other.histograms.clear();
  other.lines.clear();
  StatsReport report(other, "plain", "signal", knobs());
  for (const std::uint64_t words : {3, 4}) report.add(0, "", {{words}, {}, {}}, {}, false);
  const Json document = report_of(report);
  EXPECT_EQ(document.at("frames")[1], (Json{{"frame", 0}, {"part", ""}, {"words", 4}}));
  EXPECT_EQ(document.at("total"), (Json{{"frames", 2}, {"words", 7}}));
}

TEST(StatsReportTest, PartsOfALineAreTold) {
  frame_stats stats;
  stats.add_line({50, 100, 60, 10, 20, 60, 300, 1000});
  stats.add_line({52, 100, 60, 10, 20, 60, 0, 1298});
  StatsReport report(beam_engine(), "demo", "signal", knobs());
  EXPECT_EQ(line_account(report), "");
  report.add(9, "pillars", counted(stats), {}, false);
  EXPECT_EQ(line_account(report),
            "clocks of a line: camera 51.0, decide 100.0, bisect 60.0, walk 10.0, enter 20.0, "
            "return 60.0, wait 150.0, idle 1149.0, in all 1600\n");
  EXPECT_EQ(report_of(report).at("total").at("line_idle"),
            (Json{{"min", 1000}, {"mean", 1149.0}, {"max", 1298}, {"sum", 2298}}));
}

TEST(StatsReportTest, TheSchemaHasAVersion) {
  const Json document = report_of(StatsReport(beam_engine(), "demo", "signal", knobs()));
  EXPECT_EQ(document.at("frames"), Json::array());
  EXPECT_EQ(document.at("schema"), "racebeam-stats");
  EXPECT_EQ(document.at("version"), 3);
  EXPECT_EQ(document.at("engine"), "beam");
}

TEST(StatsReportTest, CrcsAreEightHexDigits) {
  StatsReport report(beam_engine(), "demo", "signal", knobs());
  VgaFrame picture;
  picture.image_crc = 0xabc;
  report.add(0, "pillars", frame_of({1, 2}), picture, true);
  const Json frame = report_of(report).at("frames")[0];
  EXPECT_EQ(frame.at("image_crc32"), "00000abc");
  EXPECT_EQ(frame.at("pins_crc32"), "00000000");
}

}  // namespace
}  // namespace racebeam
