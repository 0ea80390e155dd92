// racebeam sweep run with method = "nsga2": what was stopped comes back to the same points, and its
// front is no worse than that of as many points spread evenly.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <random>

#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string Knobs =
    "[frames]\nsample = 8\nguard = 0\n[measure]\nsilicon = \"off\"\n"
    "[goals]\npicture_error = \"min\"\n\"busy.max\" = \"min\"\ndecisions = \"min\"\n"
    "[knobs]\ninterval_stack_depth = [1, 2, 3, 4, 6, 8]\ndr_bits = { from = 8, to = 13 }\n"
    "hurry_threshold = [-1, 16, 32, 64, 128]\nfifo_entries = [4, 6, 8, 10, 12, 16]\n"
    "partial_products_cut = { from = 0, to = 8 }\n";

std::string search(int population, int generations) {
  return "[search]\nmethod = \"nsga2\"\npopulation = " + std::to_string(population) +
         "\ngenerations = " + std::to_string(generations) + "\n";
}

class CliSweepSearch : public CliSweepTest {
 protected:
  int frames(const std::string& out) const {
    return fs::exists(store(out)) &&
                   !query(store(out), "SELECT 1 FROM sqlite_schema WHERE name = 'frame'").empty()
               ? std::stoi(query(store(out), "SELECT count(*) FROM frame")[0])
               : 0;
  }
  /// "p7 knob=value ...", of all points, sorted.
  std::vector<std::string> points(const std::string& out) const {
    std::vector<std::string> all =
        query(store(out), "SELECT name || ' ' || setting FROM point WHERE name <> ''");
    std::sort(all.begin(), all.end());
    return all;
  }
  /// The means of a figure, by point.
  std::map<std::string, double> figure(const std::string& out, const std::string& name) const {
    std::map<std::string, double> means;
    for (const auto& row : read_csv(read_file(folder / (out + "/figures.csv"))))
      if (row.at("figure") == name) means[row.at("point")] = std::stod(row.at("value"));
    return means;
  }
  /// What points dominate of picture_error and decisions up to 20 % and 1000 a line.
  double hypervolume(const std::string& out) const {
    const auto decisions = figure(out, "decisions");
    std::vector<std::pair<double, double>> goals;
    for (const auto& [point, error] : figure(out, "picture_error"))
      goals.emplace_back(error, decisions.at(point));
    std::sort(goals.begin(), goals.end());
    double area = 0, lowest = 1000;
    for (const auto& [error, work] : goals)
      if (error < 20 && work < lowest) {
        area += (20 - error) * (lowest - work);
        lowest = work;
      }
    return area;
  }
};

// Guard frames have longer lines than the sample: the search must not be told of them.
using LongCliSweepSearch = CliSweepSearch;

TEST_F(CliSweepSearch, StoppedAnywhereItGoesOnWithTheSamePointsAndFrames) {
  expect({"scene", "new", "room.toml"}, 0);
  std::string text = "scenes = [\"room.toml\"]\n" + Knobs + search(8, 4);
  text.replace(text.find("guard = 0"), 9, "guard = 4");
  write(text);
  const std::string said = expect(run_words("whole"), 0);
  EXPECT_THAT(said, HasSubstr("nsga2 has asked for 40 points"));
  EXPECT_THAT(said, HasSubstr("9 points of 5 knobs, then 4 generations of 8 by nsga2"));
  const int whole = frames("whole");
  EXPECT_GT(whole, 9 * 8);
  std::mt19937 random(16);
  for (int round = 0; round < 2; ++round) {
    const int stop = 1 + static_cast<int>(random() % static_cast<unsigned>(whole));
    const std::string out = "out" + std::to_string(round);
    Program run(folder.path(), run_words(out));
    while (run.runs() && frames(out) < stop) usleep(1000);
    run.signal(round % 2 ? SIGTERM : SIGKILL);
    run.wait();
    expect_run(out);
    EXPECT_EQ(points(out), points("whole")) << "stopped after " << stop << " frames";
    EXPECT_EQ(query(store(out), "SELECT count(*) || ' ' || sum(digest % 1000003) FROM frame"),
              query(store("whole"), "SELECT count(*) || ' ' || sum(digest % 1000003) FROM frame"));
    EXPECT_EQ(read_file(folder / (out + "/figures.csv")), read_file(folder / "whole/figures.csv"));
  }
}

TEST_F(LongCliSweepSearch, ItsFrontIsNotWorseThanSobolsOfAsManyPoints) {
  write(Knobs + search(16, 5));
  expect_run("searched");
  const auto count = figure("searched", "decisions").size() - 1;
  EXPECT_GT(count, 40u);
  write(Knobs + "[search]\nmethod = \"sobol\"\nrace = false\npoints = " + std::to_string(count) +
        "\n");
  expect_run("spread", {"--reuse", "searched"});
  EXPECT_EQ(figure("spread", "decisions").size() - 1, count);
  EXPECT_GE(hypervolume("searched"), hypervolume("spread"));
}

TEST_F(CliSweepSearch, AllItsPointsHaveTheSameFrames) {
  write(Knobs + search(8, 2));
  expect_run("out");
  EXPECT_EQ(query(store("out"),
                  "SELECT DISTINCT group_concat(frame) FROM (SELECT point, frame FROM frame "
                  "WHERE kind = 'sample' ORDER BY point, frame) GROUP BY point")
                .size(),
            1u);
}

TEST_F(CliSweepSearch, ADryRunCountsAllThatItMayAskForAndWritesNothing) {
  write(Knobs + search(8, 100));
  const std::string said = expect(run_words("out", {"--dry-run"}), 0);
  EXPECT_THAT(said, HasSubstr("then 100 generations of 8 by nsga2"));
  write(Knobs + search(8, 1));
  const auto megabytes = [](const std::string& text) {
    const auto at = text.find(" MB;");
    return std::stoi(text.substr(text.rfind(' ', at - 1)));
  };
  EXPECT_GT(megabytes(said), 0);
  EXPECT_GE(megabytes(said), megabytes(expect(run_words("out", {"--dry-run"}), 0)));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace
}  // namespace racebeam
