// The page of a sweep: what is in it, what it reaches for, and whose numbers it has.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tb/base/errors.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/csv_rows.h"
#include "tests/report/report_bench.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Le;
using testing::Not;

constexpr const char* Grid =
    "name = \"grid\"\n[frames]\nsample = 16\nguard = 0\n"
    "[knobs]\ninterval_stack_depth = [2, 4, 8]\nfifo_entries = [6, 10]\n"
    "[goals]\npicture_error = \"min\"\nstarved = \"min\"\n";

/// A sweep of single points.
std::string named_points(const std::vector<std::string>& names) {
  std::string text = "name = " + Json(names.front()).dump() + "\n[frames]\nsample = 4\nguard = 0\n";
  for (std::size_t i = 1; i < names.size(); ++i)
    text += fmt::format("[[point]]\nname = {}\nknobs = {{ fifo_entries = {} }}\n",
                        Json(names[i]).dump(), 10 + i);
  return text;
}

TEST(ReportPage, ReachesForNothingOutsideOfItself) {
  ReportFolder sweep(Grid);
  sweep.put_all(16);
  const std::string page = sweep.page();
  EXPECT_THAT(page, HasSubstr("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src "
                              "'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                              "img-src data:; base-uri 'none'; form-action 'none'\">"));
  EXPECT_LT(page.find("Content-Security-Policy"), page.find("<style>"));
  for (const char* reference :
       {"<link", "<iframe", "<script src", "src=\"http", "src=\"//", "href=", "@import", "url(http",
        "sourceMappingURL", "<base", "<object", "<embed"}) {
    // The libraries' own texts are no tags of the page
    const std::string own = page.substr(0, page.find("id=\"data\""));
    EXPECT_THAT(own, Not(HasSubstr(reference)));
  }
  EXPECT_THAT(page, Not(HasSubstr("sourceMappingURL")));
}

TEST(ReportPage, NumbersAreThoseOfTheStoresExport) {
  ReportFolder sweep(Grid);
  sweep.put_all(16);
  ScratchFolder folder;
  OutputFile out(folder / "points.csv");
  export_points(sweep.store(), sweep.key(0).model, out);
  out.commit();
  const auto rows = csv_rows(whole_file(folder / "points.csv"));
  const std::string page = sweep.page();
  const auto names = data_of(page).at("points").at("name");
  ASSERT_EQ(rows.size(), names.size());
  const struct {
    const char* figure;
    const char* column;
    double divisor;
  } all[] = {{"picture_error", "error_pixels", 640 * 480 / 100.0},
             {"starved", "seen_starved_pixels", 640 * 480 / 100.0},
             {"restarts", "restarts", 480},
             {"give_ups", "give_ups", 480}};
  for (const auto& one : all) {
    const Json values = figure_of(page, one.figure).at("value");
    const Json changes = figure_of(page, one.figure).at("change");
    double base = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(names.at(i).get<std::string>(), rows[i].at("point"));
      const double expected = std::stod(rows[i].at(one.column)) / one.divisor;
      if (i == 0) base = expected;
      EXPECT_NEAR(values.at(i).get<double>(), expected, 1e-6 * expected) << one.figure;
      EXPECT_NEAR(changes.at(i).get<double>(), expected - base, 1e-6 * expected) << one.figure;
    }
  }
}

TEST(ReportPage, IntervalsAreThoseOfTheSample) {
  ReportFolder sweep(Grid);
  sweep.put_all(16);
  // By the formula of the design: successive differences of the frames in order, Student's t
  const std::size_t column = static_cast<std::size_t>(
      std::find(sweep.columns().begin(), sweep.columns().end(), "restarts") -
      sweep.columns().begin());
  std::vector<int> frames(sweep.plan().scenes[0].order.begin(),
                          sweep.plan().scenes[0].order.begin() + 16);
  std::sort(frames.begin(), frames.end());
  double squares = 0;
  for (std::size_t i = 1; i < 16; ++i) {
    const auto step = double(ReportFolder::value(column, 0, frames[i]) -
                             ReportFolder::value(column, 0, frames[i - 1])) /
                      480;
    squares += step * step;
  }
  const double all = double(sweep.plan().scenes[0].order.size());
  const double expected = 2.131450 * std::sqrt(squares / (2 * 15 * 16) * (1 - 16 / all));
  EXPECT_NEAR(figure_of(sweep.page(), "restarts").at("half").at(0).get<double>(), expected,
              1e-5 * expected);
}

TEST(ReportPage, NamesEndNoTagAndNoScript) {
  const std::string name = "</script><img src=x onerror=alert(1)> \"q\" 'a' & \U0001F642";
  ReportFolder sweep(named_points({name, name + "!"}));
  sweep.put_all(4);
  const std::string page = sweep.page();
  EXPECT_EQ(count_of("<script", page), count_of("</script>", page));
  EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
  EXPECT_EQ(data_of(page).at("points").at("name").at(1).get<std::string>(), name + "!");
  EXPECT_THAT(page, HasSubstr("<h1>&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt; &quot;q&quot; "
                              "&#39;a&#39; &amp; \U0001F642</h1>"));
}

