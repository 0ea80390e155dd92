// `racebeam bench`: `store` prints what it counts, `engines` how they compare, `sweep` has rows
// with goals.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

std::string output(const std::vector<std::string>& words) {
  const ScratchFolder folder;
  Program program(folder.path(), words);
  EXPECT_EQ(program.wait(), 0) << program.err();
  return program.out();
}

TEST(CliBench, StoreIsATableOfDepths) {
  const std::string text = output({"bench", "store"});
  const auto line = [](int depth, double a, double b, double c, double d) {
    return fmt::format("\n{:>18} {:>16.3f} {:>16.3f} {:>16.3f} {:>16.3f}\n", depth, a, b, c, d);
  };
  EXPECT_THAT(text, testing::StartsWith("store: clocks waited, % of those needed; write_policy "
                                        "sync, when_full stall, 320 x 240 pixels\n"));
  EXPECT_THAT(text, testing::HasSubstr(line(1, 557.901, 586.229, 469.133, 461.276)));
  EXPECT_THAT(text, testing::HasSubstr(line(31, 27.027, 16.858, 0, 0)));
  EXPECT_THAT(text, testing::HasSubstr("words lost, %; write_policy sync, when_full drop"));
}

TEST(CliBench, StoreHasEachRowAsJson) {
  const auto report = nlohmann::json::parse(output({"bench", "store", "--json"}));
  EXPECT_EQ(report.at("schema"), "racebeam-bench");
  EXPECT_TRUE(report.at("medians").empty()) << "nothing else was asked for";
  const auto& rows = report.at("store");
  EXPECT_EQ(rows.size(), 3u * 12 * 4);
  for (const auto& row : rows) {
    const double clocks = row.at("clocks"), waited = row.at("waited"), words = row.at("words"),
                 lost = row.at("lost");
    EXPECT_EQ(words, 320 * 240);
    EXPECT_EQ(clocks, words * row.at("pixel_clocks").get<int>());
    EXPECT_DOUBLE_EQ(row.at("waited_percent").get<double>(), 100 * waited / clocks);
    EXPECT_DOUBLE_EQ(row.at("lost_percent").get<double>(), 100 * lost / words);
    if (row.at("write_buffer_depth") == 30 && row.at("pixel_clocks") == 23 &&
        row.at("write_policy") == "sync" && row.at("when_full") == "stall") {
      EXPECT_EQ(fmt::format("{:.3f}", row.at("waited_percent").get<double>()), "0.811");
    }
  }
}

// The design of the engine measured this on its model.
TEST(CliBench, EachSphereOfARingCostsAboutAsMuch) {
  const std::vector<std::pair<int, double>> design = {{1, 23.17},  {2, 27.29}, {4, 35.62},
                                                      {6, 43.99},  {8, 52.49}, {10, 61.07},
                                                      {12, 69.54}, {15, 82.49}};
  const auto rows = nlohmann::json::parse(output({"bench", "spheres", "--json"})).at("spheres");
  ASSERT_EQ(rows.size(), design.size());
  for (std::size_t n = 0; n < design.size(); ++n) {
    const double clocks = rows[n].at("clocks_per_pixel");
    EXPECT_EQ(rows[n].at("spheres"), design[n].first);
    EXPECT_NEAR(clocks, design[n].second, 0.005 * design[n].second);
    EXPECT_NEAR(clocks, 19 + 4.2 * design[n].first, 0.6) << "a straight line";
  }
}

TEST(CliBench, SpheresAreATableThatThePageHas) {
  EXPECT_THAT(read_file(RACEBEAM_SOURCE_DIR "/docs/sphere.md"),
              testing::HasSubstr("\n\n" + output({"bench", "spheres"}) + "\n"));
}

// The design counted no bus, which takes one word a clock: 98 % of 35 cores.
TEST(CliBench, CoresAreATableThatThePageHas) {
  EXPECT_THAT(read_file(RACEBEAM_SOURCE_DIR "/docs/block.md"),
              testing::HasSubstr("\n\n" + output({"bench", "cores"}) + "\n"));
  const auto rows = nlohmann::json::parse(output({"bench", "cores", "--json"})).at("cores");
  for (const auto& row : rows) {
    if (row.at("cores") > 8) continue;
    EXPECT_GT(row.at("busy"), 0.99) << row.at("cores");
  }
}

TEST(CliBench, EnginesAreComparedAtEachLevelWithTheFirst) {
  const auto report =
      nlohmann::json::parse(output({"bench", "engines", "--repeat", "1", "--json"}));
  std::vector<std::string> names;
  for (const auto& row : report.at("medians")) {
    names.push_back(row.at("name"));
    const double rate = row.at("clocks_per_second");
    EXPECT_GT(rate, 0);
    const std::string first = "beam" + names.back().substr(names.back().find(':'));
    const auto& medians = report.at("medians");
    const auto beside = std::find_if(medians.begin(), medians.end(),
                                     [&](const auto& other) { return other.at("name") == first; });
    EXPECT_DOUBLE_EQ(row.at("ratio").get<double>(),
                     rate / beside->at("clocks_per_second").get<double>());
  }
  EXPECT_THAT(names,
              testing::ElementsAre("beam: tlm", "beam: signal", "sphere: tlm", "sphere: signal",
                                   "block: tlm", "block: signal", "voxel: tlm", "voxel: signal"));
}

// A part that takes seconds. How fast it is depends on the machine: a goal that is missed is no
// failure.
TEST(CliBench, SweepHasRowsWithGoalsAsJson) {
  const auto report = nlohmann::json::parse(output({"bench", "sweep-causes", "--json"}));
  EXPECT_EQ(report.at("schema"), "racebeam-bench");
  std::vector<std::string> names;
  for (const auto& row : report.at("medians")) {
    names.push_back(row.at("name"));
    const double value = row.at("value"), goal = row.at("at_most");
    EXPECT_GT(value, 0);
    EXPECT_EQ(row.at("met").get<bool>(), value <= goal) << row;
    EXPECT_EQ(row.at("unit"), "ms");
    EXPECT_EQ(row.size(), 5u) << row;
  }
  EXPECT_THAT(names, testing::ElementsAre("sweep: errors by cause, a frame",
                                          "sweep: errors by cause, links known",
                                          "sweep: reference picture, second use"));
}

TEST(CliBench, PartsOfSweepAreNamedLikeIt) {
  const ScratchFolder folder;
  Program program(folder.path(), {"bench", "sweep-cause"});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), testing::HasSubstr("sweep-causes"));
}

}  // namespace
}  // namespace racebeam
