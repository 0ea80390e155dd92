// RTL on the spot through the command line: made when needed, kept, and what users name as RTL.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tb/verilate/project_folder.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> Short = {"--frames", "0", "--random", "2000"};

class CliRtlTest : public testing::Test {
 protected:
  static std::vector<std::string> verify(const std::string& word,
                                         const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"verify", word};
    words.insert(words.end(), Short.begin(), Short.end());
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  }
  /// The unit's own text with one place changed.
  static std::string changed(const std::string& unit, const std::string& from,
                             const std::string& to) {
    std::string text = read_file(rtl_file(unit));
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
  void expect(int code, const std::vector<std::string>& words, const std::string& said = "") {
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), code) << run.err();
    EXPECT_THAT(run.err(), HasSubstr(said));
  }
  /// A cache of this test alone.
  Program::Setting own_cache() const {
    Program::Setting setting;
    setting.environment = "RACEBEAM_CACHE=" + cache();
    return setting;
  }
  std::string cache() const { return folder / "cache"; }
  int in_cache(const std::string& extension) const {
    int found = 0;
    for (const auto& entry : fs::directory_iterator(cache()))
      found += entry.path().extension() == extension &&
               entry.path().filename().string().rfind("lock", 0) != 0;
    return found;
  }
  /// The stacks with a constant 1 that comes from elsewhere.
  static std::string stacks_with(const std::string& one) {
    return changed("stacks", "(n + 1) % IntervalStackDepth",
                   "(n + " + one + ") % IntervalStackDepth");
  }

  ScratchFolder folder;
};

TEST_F(CliRtlTest, ATwinIsVerilatedWhenFirstNeededAndKept) {
  Program first(folder.path(), verify("stacks"), own_cache());
  EXPECT_EQ(first.wait(), 0) << first.err();
  EXPECT_THAT(first.err(), HasSubstr("racebeam: verilating stacks (stacks.sv)\n"));
  Program second(folder.path(), verify("stacks"), own_cache());
  EXPECT_EQ(second.wait(), 0) << second.err();
  EXPECT_THAT(second.err(), Not(HasSubstr("verilating")));
}

TEST_F(CliRtlTest, OfTwoThatNeedTheSameOneMakesItAndTheOtherWaits) {
  Program one(folder.path(), verify("stacks"), own_cache());
  Program two(folder.path(), verify("stacks"), own_cache());
  EXPECT_EQ(one.wait(), 0) << one.err();
  EXPECT_EQ(two.wait(), 0) << two.err();
  const std::string said = one.err() + two.err();
  EXPECT_NE(said.find("verilating"), std::string::npos);
  EXPECT_EQ(said.find("verilating"), said.rfind("verilating")) << said;
  EXPECT_EQ(in_cache(".so"), 1);
}

