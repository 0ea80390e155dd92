// `racebeam compare`: what it prints is what was counted, and what it refuses.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class CliCompare : public testing::Test {
 protected:
  ScratchFolder folder;

  Json compared(Words words) {
    words.insert(words.begin(), "compare");
    words.emplace_back("--json");
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 0) << program.err();
    return program.json();
  }
  Json stats(Words words) {
    words.insert(words.begin(), "render");
    for (const char* word : {"--json", "--stats", "s.json", "--overwrite"})
      words.emplace_back(word);
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 0) << program.err();
    return program.json();
  }
  void expect_refused(Words words, const Words& parts) {
    words.insert(words.begin(), "compare");
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2) << testing::PrintToString(words);
    EXPECT_EQ(program.out(), "");
    for (const std::string& part : parts) EXPECT_THAT(program.err(), HasSubstr(part));
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  }
};

double number(const Json& json) { return json.get<double>(); }

TEST_F(CliCompare, CountersAreThoseOfStatsJson) {
  const Json bounce = compared({"sphere/bounce", "--engine", "sphere", "--pictures", "2"});
  const Json cell = bounce.at("groups")[0].at("engines")[0];
  const Json total = stats({"sphere/bounce", "--frames", "2", "--golden", "compare"}).at("total");
  const Json counters = total.at("counters"), numbers = cell.at("numbers"),
             figures = cell.at("figures");
  for (const char* name : {"clocks", "host_clocks", "roots", "divisions", "sphere_tests",
                           "store_writes", "store_reads", "state_centre"})
    EXPECT_EQ(number(numbers.at(name)), number(counters.at(name))) << name;
  const double pixels = number(numbers.at("pixels"));
  EXPECT_EQ(pixels, 2 * 320 * 240);
  EXPECT_DOUBLE_EQ(number(figures.at("clocks_per_pixel")), number(counters.at("clocks")) / pixels);
  EXPECT_DOUBLE_EQ(number(figures.at("roots_per_pixel")), number(counters.at("roots")) / pixels);
  EXPECT_DOUBLE_EQ(number(figures.at("quotients_per_pixel")),
                   number(counters.at("divisions")) / pixels);
  EXPECT_DOUBLE_EQ(number(figures.at("host_clocks")), number(counters.at("host_clocks")) / 2);
  EXPECT_DOUBLE_EQ(number(figures.at("pictures_per_second")),
                   25.2e6 * 2 / number(counters.at("clocks")));
  EXPECT_DOUBLE_EQ(number(figures.at("wrong_hits")),
                   100 * number(total.at("golden").at("wrong_first_hits")) / pixels);
  EXPECT_NEAR(number(figures.at("psnr")), number(total.at("golden").at("psnr")), 0.001);
}

TEST_F(CliCompare, LinesAreThoseOfStatsJson) {
  const Json all = compared({"demo", "--engine", "beam", "--engine", "sphere"});
  const Json beam = all.at("groups")[0].at("engines")[0];
  const Json total = stats({"demo"}).at("total");
  const Json figures = beam.at("figures"), busy = total.at("busy_clocks");
  EXPECT_DOUBLE_EQ(number(figures.at("clocks_per_pixel")), number(busy.at("sum")) / 307200);
  EXPECT_DOUBLE_EQ(number(figures.at("clocks_p99")), number(busy.at("p99")) / 640);
  EXPECT_DOUBLE_EQ(number(figures.at("clocks_worst")), number(busy.at("max")) / 640);
  EXPECT_DOUBLE_EQ(number(figures.at("products_per_pixel")),
                   2 * number(total.at("decisions")) / 307200);
  EXPECT_DOUBLE_EQ(number(figures.at("starved")),
                   100 * number(total.at("starved_pixels")) / 307200);
  EXPECT_EQ(number(figures.at("pictures_per_second")), 60);
  EXPECT_EQ(number(figures.at("units_to_race")), 1);
  EXPECT_EQ(all.at("groups")[0].at("engines")[1].at("why"), "demo is built into beam");
}

