// The program with the wires of the sphere tracer: verify, trace, units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tb/base/project_folder.h"
#include "tests/cli/cli_trace_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

const std::string Small = RACEBEAM_SOURCE_DIR "/tests/museum/sphere.toml";  // 320 x 240
constexpr std::uint64_t SpherePeriod = clock_period_ps(1);

class CliSphereWiresTest : public CliTraceBench {
 protected:
  void expect_refused(std::vector<std::string> words, const std::string& said_of_it) {
    Program run(folder.path(), std::move(words));
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.err(), HasSubstr(said_of_it));
  }
  /// The RTL of the tracer with one place changed, in mine.sv.
  void change_tracer(const std::string& from, const std::string& to) {
    std::string text = read_file(rtl_file("sphere_tracer"));
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(folder / "mine.sv") << text.replace(at, from.size(), to);
  }
};

TEST_F(CliSphereWiresTest, VerifyGoesThroughAPicture) {
  std::ofstream(folder / "one.toml") << "name = \"one\"\nengine = \"sphere\"\nframes = 1\n"
                                        "[modes]\nsize = \"320x240\"\n"
                                        "[[sphere]]\ncentre = [0, 0, 15]\nradius = 3\n";
  Program run(folder.path(), {"verify", "root_unit", "--scene", "one.toml", "--frames", "1",
                              "--random", "20000", "--json"});
  EXPECT_EQ(run.wait(), 0) << run.err();
  const auto json = Json::parse(run.out());
  ASSERT_EQ(json["units"].size(), 2u);
  for (const auto& unit : json["units"].elements()) EXPECT_EQ(unit["differences"], 0);
  EXPECT_EQ(json["units"][0]["clocks"], 20000);
  EXPECT_GT(json["units"][1]["clocks"], 320 * 240 * 20) << "a ray takes at least 20 clocks";
}

TEST_F(CliSphereWiresTest, VerifyTellsThePlaceInThePicture) {
  change_tracer("{a, b} = {normal, lray}", "{a, b} = {normal, dir}");
  Program run(folder.path(), {"verify", "sphere_tracer=mine.sv", "--scene", Small, "--frames", "1",
                              "--random", "0"});
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.err(), HasSubstr("sphere_tracer: port b_"));
  EXPECT_THAT(run.err(), HasSubstr(" differs in picture 0, clock "));
  EXPECT_THAT(run.err(), HasSubstr(" --from 0:0 --use sphere_tracer=lockstep:mine.sv"));
}

TEST_F(CliSphereWiresTest, UnitsOfTheBuiltInSceneAreVerifiedByTheEngineAlone) {
  Program run(folder.path(), {"verify", "all", "--engine", "sphere", "--frames", "0", "--random",
                              "500", "--json"});
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_EQ(Json::parse(run.out())["units"].size(), 14u + 4)
      << "the walks of tracer, shader, host and beam";
}

/// Small pictures in which all that the board has is moved now and then.
constexpr const char* TwentyPictures = R"(name = "twenty"
engine = "sphere"
frames = 20
[modes]
size = "320x240"
planes = false
[[sphere]]
centre = [-4, 0, 8]
radius = 4
colour = "#ff8421"
reflect = 0.5
velocity = [0.5, 0.25, 0]
[[sphere]]
centre = [4, 1, 8]
radius = 3
reflect = 0.25
velocity = [-0.5, 0, 0.25]
[[plane]]
normal = [0, -1, 0]
distance = 8
colour = "#e8e8e8"
checker = 1
limits = [20, 20, 20]
[[input]]
picture = 4
pictures = 8
hold = ["SW3", "SW17", "SW8", "SW12", "SW13"]
[[input]]
picture = 8
hold = ["SW0", "KEY1"]
[[input]]
picture = 14
hold = ["KEY2", "KEY3"]
[[input]]
picture = 15
pictures = 3
hold = ["SW2", "SW6", "SW15", "KEY0"]
)";

using LongCliSphereWiresTest = CliSphereWiresTest;
TEST_F(LongCliSphereWiresTest, VerifyFindsNothingInTwentyPictures) {
  std::ofstream(folder / "twenty.toml") << TwentyPictures;
  Program run(folder.path(),
              {"verify", "all", "--scene", "twenty.toml", "--frames", "20", "--json"});
  EXPECT_EQ(run.wait(), 0) << run.err();
  std::size_t chip = 0;
  const auto json = Json::parse(run.out());
  for (const auto& unit : json["units"].elements()) {
    EXPECT_EQ(unit["differences"], 0) << unit["unit"].dump();
    if (unit["traffic"] != "walk") {
      EXPECT_GE(unit["clocks"], 100000);
    }
    chip += unit["traffic"] == "chip";
  }
  EXPECT_EQ(chip, 14u);
}

