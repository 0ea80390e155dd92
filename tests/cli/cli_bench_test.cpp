// `racebeam bench store`: what it prints is what it counts.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>

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

}  // namespace
}  // namespace racebeam