TEST_F(CliCompare, BlocksAreThoseOfStatsJson) {
  const Json all = compared({"block/quad", "--engine", "block", "--set", "block.cores=1"});
  const Json cell = all.at("groups")[0].at("engines")[0];
  const Json counters = stats({"block/quad", "--set", "cores=1"}).at("total").at("counters");
  const Json figures = cell.at("figures");
  EXPECT_DOUBLE_EQ(number(figures.at("clocks_per_pixel")), number(counters.at("clocks")) / 307200);
  EXPECT_DOUBLE_EQ(number(figures.at("roots_per_pixel")), number(counters.at("roots")) / 307200);
  EXPECT_EQ(number(cell.at("quantities").at("rays").at("value")), number(counters.at("groups")))
      << "four spheres, four lanes";
  EXPECT_EQ(number(figures.at("host_clocks")), 48);
}

/// Every figure has its formula, and every name in it a value or a formula.
TEST_F(CliCompare, WhatEachFigureIsMadeOfStandsBesideIt) {
  const Json all = compared({"common/rising-2"});
  EXPECT_EQ(all.at("schema"), "racebeam-compare");
  EXPECT_EQ(all.at("version"), 1);
  for (const Json& column : all.at("groups")[0].at("engines").elements()) {
    if (column.count("why")) continue;
    const Json numbers = column.at("numbers"), quantities = column.at("quantities");
    for (const Json& figure : all.at("figures").elements()) {
      const auto formula = figure.at("formula").get<std::string>();
      ASSERT_EQ(column.at("figures").count(figure.at("name").get<std::string>()), 1);
      const bool has = !column.at("figures").at(figure.at("name").get<std::string>()).is_null();
      std::string name;
      for (const char c : formula + " ") {
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
          name += c;
          continue;
        }
        const bool is_number = name.empty() || std::isdigit(static_cast<unsigned char>(name[0]));
        if (has && !is_number && c != '(') {
          EXPECT_EQ(numbers.count(name) || quantities.count(name), 1) << name;
        }
        name.clear();
      }
    }
  }
}

TEST_F(CliCompare, BallsAreTheSameForAllEnginesThatDrawSpheres) {
  const Json all =
      compared({"common/balls", "-o", "out", "--sheet", "s.png", "--markdown", "t.md"});
  const Json engines = all.at("groups")[0].at("engines");
  ASSERT_EQ(engines.size(), 4u);
  EXPECT_THAT(engines[0].at("why").get<std::string>(), HasSubstr("balls.toml"));
  for (std::size_t n = 1; n < 4; ++n) {
    EXPECT_EQ(number(engines[n].at("numbers").at("pixels")), 512 * 480);
    EXPECT_LT(number(engines[n].at("figures").at("wrong_hits_inner")), n < 3 ? 0.5 : 2);
  }
  for (std::size_t n = 1; n < 3; ++n) EXPECT_EQ(number(engines[n].at("numbers").at("spheres")), 8);
  EXPECT_EQ(read_json(folder / "out/compare.json").at("groups").size(), 1u);
  for (const char* file :
       {"out/common_balls_sphere.png", "out/common_balls_block.png",
        "out/common_balls_sphere_difference.png", "out/common_balls_voxel.png", "s.png"})
    EXPECT_THAT(read_file(folder / file), testing::StartsWith("\x89PNG")) << file;
  const std::string table = read_file(folder / "t.md");
  EXPECT_THAT(
      table,
      HasSubstr("| common/balls | beam | sphere balls | block balls | voxel balls |\n|---|--:|"));
  EXPECT_THAT(table, HasSubstr("- beam does not draw it: balls.toml:"));
}

TEST_F(CliCompare, RoomsAreTheSameAsVoxels) {
  const Json engines = compared({"common/hall"}).at("groups")[0].at("engines");
  ASSERT_EQ(engines.size(), 4u);
  for (const std::size_t n : {0u, 3u})
    EXPECT_LT(number(engines[n].at("figures").at("wrong_hits_inner")), 2);
  for (const std::size_t n : {1u, 2u}) EXPECT_TRUE(engines[n].contains("why"));
}