TEST_F(CliSphereWiresTest, WindowOfPixelsBeginsAndEndsWithThem) {
  const Wave wave = trace({"--from", "0:@150,100", "--pixels", "2"}, "t.vcd", Small);
  const std::uint64_t last = wave.end - SpherePeriod;
  EXPECT_EQ(wave["chip.u_sphere_tracer.state_q_name"].at(wave.begin), "RAY");
  EXPECT_EQ(wave["chip.x"].number(wave.begin), 150u);
  EXPECT_EQ(wave["chip.tracer_y"].number(wave.begin), 100u);
  EXPECT_EQ(wave["chip.u_sphere_tracer.state_q_name"].at(last), "NEXT");
  EXPECT_EQ(wave["chip.x"].number(last), 151u);
  EXPECT_THAT(read_file(folder / "t.gtkw"), HasSubstr("t.vcd"));
}

TEST_F(CliSphereWiresTest, RtlHasTheSignalsOfTheModelWithTheSameChanges) {
  const std::vector<std::string> window = {"--from", "0:@150,100", "--pixels", "1"};
  const Wave model = trace(window, "model.vcd", Small);
  std::vector<std::string> with_rtl = window;
  with_rtl.insert(with_rtl.end(), {"--use", "sphere_tracer=rtl", "--use", "root_unit=rtl", "--use",
                                   "divider_unit=rtl"});
  const Wave rtl = trace(with_rtl, "rtl.vcd", Small);
  EXPECT_GT(rtl.signals.size(), model.signals.size());
  for (const auto& [path, signal] : model.signals)
    EXPECT_TRUE(rtl[path] == signal) << path << " changes otherwise";
}

TEST_F(CliSphereWiresTest, ConditionOnANamedStateIsFound) {
  const Wave wave = trace({"--from", "0:1000", "--when", "u_sphere_tracer.state_q == CHORD",
                           "--pre", "3", "--post", "0"},
                          "t.vcd", Small);
  EXPECT_THAT(said, HasSubstr("--when holds in picture 0, clock "));
  const std::uint64_t last = wave.end - SpherePeriod;
  const auto& state = wave["chip.u_sphere_tracer.state_q_name"];
  EXPECT_EQ(state.at(last), "CHORD");
  EXPECT_EQ(state.at(last - SpherePeriod), "FRONT");
  EXPECT_EQ(state.at(last - 2 * SpherePeriod), "ALONG");
  EXPECT_EQ(state.at(last - 3 * SpherePeriod), "CENTRE");
}

TEST_F(CliSphereWiresTest, PlacesThatAreNoneAreRefused) {
  const auto of_small = [&](const std::string& from, const std::string& said_of_it) {
    expect_refused({"trace", Small, "-o", "t.vcd", "--from", from, "--pixels", "1"}, said_of_it);
  };
  of_small("0:@320,0", "--from 0:@320,0: column 320 is out of range; 0..319");
  of_small("0:@0,240", "row 240 is out of range; 0..239");
  of_small("2:@0,0", "picture 2 is out of range; 0..1");
  of_small("0:-240:0", "is not of the form PICTURE:CLOCK or PICTURE:@X,Y");
  of_small("0:500", "--pixels counts from a pixel");
  expect_refused({"trace", "demo", "-o", "t.vcd", "--from", "0:0", "--pixels", "1"},
                 "--pixels is for engines that do not race the beam");
}

TEST_F(CliSphereWiresTest, NamesOfTheEnginesOwnSignalsAreTold) {
  expect_refused({"trace", Small, "-o", "t.vcd", "--from", "0:0", "--to", "0:1", "--scope", "none"},
                 "no signal is under --scope and --depth; names look like "
                 "chip.u_sphere_tracer.state_q: try --scope 'chip.u_sphere_tracer', or "
                 "'*.state_q'");
  expect_refused({"trace", Small, "-o", "t.vcd", "--when", "3"},
                 "--when '3' names no signal; try 'u_sphere_tracer.state_q == HOST'");
}

TEST_F(CliSphereWiresTest, UnitsOfAnotherEngineAreToldToBeThat) {
  expect_refused(
      {"verify", "sphere_tracer"},
      "sphere_tracer is a unit of sphere, and this chip is beam; add --engine sphere, or give "
      "a scene of it");
  expect_refused({"verify", "stacks", "--scene", Small},
                 "stacks is a unit of beam, and this chip is sphere; add --engine beam, or give a "
                 "scene of it");
}

TEST_F(CliSphereWiresTest, UnitsOfAnEngineAreListedWithTheirRtl) {
  Program run(folder.path(), {"units", "--engine", "sphere", "--json"});
  EXPECT_EQ(run.wait(), 0) << run.err();
  const auto json = Json::parse(run.out());
  EXPECT_EQ(json["engine"], "sphere");
  ASSERT_EQ(json["units"].size(), 14u);
  for (const auto& unit : json["units"].elements()) EXPECT_NE(unit["rtl"], "");
}

}  // namespace
}  // namespace racebeam
