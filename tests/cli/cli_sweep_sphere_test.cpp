// A sweep of scenes of spheres: the same commands, with the knobs and figures of that engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"
#include "tests/support/json.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

const std::string Scene = RACEBEAM_SOURCE_DIR "/scenes/sphere/inside.toml";

std::string head(const std::string& scenes = '"' + Scene + '"') {
  return "scenes = [" + scenes + "]\n";
}

class CliSweepSphereTest : public CliSweepTest {
 protected:
  void SetUp() override {
    write(head() +
          "[frames]\nsample = 2\nguard = 1\n"
          "[knobs]\nroot_bits_per_clock = [2, 6]\n"
          "[goals]\nclocks = \"min\"\nstalls = { most = \"1 clocks\" }\n"
          "[search]\nrace = false\n"
          "[measure]\npictures = [20]\n");
  }
  /// A cell of figures.csv.
  double value(const std::string& point, const std::string& figure) const {
    const std::string text = read_file(folder / "out/figures.csv");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (line.rfind(point + ",", 0) == 0 && line.find("," + figure + ",") != std::string::npos) {
        std::istringstream cells(line);
        std::string cell;
        for (int n = 0; n < 6; ++n) std::getline(cells, cell, ',');
        return std::stod(cell);
      }
    ADD_FAILURE() << "no " << figure << " of " << point << " in\n" << text;
    return 0;
  }
  Json rendered(const std::string& picture, const Words& more) const {
    Words words = {"render", Scene, "--at", picture, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words);
    EXPECT_LE(run.wait(), 1) << run.err();
    return Json::parse(run.out());
  }
  void expect_fault(const std::string& text, const std::string& fault) const {
    write(text, "bad.toml");
    EXPECT_THAT(expect({"sweep", "run", "bad.toml", "-o", "bad"}, 2), HasSubstr(fault)) << text;
  }
};

TEST_F(CliSweepSphereTest, FiguresAreThoseOfRender) {
  EXPECT_THAT(expect(run_words("out"), 0), HasSubstr("1 on the front, 0 undecided, 1 dominated"));
  const std::vector<std::string> frames =
      query(folder / "out/sweep.sqlite",
            "SELECT DISTINCT frame FROM frame WHERE kind = 'sample' ORDER BY 1");
  ASSERT_EQ(frames.size(), 2u);
  double clocks = 0, differing = 0;
  for (const std::string& frame : frames) {
    const Json report =
        rendered(frame, {"--golden", "compare", "-o", "g" + frame}).at("pictures").at(0);
    clocks += report.at("clocks").get<double>() / (320 * 240) / 2;
    differing += report.at("golden").at("differing_pixels").get<double>() / (320 * 240) * 50;
  }
  EXPECT_NEAR(value("chip", "clocks"), clocks, 1e-4);
  EXPECT_NEAR(value("chip", "picture_error"), differing, 1e-4);
  EXPECT_GT(value("p1", "clocks"), clocks);
  EXPECT_EQ(value("p1", "picture_error"), value("chip", "picture_error"));
}

TEST_F(CliSweepSphereTest, PicturesAreKeptAtTheirOwnSize) {
  expect_run("out");
  rendered("20", {"-o", "r"});
  const std::string picture = read_file(folder / "r/frame_0020.png");
  int same = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out/pictures"))
    same += read_file(entry.path()) == picture;
  EXPECT_EQ(same, 2) << "both points draw the same";
}

TEST_F(CliSweepSphereTest, ASweepGoesOnRepeatsAndIsExported) {
  expect_run("out");
  EXPECT_THAT(expect({"sweep", "check", "out"}, 0), HasSubstr("all as they were"));
  EXPECT_THAT(expect({"sweep", "status", "out"}, 0), HasSubstr("0 of 2 points failed"));
  expect({"sweep", "export", "out", "--csv", "p.csv", "--json", "p.json"}, 0);
  EXPECT_THAT(read_file(folder / "p.csv"), HasSubstr(",root_bits_per_clock,"));
  EXPECT_EQ(Json::parse(read_file(folder / "p.json")).at("points").size(), 2u);
  const std::string store = folder / "out/sweep.sqlite";
  const auto rows = [&] { return query(store, "SELECT count(*) FROM frame"); };
  const auto before = rows();
  expect_run("out", {"--fresh"});
  EXPECT_EQ(rows(), before);
}

TEST_F(CliSweepSphereTest, WhatItDoesNotHaveIsRefused) {
  expect_fault(head() + "[knobs]\ndr_bits = [9]\n", "bad.toml:3:1: knob 'dr_bits' is one of beam");
  expect_fault("[knobs]\ndivide_clocks = [5]\n",
               "bad.toml:2:1: knob 'divide_clocks' is one of sphere");
  expect_fault(head() + "[goals]\nstarved = \"min\"\n",
               "bad.toml:3:1: figure 'starved' is one of beam");
  expect_fault("[goals]\nstalls = \"min\"\n", "bad.toml:2:1: figure 'stalls' is one of sphere");
  expect_fault(head() + "[measure]\ncauses = true\n", "errors of sphere have no causes");
  expect_fault(head() + "[measure]\nreference = \"base\"\n",
               "pictures of sphere are not compared with base");
  expect_fault(head("\"demo\", \"" + Scene + "\""), "is for sphere, and 'demo' is for beam");
  expect_fault(head() + "[knobs]\ntable_entries = [2]\n",
               "table_entries=2 holds 1 spheres and the light");
}

}  // namespace
}  // namespace racebeam
