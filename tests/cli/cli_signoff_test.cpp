// `racebeam signoff` through the command line: green on our RTL, red on what it is there for.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <libxml/parser.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <set>

#include "tb/base/project_folder.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

const Words Few = {"--only", "mutants", "--mutants", "16"};

class CliSignoffTest : public testing::Test {
 protected:
  static Words words(const std::string& unit, const Words& more, const Words& common = Few) {
    Words all = {"signoff", unit};
    all.insert(all.end(), common.begin(), common.end());
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  /// The detail of the one result.
  Json detail(const Words& more, int code) {
    Words all = words("stacks", more);
    all.push_back("--json");
    Program run(folder.path(), all);
    EXPECT_EQ(run.wait(), code) << run.err() << run.out();
    return run.json()["results"][0]["detail"];
  }
  /// Model and RTL say the same to the file of episodes.
  void expect_good_episodes(const Json& of) {
    Program run(folder.path(), {"verify", "stacks", "--stream", of["episodes"].get<std::string>()});
    EXPECT_EQ(run.wait(), 0) << run.err() << run.out();
  }
  void expect_refused(const Words& arguments, const std::string& said) {
    Program run(folder.path(), arguments);
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.err(), HasSubstr(said));
  }
  /// With this file of waivers it is red and says so.
  void expect_red_waiver(const std::string& text, const std::string& said) {
    std::ofstream(folder / "waivers.toml") << text;
    Program run(folder.path(), words("stacks", {"--random", "5000", "--waivers", "waivers.toml"}));
    EXPECT_EQ(run.wait(), 1) << run.err();
    EXPECT_THAT(run.out(), HasSubstr(said));
  }
  /// mine.sv: the RTL of a unit with other words in one place.
  void write_mine(const std::string& unit, const std::string& was, const std::string& is) {
    std::string text = read_file(rtl_file(unit));
    ASSERT_NE(text.find(was), std::string::npos);
    std::ofstream(folder / "mine.sv") << text.replace(text.find(was), was.size(), is);
  }
  static std::string waiver(const std::string& mutant, const std::string& reason) {
    return "[[waiver]]\nunit = 'stacks'\nmutant = '" + mutant + "'\n" + reason +
           "\nreviewer = 'N. N.'\ndate = '2026-11-23'\n";
  }

  ScratchFolder folder;
};

TEST_F(CliSignoffTest, EveryMutantIsFoundOrProvedEqual) {
  const Json all = detail({"--random", "5000"}, 0);
  EXPECT_EQ(all["mutants"], 16);
  EXPECT_EQ(all["found"].get<int>() + all["equal"].get<int>(), 16);
  EXPECT_GT(all["found"].get<int>(), 8);
}

TEST_F(CliSignoffTest, WhatFindsAMutantIsShrunk) {
  const Json all = detail({"--random", "5000", "--shrink"}, 0);
  EXPECT_EQ(all["shrunk"]["mutants"].get<int>() + all["shrunk"]["not_shrunk"].get<int>(),
            all["found"].get<int>());
  EXPECT_GT(all["shrunk"]["clocks"]["median"].get<int>(), 0);
  EXPECT_LE(all["shrunk"]["clocks"]["median"], all["clocks"]["median"]);
  EXPECT_LE(all["shrunk"]["clocks"]["median"], 10);
  EXPECT_LE(all["shrunk"]["moving"]["median"], 3);
}

TEST_F(CliSignoffTest, WhatAShortStimulusMissesGetsACounterexampleAndNoProof) {
  const Json whole = detail({"--random", "5000"}, 0), few = detail({"--random", "2"}, 1);
  EXPECT_EQ(few["equal"], whole["equal"]);
  EXPECT_GT(few["not_found"].get<int>(), 8);
  for (const auto& mutant : few["survivors"].elements())
    if (mutant["state"] == "escaped") {
      const auto stream = mutant["stream"].get<std::string>();
      EXPECT_TRUE(fs::exists(folder / stream)) << stream;
    }
  expect_good_episodes(few);
}

TEST_F(CliSignoffTest, WhatIsFoundLateGetsAStreamOfItsOwn) {
  const Json any = detail({"--random", "5000"}, 0);
  const Json soon = detail({"--random", "5000", "--within", "20"}, 1);
  EXPECT_EQ(soon["equal"], any["equal"]);
  EXPECT_EQ(soon["found"].get<int>() + soon["not_found"].get<int>(), any["found"].get<int>());
  EXPECT_GT(soon["not_found"].get<int>(), 0);
  EXPECT_LT(soon["clocks"]["most"].get<int>(), 20);
  expect_good_episodes(soon);
}