TEST(ReportPage, AFailedPointIsARowWithItsReason) {
  ReportFolder sweep(Grid);
  for (int point = 0; point + 1 < sweep.points(); ++point) sweep.put(point, 16);
  sweep.store().failures.put(sweep.key(sweep.points() - 1), "died: <Aborted>, twice");
  const std::string page = sweep.page();
  EXPECT_THAT(section_of(page, "points"), HasSubstr("failed: died: &lt;Aborted&gt;, twice"));
  EXPECT_THAT(section_of(page, "says"), HasSubstr("1 failed."));
  EXPECT_TRUE(figure_of(page, "starved").at("value").at(5).is_null()) << "no number is made up";
}

TEST(ReportPage, ASweepThatHasNotEndedIsShownAsFarAsItIs) {
  ReportFolder sweep(Grid);
  sweep.put(0, 16);
  sweep.put(1, 3);
  sweep.say("interrupted", 16);
  const std::string page = sweep.page();
  EXPECT_THAT(section_of(page, "says"),
              AllOf(HasSubstr("The sweep has not ended"), HasSubstr("4 points not measured yet.")));
  EXPECT_EQ(rows_of_points(page), 6u);
}

TEST(ReportPage, WhatIsNotThereIsLeftOutAndSaid) {
  ReportFolder sweep(Grid);
  sweep.put_all(16);
  const std::string page = sweep.page();
  EXPECT_THAT(
      section_of(page, "causes"),
      AllOf(HasSubstr("Not shown: the sweep does not measure them"), Not(HasSubstr("chart"))));
  EXPECT_THAT(section_of(page, "units"),
              HasSubstr("Not shown: the sweep does not measure silicon"));
  EXPECT_THAT(section_of(page, "pictures"), HasSubstr("Not shown: the sweep keeps none"));
  for (const char* chart : {"front", "parallel", "effects", "heat", "slack"})
    EXPECT_THAT(page, HasSubstr(fmt::format("id=\"{}-chart\"", chart)));
}

TEST(ReportPage, NoPointOneAndTwoHaveAPage) {
  ReportFolder none(named_points({"none"}));
  none.say("running", 0);
  EXPECT_THAT(none.page(),
              AllOf(HasSubstr("Nothing has been measured yet."), Not(HasSubstr("class=\"chart"))));
  ReportFolder one(named_points({"one"}));
  one.put_all(4);
  EXPECT_EQ(rows_of_points(one.page()), 1u);
  EXPECT_THAT(section_of(one.page(), "parallel"), HasSubstr("Not shown: there is no second point"));
  ReportFolder two(named_points({"two", "b"}));
  two.put_all(4);
  EXPECT_THAT(section_of(two.page(), "heat"), HasSubstr("Not shown: one knob varies"));
  EXPECT_THAT(section_of(two.page(), "sensitivity"), HasSubstr("effects-chart"));
}

TEST(ReportPage, AThousandPointsHaveARowEach) {
  ReportFolder sweep(
      "name = \"many\"\n[frames]\nsample = 4\nguard = 0\n[search]\nmethod = \"sobol\"\npoints = "
      "999\n"
      "[knobs]\nhurry_threshold = { from = 0, to = 639 }\nfifo_entries = { from = 4, to = 64 }\n"
      "[goals]\npicture_error = \"min\"\n");
  sweep.put_all(2);
  const std::string page = sweep.page();
  EXPECT_EQ(rows_of_points(page), 1000u);
  EXPECT_EQ(figure_of(page, "starved").at("value").size(), 1000u);
  EXPECT_THAT(section_of(page, "sensitivity"), HasSubstr("eta squared"));
}

TEST(ReportPage, TwoHundredPointsWithPicturesTakeThreeMegabytes) {
  ReportFolder sweep(
      "name = \"many\"\n[frames]\nsample = 4\nguard = 0\n"
      "[knobs]\nfifo_entries = { from = 4, to = 43 }\ninterval_stack_depth = [2, 4, 6, 8, 10]\n"
      "[goals]\npicture_error = \"min\"\n");
  ASSERT_EQ(sweep.points(), 200);
  sweep.put_all(4);
  sweep.keep_pictures(9000);
  const std::string page = sweep.page();
  EXPECT_THAT(page.size(), Le(3'000'000u));
  EXPECT_GT(page.size(), 2'900'000u) << "there is room for more";
  EXPECT_THAT(
      section_of(page, "pictures"),
      AllOf(HasSubstr(" as chip draws it"), HasSubstr("left out, for the page to stay small")));
  EXPECT_EQ(count_of("src=\"data:image/png;base64,iVBOR", page),
            data_of(page).at("pictures").at("point").size());
}

TEST(ReportPage, TheSameStoreMakesTheSamePage) {
  ReportFolder sweep(Grid);
  sweep.put_all(16);
  EXPECT_EQ(sweep.page(), sweep.page());
}

TEST(ReportPage, OfAFolderWithoutASweepSaysWhatMakesOne) {
  ScratchFolder folder;
  try {
    SweepReader reader(folder.path());
    ADD_FAILURE() << "there is none";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is not the folder of a sweep"));
  }
}

}  // namespace
}  // namespace racebeam
