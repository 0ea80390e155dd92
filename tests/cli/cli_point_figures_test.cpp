// figures.csv of a sweep: all figures of its points, each with its interval.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CliPointFiguresTest : public CliSweepTest {
 protected:
  /// A cell of a row of figures.csv as a number; not a number if there is none.
  double number(const std::string& point, const std::string& figure,
                const std::string& cell = "value") const {
    for (auto& row : read_csv(read_file(folder / "out/figures.csv")))
      if (row["point"] == point && row["figure"] == figure && !row[cell].empty())
        return std::stod(row[cell]);
    return std::nan("");
  }
  /// Of all figures whose names begin so.
  double sum(const std::string& point, const std::string& prefix,
             const std::string& but = "") const {
    double sum = 0;
    for (auto& row : read_csv(read_file(folder / "out/figures.csv")))
      if (row["point"] == point && row["figure"].rfind(prefix, 0) == 0 && row["figure"] != but)
        sum += std::stod(row["value"]);
    return sum;
  }
};

const std::string Small = "[frames]\nsample = 4\nguard = 0\n[knobs]\nhurry_threshold = [32, 100]\n";

TEST_F(CliPointFiguresTest, CausesAddUpToTheErrorAndPartsToTheLine) {
  write(Small + "[measure]\ncauses = true\n");
  expect_run("out");
  for (const char* point : {"chip", "p2"}) {
    const double error = number(point, "picture_error");
    EXPECT_GT(error, 0);
    EXPECT_NEAR(sum(point, "error.", "error.visible"), error, 1e-5 * error);
    EXPECT_NEAR(sum(point, "line."), 1'600, 0.01);
    EXPECT_LE(number(point, "slack.p1"), number(point, "slack.p50"));
    EXPECT_GT(number(point, "slack.p50", "half_width"), 0);
    EXPECT_TRUE(std::isnan(number(point, "busy.max", "half_width"))) << "a worst one has none";
  }
  EXPECT_NE(number("p2", "error.give_up", "change"), 0);
}

TEST_F(CliPointFiguresTest, CausesMayBeAskedForLater) {
  write(Small);
  expect_run("out");
  EXPECT_TRUE(std::isnan(number("p2", "error.starved")));
  const std::string frames = frames_of("out");
  write(Small + "[measure]\ncauses = true\n");
  expect_run("out");
  EXPECT_NEAR(sum("p2", "error.", "error.visible"), number("p2", "picture_error"), 1e-4);
  EXPECT_EQ(frames_of("out"), frames) << "what was there stays";
}

// A point that only looks different draws what the base would draw with that look.
TEST_F(CliPointFiguresTest, TheBasesPictureHasTheLookOfThePoint) {
  write(
      "[frames]\nsample = 4\nguard = 0\n"
      "[[point]]\nname = \"plain\"\nknobs = { dithering = \"off\" }\n"
      "[[point]]\nname = \"worse\"\nknobs = { dithering = \"off\", dr_bits = 8 }\n"
      "[measure]\nreference = \"base\"\n");
  expect_run("out");
  EXPECT_EQ(number("chip", "picture_error"), 0);
  EXPECT_EQ(number("plain", "picture_error"), 0);
  EXPECT_GT(number("worse", "picture_error"), 0);
}

TEST_F(CliPointFiguresTest, FiguresAreListedAndStandInANewSweep) {
  Program list(folder.path(), {"sweep", "figures"});
  EXPECT_EQ(list.wait(), 0);
  EXPECT_THAT(list.out(), StartsWith("of scenes for beam:\npicture_error"));
  EXPECT_THAT(list.out(), HasSubstr("\nerror.give_up"));
  EXPECT_THAT(list.out(), HasSubstr("\n\nof scenes for sphere:\npicture_error"));
  Program fresh(folder.path(), {"sweep", "new", "my.toml"});
  EXPECT_EQ(fresh.wait(), 0);
  std::istringstream lines(list.out());
  const std::string starter = read_file(folder / "my.toml");
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) {
      EXPECT_THAT(starter, HasSubstr("\n#   " + line + "\n"));
    }
}

}  // namespace
}  // namespace racebeam