TEST_F(CliCompare, HillsCostWhatThePageSays) {
  write("hills",
        "voxel/hills voxel clocks_per_pixel 165 1%\n"
        "voxel/hills voxel working_memory 2752 0\n"
        "voxel/hills voxel picture_store 7372800 0\n"
        "voxel/hills voxel register_bits 6851 0\n"
        "voxel/hills voxel quotients_per_pixel 3 0\n"
        "voxel/hills voxel wrong_hits_inner 1.985 1%\n");
  Program program(folder.path(),
                  {"compare", "voxel/hills", "--engine", "voxel", "--expect", "hills"});
  EXPECT_EQ(program.wait(), 0) << program.err();
}

TEST_F(CliCompare, ExpectedFiguresDecideTheExitCode) {
  write("good",
        "# measured\ncommon/rising-1 sphere working_memory 6126 0\n"
        "common/rising-1 sphere starved - 0\n");
  write("bad", "common/rising-1 sphere multipliers 8 0.5 # one less\n");
  const Words words = {"compare", "common/rising-1", "--engine", "sphere", "--expect"};
  Words good = words, bad = words;
  good.emplace_back("good");
  bad.emplace_back("bad");
  Program fine(folder.path(), good);
  EXPECT_EQ(fine.wait(), 0) << fine.err();
  EXPECT_THAT(fine.out(), HasSubstr("clocks a pixel"));
  Program differs(folder.path(), bad);
  EXPECT_EQ(differs.wait(), 1);
  EXPECT_THAT(differs.err(),
              HasSubstr("bad:1: multipliers of sphere in common/rising-1 is 7, not 8 within 0.5"));
}

TEST_F(CliCompare, RefusesWhatCannotBeCompared) {
  expect_refused({"--engine", "spheer"}, {"spheer", "sphere"});
  expect_refused({"common/ball"}, {"common/ball", "unknown scene"});
  expect_refused({"--set", "cores=1"}, {"ENGINE.KNOB=VALUE", "block.cores=1"});
  expect_refused({"--set", "sphere.cores=1"}, {"cores", "block"});
  expect_refused({"--engine", "beam", "--set", "block.cores=1"}, {"block is not compared"});
  expect_refused({"--set", "block.cores=65"}, {"cores", "1..64"});
  expect_refused({"house", "--engine", "sphere"}, {"no engine draws house", "house.toml:"});
  expect_refused({"--pictures", "0"}, {"--pictures", "1..1000"});
  expect_refused({"--expect", "none"}, {"cannot read none"});
  write("e", "\n\na b c\n");
  expect_refused({"--expect", "e"}, {"e:3: 3 words", "GROUP ENGINE FIGURE VALUE TOLERANCE"});
  write("e", "balls sphere clocks 1 1%\n");
  expect_refused({"--expect", "e"}, {"e:1: ", "clocks"});
  write("e", "balls sphere multipliers many 1%\n");
  expect_refused({"--expect", "e"}, {"e:1: 'many' is no number"});
}

TEST_F(CliCompare, RenderShowsHitMaps) {
  for (const Words& rest : {Words{}, Words{"--golden", "geometry"}}) {
    Words words = {"render", "sphere/inside", "--at", "20", "--show", "hits", "-o", "hits.png"};
    words.insert(words.end(), rest.begin(), rest.end());
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 0) << program.err();
    EXPECT_THAT(read_file(folder / "hits.png"), testing::StartsWith("\x89PNG"));
  }
  for (const auto& [rest, part] :
       {std::pair{Words{"--show", "hit"}, "hits"},
        {Words{"--show", "hits", "--golden", "compare"}, "racebeam compare"},
        {Words{"--show", "hits", "--golden", "trace4"}, "--golden geometry"},
        {Words{"--show", "hits", "--against", "demo"}, "--against"}}) {
    Words words = {"render", "demo"};
    words.insert(words.end(), rest.begin(), rest.end());
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2);
    EXPECT_THAT(program.err(), HasSubstr(part));
  }
}

}  // namespace
}  // namespace racebeam