TEST_F(CliRtlTest, CtrlCWhileVerilatingEndsWith130AndLeavesNothing) {
  Program run(folder.path(), verify("stacks"), own_cache());
  const auto working = [&] {
    if (!fs::exists(cache())) return false;
    for (const auto& entry : fs::directory_iterator(cache()))
      if (entry.path().filename().string().rfind("work.", 0) == 0) return true;
    return false;
  };
  while (!working()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_FALSE(working());
  EXPECT_EQ(in_cache(".so"), 0);
}

TEST_F(CliRtlTest, WhatAKilledProgramHasStartedDiesWithIt) {
  fs::create_directory(folder / "bin");
  write("bin/verilator", "#!/bin/sh\nsleep 1000 &\necho $! > $0.new\nmv $0.new $0.id\nwait\n");
  fs::permissions(folder / "bin/verilator", fs::perms::owner_all);
  Program::Setting setting;
  setting.environment = "PATH=" + (folder / "bin") + ":" + std::getenv("PATH");
  Program run(folder.path(), verify("stacks=" + rtl_file("scene")), setting);
  const std::string file = folder / "bin/verilator.id";
  for (int n = 0; n < 6000 && !fs::exists(file); ++n) usleep(10'000);
  const int started = std::stoi(read_file(file));
  const auto lives = [&] {
    return !read_file("/proc/" + std::to_string(started) + "/cmdline").empty();
  };
  ASSERT_TRUE(lives());
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  for (int n = 0; n < 6000 && lives(); ++n) usleep(10'000);
  EXPECT_FALSE(lives());
}

TEST_F(CliRtlTest, AnIncludeBesideTheFileIsFoundAndItsChangeIsSeen) {
  fs::create_directory(folder / "rtl");
  write("rtl/mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE"));
  write("rtl/one.svh", "`define ONE 1\n");
  expect(0, verify("stacks=rtl/mine.sv"));
  write("rtl/one.svh", "`define ONE 0\n");
  expect(1, verify("stacks=rtl/mine.sv"), "differs");
  write("rtl/one.svh", "`define ONE 1\n");
  expect(0, verify("stacks=rtl/mine.sv"));
}

TEST_F(CliRtlTest, AUnitMayBeSeveralFiles) {
  write("a.sv", stacks_with("one::One"));
  write("b.sv", "package one;\n  localparam int One = 1;\nendpackage\n");
  expect(0, verify("stacks=b.sv+a.sv"));
  expect(2, verify("stacks=a.sv"), "cannot be verilated");
  expect(2, verify("stacks=b.sv+none.sv"), "there is no file 'none.sv' for the unit stacks");
}

TEST_F(CliRtlTest, AModuleThatNoFileHasIsFoundBesideThem) {
  write("mine.sv", stacks_with("one"));
  std::string text = read_file(folder / "mine.sv");
  text.insert(text.rfind("endmodule"), "  wire [31:0] one;\n  the_one u_one (.one);\n");
  write("mine.sv", text);
  write("the_one.sv", "module the_one (output [31:0] one);\n  assign one = 1;\nendmodule\n");
  expect(0, verify("stacks=mine.sv"));
}

TEST_F(CliRtlTest, AListHasFilesFoldersAndDefines) {
  fs::create_directories(folder / "ip/inc");
  write("ip/mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE - `TWO"));
  write("ip/inc/one.svh", "`define ONE 3\n");
  write("ip/mine.f", "# my stacks\n+incdir+inc\n+define+TWO=2 // less\nmine.sv\n");
  expect(0, verify("stacks=ip/mine.f"));
  write("ip/mine.f", "-I inc -DTWO=3\nmine.sv\n");
  expect(1, verify("stacks=ip/mine.f"), "differs");
  write("ip/mine.f", "-I inc\n--two 3\nmine.sv\n");
  expect(2, verify("stacks=ip/mine.f"), "ip/mine.f:2: what is --two?");
}

TEST_F(CliRtlTest, AFolderStandsForItsFiles) {
  fs::create_directory(folder / "ip");
  write("ip/a.sv", stacks_with("one_pkg::One"));
  write("ip/one_pkg.sv", "package one_pkg;\n  localparam int One = 1;\nendpackage\n");
  expect(0, verify("stacks=ip"));
}

TEST_F(CliRtlTest, AKnobThatTheRtlLacksIsNamed) {
  write("mine.sv",
        changed("interval_fifo", "parameter int FifoEntries", "localparam int FifoEntries"));
  expect(1, verify("interval_fifo=mine.sv", {"--set", "fifo_entries=12"}),
         "mine.sv has no parameter FifoEntries; the knob fifo_entries does not reach it");
  Program usual(folder.path(), verify("interval_fifo=mine.sv"));
  EXPECT_EQ(usual.wait(), 0) << usual.err();
  EXPECT_THAT(usual.err(), Not(HasSubstr("no parameter")));
}

TEST_F(CliRtlTest, AVectorThatFeedsItselfBitByBitIsAWarning) {
  std::string text = changed("stacks", "fread_o = '0;", "fread_o = chain[3] ? '1 : '0;");
  const auto at = text.find("  // The top is the entry below sp");
  ASSERT_NE(at, std::string::npos);
  const std::string line = std::to_string(std::count(text.begin(), text.begin() + at, '\n') + 1);
  text.insert(at, "  wire [3:0] chain = {chain[2:0] & {3{sp_i[0]}}, 1'b0};  // 0\n");
  write("mine.sv", text);
  const std::string warning =
      "warning: mine.sv:" + line +
      " stacks.chain: depends on itself without a register between, perhaps "
      "bit by bit; Verilator may compute it wrongly: break the vector into "
      "wires";
  expect(0, verify("stacks=mine.sv"), warning);
  expect(0, {"render", "demo", "--frames", "1", "--crc", "--use", "stacks=mine.sv"}, warning);
  Program own(folder.path(), verify("all"));
  EXPECT_EQ(own.wait(), 0) << own.err();
  EXPECT_THAT(own.err(), Not(HasSubstr("warning")));
}

TEST_F(CliRtlTest, AWrongPortNamesTheFile) {
  write("mine.sv", changed("stacks", "push_en_i,", "push_enable_i,\n    input logic push_en_i,"));
  Program run(folder.path(), verify("stacks=mine.sv"));
  EXPECT_EQ(run.wait(), 2);
  EXPECT_THAT(run.err(),
              testing::ContainsRegex("mine.sv:[0-9]+: this does not fit the unit stack"));
  EXPECT_THAT(run.err(), HasSubstr("port push_enable_i is not a port of the unit"));
  EXPECT_THAT(run.err(), Not(HasSubstr(".so")));
}

TEST_F(CliRtlTest, ANetlistWithoutTheTableParametersIsUsedAsItIs) {
  std::string text = read_file(rtl_file("scene_rom"));
  for (std::size_t at = 0; (at = text.find("parameter ")) != std::string::npos;)
    text.replace(at, 9, "localparam");
  write("mine.sv", text);
  Program run(folder.path(),
              verify("scene_rom=mine.sv", {"--scene", RACEBEAM_SOURCE_DIR "/scenes/demo.toml"}));
  run.wait();
  EXPECT_THAT(run.err(), HasSubstr("the scene's table of rooms does not reach it"));
  EXPECT_THAT(run.err(), Not(HasSubstr("not found in the design")));
}

TEST_F(CliRtlTest, WithoutVerilatorThePackageIsNamed) {
  Program::Setting setting;
  setting.environment = "PATH=/nonexistent";
  Program run(folder.path(), verify("stacks"), setting);
  EXPECT_EQ(run.wait(), 3);
  EXPECT_THAT(run.err(), HasSubstr("install the package `verilator`"));
}

TEST_F(CliRtlTest, ACacheThatCannotBeWrittenIsNamed) {
  Program::Setting setting;
  setting.environment = "RACEBEAM_CACHE=/dev/null/cache";
  Program run(folder.path(), verify("stacks"), setting);
  EXPECT_EQ(run.wait(), 2);
  EXPECT_THAT(run.err(),
              HasSubstr("/dev/null/cache of RACEBEAM_CACHE cannot be written: Not a dir"));
}

TEST_F(CliRtlTest, WithoutAHomeTheCacheIsAmongTemporaryFiles) {
  unsetenv("RACEBEAM_CACHE");
  unsetenv("XDG_CACHE_HOME");
  setenv("HOME", "/dev/null", 1);
  Program::Setting setting;
  setting.environment = "TMPDIR=" + folder.path();
  Program run(folder.path(), verify("stacks"), setting);
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_TRUE(fs::exists(folder / ("racebeam-" + std::to_string(geteuid()))));
  setting.environment = "TMPDIR=/nonexistent";
  Program nowhere(folder.path(), verify("stacks"), setting);
  EXPECT_EQ(nowhere.wait(), 2);
  EXPECT_THAT(nowhere.err(), HasSubstr("set TMPDIR or RACEBEAM_CACHE"));
}

TEST_F(CliRtlTest, VerilateMakesAPluginForOthersAndSaysWhatItRead) {
  write("mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE"));
  write("one.svh", "`define ONE 1\n");
  expect(0, {"verilate", "stacks", "mine.sv", "-o", "mine.so", "--depfile", "mine.d"});
  const std::string rule = read_file(folder / "mine.d");
  EXPECT_EQ(rule.rfind("mine.so: ", 0), 0u) << rule;
  EXPECT_THAT(rule, HasSubstr("/one.svh"));
  expect(0, verify("stacks=mine.so"));
  expect(2, {"verilate", "stacks", "none.sv", "-o", "mine.so"}, "there is no file 'none.sv'");
}

TEST_F(CliRtlTest, WatchRunsAgainWhenAnEditorReplacesAnInclude) {
  write("mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE"));
  write("one.svh", "`define ONE 1\n");
  const std::string said = folder / "said";
  Program::Setting setting;
  setting.stdout_path = said;
  Program run(folder.path(), verify("stacks=mine.sv", {"--watch", "--json"}), setting);
  const auto wait_for = [&](const std::string& text) {
    while (read_file(said).find(text) == std::string::npos)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  };
  wait_for("\"differences\": 0");
  while (run.children() != 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  write("fresh", "`define ONE 0\n");
  fs::rename(folder / "fresh", folder / "one.svh");
  wait_for("\"differences\": 1");
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_THAT(run.err(), HasSubstr("waiting until mine.sv or one of "));
}

}  // namespace
}  // namespace racebeam