TEST_F(CliSignoffTest, AMistakeInTheRtlTurnsItRed) {
  write_mine("stacks", "(n + 1) % IntervalStackDepth", "n % IntervalStackDepth");
  Program run(folder.path(), words("stacks=mine.sv", {}));
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.out(), HasSubstr("model and RTL differ in clock"));
}

TEST_F(CliSignoffTest, AWholeChipHasChecksOfItsOwn) {
  Program run(folder.path(), {"signoff", "racebeam_top", "--only", "comparator", "--only", "lint",
                              "--only", "mutants", "--json"});
  EXPECT_EQ(run.wait(), 0) << run.err() << run.out();
  const Json results = run.json()["results"];
  ASSERT_EQ(results.size(), 2u) << "its units have mutants";
  EXPECT_EQ(results[0]["detail"]["lockstep"]["bits"], 8 + 1) << "uo_o, pwm_o";
  EXPECT_EQ(results[0]["detail"]["lockstep"]["missed"], 0);
}

TEST_F(CliSignoffTest, AMistakeInTheWiringOfTheChipTurnsItRed) {
  write_mine("racebeam_top", ".pwm_o(pwm_o)", ".pwm_o()");
  Program run(folder.path(), {"signoff", "racebeam_top=mine.sv", "--only", "comparator"});
  EXPECT_EQ(run.wait(), 1) << run.err();
  EXPECT_THAT(run.out(), HasSubstr("differ by themselves, at pwm_o"));
}

TEST_F(CliSignoffTest, AFileOfAnotherNameIsNoWarning) {
  std::ofstream(folder / "mine.sv") << read_file(rtl_file("stacks"));
  Program run(folder.path(), {"signoff", "stacks=mine.sv", "--only", "lint"});
  EXPECT_EQ(run.wait(), 0) << run.out();
}

TEST_F(CliSignoffTest, AWarningTurnsItRed) {
  write_mine("stacks", "endmodule",
             "  logic nobody_reads_it;\n  assign nobody_reads_it = rst;\n"
             "  logic rst;\n  assign rst = 1'b0;\nendmodule");
  Program run(folder.path(), {"signoff", "stacks=mine.sv", "--only", "lint"});
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.out(), HasSubstr("nobody_reads_it"));
}

TEST_F(CliSignoffTest, WrongWaiversTurnItRed) {
  const std::string reason = "reason = 'looked at'";
  expect_red_waiver(waiver("inv $nothing$1 Y[0]", reason), "there is no such mutant");
  const Json all = read_json(folder / "racebeam_signoff/stacks.mutants.json");
  const auto equal = all["detail"]["survivors"][0]["mutant"].get<std::string>();
  expect_red_waiver(waiver(equal, reason), "proved equal; take the waiver away");
  expect_red_waiver(waiver(equal, "reason = ' '"), "has no reason");
  std::ofstream(folder / "waivers.toml") << waiver(equal, "raison = 'x'");
  expect_refused(words("stacks", {"--waivers", "waivers.toml"}), "waivers.toml:4");
}

// In four states a table whose file is not read would be unknown.
TEST_F(CliSignoffTest, UnitsWithATableAreSignedOff) {
  Program run(folder.path(),
              {"signoff", "timeline", "scene_rom", "--scene",
               RACEBEAM_SOURCE_DIR "/tests/signoff/tables.toml", "--only", "coverage", "--only",
               "comparator", "--only", "reset", "--only", "lint"});
  EXPECT_EQ(run.wait(), 0) << run.out() << run.err();
}

// In the copy the lines, and so the names of mutants, are others than those that are waived.
TEST_F(CliSignoffTest, TheProjectsWaiversAreNotHeldAgainstYourRtl) {
  const std::string unit = "sphere_host_link";
  ASSERT_THAT(read_file(RACEBEAM_SOURCE_DIR "/tb/signoff/waivers.toml"),
              HasSubstr("\nunit = \"" + unit + "\""));
  std::ofstream(folder / "mine.sv") << "// mine\n" << read_file(rtl_file(unit));
  Program run(folder.path(), {"signoff", unit + "=mine.sv", "--engine", "sphere", "--only",
                              "mutants", "--mutants", "1", "--random", "1000"});
  EXPECT_THAT(run.wait(), testing::AnyOf(0, 1)) << run.err();
  EXPECT_THAT(run.out(), Not(HasSubstr("waivers.toml")));
}

