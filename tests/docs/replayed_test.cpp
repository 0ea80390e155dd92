// tests/reference/replayed.json: every unit of every engine has met its demo, in RTL and in gates.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "sc/base/constants.h"
#include "tb/base/project_folder.h"
#include "tb/program/replay_record.h"
#include "tb/scene/engines.h"

namespace racebeam {
namespace {

constexpr int DemoPictures = 120;  // of the engines that draw into a store
constexpr int MostAsked = 200;     // frames or pictures

std::vector<ReplayRow> kept() {
  return read_replay_record(project_folder() + "/tests/reference/replayed.json");
}

TEST(Replayed, NothingThatIsKeptDiffers) {
  for (const ReplayRow& row : kept()) {
    EXPECT_EQ(row.differences, 0u) << row.command;
    EXPECT_EQ(row.fault, "") << row.command;
  }
}

TEST(Replayed, EachUnitOfEachEngineHasMetItsDemoInRtlAndInGates) {
  std::map<std::tuple<std::string, std::string, std::string>, int> frames;
  for (const ReplayRow& row : kept()) {
    int& most = frames[{row.engine, row.unit, row.level}];
    most = std::max(most, row.frames);
  }
  for (const engine* built : engines())
    for (const bool scene_file : {false, true})
      for (const std::string& unit : built->unit_names(scene_file))
        for (const char* level : {"rtl", "gates"})
          EXPECT_GE((frames[{built->name, unit, level}]),
                    built->races_beam ? MostAsked : DemoPictures)
              << built->name << " " << unit << " " << level;
}

TEST(Replayed, TheWholeChipInRtlHasMetTheWholeDemo) {
  const std::vector<ReplayRow> rows = kept();
  const auto top = std::find_if(rows.begin(), rows.end(),
                                [](const ReplayRow& row) { return row.unit == "racebeam_top"; });
  ASSERT_NE(top, rows.end());
  EXPECT_EQ(top->level, "rtl");
  EXPECT_EQ(top->frames, DemoFrames);
}

}  // namespace
}  // namespace racebeam
