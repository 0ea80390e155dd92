// The commands that list what there is: knobs and units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "sc/beam/knobs.h"
#include "sc/beam/units.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

class CliTables : public testing::Test {
 protected:
  ScratchFolder folder;
};

TEST_F(CliTables, KnobsListsTheWholeTable) {
  Program table(folder.path(), {"knobs"});
  EXPECT_EQ(table.wait(), 0);
  Program json(folder.path(), {"knobs", "--json"});
  EXPECT_EQ(json.wait(), 0);
  const auto all = json.json();
  auto rows = all.at("knobs");
  const std::size_t settable = rows.size();
  for (const Json& row : all.at("scene_knobs").elements()) rows.push_back(row);
  ASSERT_EQ(rows.size(), knob_table().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const knob_info& row = knob_table()[i];
    for (const std::string& text : {std::string(row.name), row.range(), std::string(row.meaning)})
      EXPECT_THAT(table.out(), HasSubstr(text));
    EXPECT_EQ(rows[i].at("name"), row.name);
    EXPECT_EQ(row.of_scene, i >= settable) << row.name;
    EXPECT_EQ(rows[i].count("values"), row.names.empty() ? 0 : 1);
  }
  EXPECT_EQ(rows[0].at("default"), 4);
  EXPECT_EQ(rows[0].at("min"), 1);
  EXPECT_EQ(rows[0].at("max"), 64);
}

TEST_F(CliTables, UnitsListsTheWholeTable) {
  Program table(folder.path(), {"units"});
  EXPECT_EQ(table.wait(), 0);
  Program json(folder.path(), {"units", "--json"});
  EXPECT_EQ(json.wait(), 0);
  const auto rows = json.json().at("units");
  ASSERT_EQ(rows.size(), unit_table().size());
  std::map<std::string, int> shows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string name = unit_table()[i].name, rtl = rows[i].at("rtl").get<std::string>();
    EXPECT_EQ(rows[i].at("name"), name);
    EXPECT_EQ(rows[i].at("slot"), unit_table()[i].slot);
    EXPECT_EQ(rows[i].at("instance"), instance_of(name));
    EXPECT_THAT(read_file(rtl), HasSubstr("module " + name));
    EXPECT_THAT(table.out(),
                testing::ContainsRegex("\n" + name + " +" + instance_of(name) + " +" +
                                       rows[i].at("shows").get<std::string>() + " +" + rtl + "\n"));
    ++shows[rows[i].at("shows").get<std::string>()];
  }
  EXPECT_EQ(shows, (std::map<std::string, int>{{"all", 10}, {"demo", 2}, {"scenes", 2}}));
}

}  // namespace
}  // namespace racebeam
