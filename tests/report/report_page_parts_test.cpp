// The parts of a report's page: texts as HTML, files as text, what each knob does.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tb/report/html.h"
#include "tb/report/knob_effects.h"
#include "tb/report/page_files.h"
#include "tb/report/report_data.h"
#include "tb/sweep/csv_rows.h"
#include "tests/report/report_bench.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Base64, IsThatOfRfc4648) {
  const char* const expected[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t length = 0; length <= 6; ++length)
    EXPECT_EQ(base64(std::string("foobar").substr(0, length)), expected[length]);
  EXPECT_EQ(base64("\xff\xef\xbe"), "/+++");
}

TEST(Html, WhatIsNoUtf8IsReplaced) {
  EXPECT_EQ(html("a\xff<\x01>"), "a\xef\xbf\xbd&lt;\xef\xbf\xbd&gt;");
  EXPECT_EQ(html("caf\xc3\xa9 \U0001F642\n"), "caf\xc3\xa9 \U0001F642\n");
}

TEST(Html, JsonInAScriptHasNoTag) {
  const std::string json = json_in_html("[\"</script><!--\"]");
  EXPECT_EQ(json, "[\"\\u003c/script>\\u003c!--\"]");
  EXPECT_EQ(Json::parse(json).at(0).get<std::string>(), "</script><!--");
}

TEST(Csv, CellsReadBackAsTheyWereWritten) {
  const std::string odd = "a \"b\", c\nd";
  const auto rows = csv_rows("x,y\n" + csv_cell(odd) + ",1\r\n,\n2\n");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].at("x"), odd);
  EXPECT_EQ(rows[0].at("y"), "1");
  EXPECT_EQ(rows[2].at("x") + rows[2].at("y"), "2");
}

TEST(PageFiles, AreThoseOfTheFolder) {
  EXPECT_THAT(std::string(page_file("vega/vega.min.js").substr(0, 200)), HasSubstr("vega"));
  EXPECT_THAT(std::string(page_file("vega/LICENSE.vega-lite")), HasSubstr("Redistribution"));
  EXPECT_THROW(page_file("vega.js"), std::out_of_range);
}

TEST(KnobEffects, AStepIsTheMeanChangeOfPointsThatDifferInItAlone) {
  ReportFolder folder(
      "[frames]\nsample = 8\nguard = 0\n[search]\nrace = false\n"
      "[knobs]\ninterval_stack_depth = [2, 4]\nfifo_entries = [6, 10]\n"
      "[goals]\npicture_error = \"min\"\n");
  folder.put_all(8);
  const SweepReader reader(folder.path());
  const ReportedSweep& sweep = reader.sweep();
  const std::vector<KnobStep> steps = knob_steps(sweep);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].knob + steps[0].from + steps[0].to, "interval_stack_depth24");
  EXPECT_EQ(steps[0].pairs, 2);
  // A frame's error grows by as much with each point's number: chip (4, 10), p1 (2, 6), p2 (2, 10),
  // p3 (4, 6); so 2 -> 4 is the mean of 3 - 1 and 0 - 2, and 6 -> 10 of 2 - 1 and 0 - 3
  const auto column = std::find(folder.columns().begin(), folder.columns().end(), "error_pixels") -
                      folder.columns().begin();
  const double one = double(50 + column) / (640 * 480 / 100.0);
  EXPECT_NEAR(steps[0].changes[0]->value, 0, 1e-9);
  EXPECT_NEAR(steps[1].changes[0]->value, one * (1 - 3) / 2, 1e-9);
  EXPECT_NEAR(steps[1].changes[0]->half_width, 0, 1e-9) << "alike in all frames";
}

TEST(KnobEffects, PairsOfWhichOneStoppedEarlyAreLeftOut) {
  ReportFolder folder(
      "[frames]\nsample = 8\nguard = 0\n"
      "[knobs]\ninterval_stack_depth = [2, 4]\nfifo_entries = [6, 10]\n"
      "[goals]\npicture_error = \"min\"\n");
  folder.put_all(4);
  folder.put(0, 8);
  folder.put(2, 8);
  const SweepReader reader(folder.path());
  const KnobStep step = knob_steps(reader.sweep()).front();
  EXPECT_EQ(step.pairs, 1);
  EXPECT_EQ(step.left_out, 1);
  EXPECT_EQ(step.changes[0]->frames, 8);
}

TEST(KnobEffects, MeansOverPointsHaveStudentsInterval) {
  const PointsMean mean = mean_over_points({2, 4, 6});
  EXPECT_DOUBLE_EQ(mean.value, 4);
  EXPECT_NEAR(mean.half_width, 4.302653 * 2 / std::sqrt(3.0), 1e-5);
  EXPECT_TRUE(std::isinf(mean_over_points({1}).half_width));
}

TEST(KnobEffects, EtaSquaredIsTheShareBetweenGroups) {
  EXPECT_DOUBLE_EQ(*eta_squared({{1, 1}, {3, 3}}), 1);
  EXPECT_DOUBLE_EQ(*eta_squared({{1, 3}, {1, 3}}), 0);
  EXPECT_DOUBLE_EQ(*eta_squared({{0, 2}, {2, 4}}), 0.5);
  EXPECT_FALSE(eta_squared({{2}, {2}}));
}

TEST(KnobEffects, ManyValuesAreLookedAtInGroups) {
  ReportFolder folder(
      "[frames]\nsample = 2\nguard = 0\n[search]\nmethod = \"sobol\"\npoints = 64\n"
      "[knobs]\nhurry_threshold = { from = 0, to = 639 }\nbisection = [\"pow2\", \"midpoint\"]\n");
  folder.put_all(2);
  const SweepReader reader(folder.path());
  int groups = 0, points = 0;
  for (const KnobMean& mean : knob_means(reader.sweep())) {
    if (mean.knob != "hurry_threshold") continue;
    ++groups;
    EXPECT_THAT(mean.value, HasSubstr(".."));
    points += mean.means[0]->points;
    EXPECT_GE(mean.means[0]->points, 7);
  }
  EXPECT_EQ(groups, 8);
  EXPECT_EQ(points, folder.points()) << "each point is in one of them";
}

TEST(RepeatCommand, NamesTheKnobsThatAreNotTheScenes) {
  ReportFolder folder(
      "[frames]\nsample = 4\nguard = 0\n[[point]]\nname = \"it's\"\n"
      "knobs = { bisection = \"midpoint\" }\n");
  folder.put_all(4);
  const SweepReader reader(folder.path());
  EXPECT_EQ(repeat_command(reader.sweep(), 1, {}),
            fmt::format("racebeam render demo --at {} --set bisection=midpoint -o it%27s.png",
                        folder.plan().scenes[0].order[0]));
  ReportPictures pictures;
  pictures.taken.push_back({1, 0, 7223, "", ""});
  EXPECT_THAT(repeat_command(reader.sweep(), 1, pictures), HasSubstr(" --at 7223 "));
}

}  // namespace
}  // namespace racebeam