TEST_F(CliSignoffTest, JUnitIsXmlWithAFailureForWhatIsRed) {
  Program run(folder.path(), words("stacks=rtl", {"--random", "2", "--junit", "junit.xml"}));
  EXPECT_EQ(run.wait(), 1);
  const std::unique_ptr<xmlDoc, void (*)(xmlDocPtr)> xml(
      xmlReadFile((folder / "junit.xml").c_str(), nullptr, XML_PARSE_NONET), xmlFreeDoc);
  ASSERT_TRUE(xml);
  const std::string text = read_file(folder / "junit.xml");
  EXPECT_THAT(text, HasSubstr("<testcase classname=\"racebeam.mutants\" name=\"stacks\""));
  EXPECT_THAT(text, HasSubstr("failures=\"1\""));
  EXPECT_THAT(text, HasSubstr("<failure message="));
}

TEST_F(CliSignoffTest, AToolThatIsMissingIsToldAndOtherChecksGoOn) {
  const ScratchFolder tools;
  for (const char* tool : {"verilator", "perl", "c++", "sh"})
    for (const char* bin : {"/usr/bin/", "/bin/", "/usr/local/bin/"})
      if (fs::exists(std::string(bin) + tool) && !fs::exists(tools / tool))
        fs::create_symlink(std::string(bin) + tool, tools / tool);
  Program::Setting setting;
  setting.environment = "PATH=" + tools.path();
  Program run(folder.path(), {"signoff", "stacks"}, setting);
  EXPECT_EQ(run.wait(), 3);
  EXPECT_THAT(run.out(), HasSubstr("yosys is not installed"));
  EXPECT_THAT(run.out(), HasSubstr("no warning"));
}

// Without Verilator there is nothing to wait for.
TEST_F(CliSignoffTest, AllEnginesAreOneReport) {
  Program::Setting setting;
  setting.environment = "PATH=" + folder.path();
  Program run(folder.path(),
              {"signoff", "all", "--engine", "all", "--only", "lint", "-o", "all", "--json"},
              setting);
  EXPECT_EQ(run.wait(), 3) << run.err();
  const Json json = run.json();
  EXPECT_EQ(json["engine"], "all");
  std::set<std::string> names;
  for (const Json& result : json["results"].elements())
    names.insert(result["engine"].get<std::string>() + "/" + result["unit"].get<std::string>());
  EXPECT_EQ(names.size(), json["results"].size()) << "each unit of each engine once";
  EXPECT_THAT(names,
              testing::IsSupersetOf({"beam/vga_timing", "beam/racebeam_top", "sphere/vga_timing",
                                     "block/block_core", "voxel/voxel_walker"}));
  EXPECT_THAT(read_file(folder / "all/signoff.html"), HasSubstr("sphere/vga_timing"));
}

TEST_F(CliSignoffTest, BadWordsAreRefused) {
  expect_refused({"signoff", "stacks", "--engine", "all"}, "name the engine that has stacks");
  expect_refused({"signoff", "all", "--engine", "all", "--set", "fifo_entries=8"}, "leave out");
  expect_refused({"signoff", "stakcs"}, "did you mean 'stacks'");
  expect_refused({"signoff", "stacks", "--only", "mutnats"}, "did you mean 'mutants'");
  expect_refused({"signoff", "racebeam_top", "--only", "mutants"}, "whose units have that check");
  expect_refused({"signoff", "racebeam_top", "--set", "fifo_entries=64"}, "leave out");
  expect_refused({"signoff", "stacks=mine.so"}, "give its source");
  expect_refused({"signoff", "stacks=gates"}, "racebeam signoff stacks --only gates");
  expect_refused({"signoff", "stacks="}, "UNIT=FILE.sv");
  expect_refused({"signoff", "stacks", "--mutants", "0"}, "--mutants");
  expect_refused({"signoff", "stacks", "--waivers", "none.toml"}, "there is no file none.toml");
  expect_refused({"signoff", "stacks", "--junit", "no/such/junit.xml"}, "no/such");
}

}  // namespace
}  // namespace racebeam
