// A unit's RTL through yosys, and the netlist through `racebeam verify`, beside the model.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "tb/scene/program_tables.h"
#include "tb/scene/scene_compiler.h"
#include "tb/scene/scene_reader.h"
#include "tests/cli/program.h"

namespace racebeam {

class NetlistTest : public testing::TestWithParam<const char*> {
 protected:
  using Words = std::vector<std::string>;

  /// netlist.v of UNIT or UNIT=FILE.sv.
  void make(const std::string& unit, const Words& options = {}, const Words& parameters = {}) {
    std::string command = "cd '" + folder.path() + "' && '" RACEBEAM_SOURCE_DIR "/scripts/netlist'";
    for (const std::string& word : options) command += " " + word;
    command += " " + unit + " netlist.v";
    for (const std::string& word : parameters) command += " " + word;
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
  Words verify(const std::string& unit, const Words& more = {}) const {
    Words words = {"verify", unit + "=netlist.v", "--frames", "1", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// The netlist is the model on random traffic and in a frame of the chip.
  void expect_equal(const std::string& unit, const Words& options) {
    const bool of_scene_file = unit == "timeline" || unit == "scene_rom";
    make(unit, options, of_scene_file ? tables(unit) : Words());
    if (HasFatalFailure()) return;
    Program run(folder.path(), verify(unit, of_scene_file ? Words{"--scene", Scene} : Words()));
    ASSERT_EQ(run.wait(), 0) << run.err();
    EXPECT_THAT(run.err(), testing::Not(testing::HasSubstr("warning")));
    const auto rows = run.json()["units"];
    std::set<std::string> traffic;  // besides walks, which are as long as they are
    for (const Json& row : rows.elements()) {
      EXPECT_EQ(row["differences"], 0);
      if (row["traffic"] == "walk") continue;
      EXPECT_GE(row["clocks"], 100000);
      traffic.insert(row["traffic"].get<std::string>());
    }
    EXPECT_EQ(traffic, unit == "racebeam_top" ? std::set<std::string>{"chip"}
                                              : std::set<std::string>({"chip", "random"}));
  }

  ScratchFolder folder;

 private:
  static inline const std::string Scene = RACEBEAM_SOURCE_DIR "/scenes/museum.toml";

  /// Parameters with the tables of a scene file.
  Words tables(const std::string& unit) {
    const scene_program program = compile_scene(read_scene_file(Scene).scene);
    std::ofstream(folder / "table.hex")
        << (unit == "timeline" ? shot_table(program) : room_table(program));
    if (unit == "timeline")
      return {"Shots=" + std::to_string(program.shots.size()), "ShotFile=table.hex"};
    return {"Rooms=" + std::to_string(program.rooms.size()), "RoomFile=table.hex"};
  }
};

inline std::string unit_of(const testing::TestParamInfo<const char*>& info) { return info.param; }

}  // namespace racebeam
