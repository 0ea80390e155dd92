// RTL on the spot through the command line: made when needed, kept, and what users name as RTL.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/cli/cli_rtl_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

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
  ASSERT_TRUE(becomes_true(working));
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
  ASSERT_TRUE(becomes_true([&] { return fs::exists(file); }));
  const int started = std::stoi(read_file(file));
  const auto lives = [&] {
    return !read_file("/proc/" + std::to_string(started) + "/cmdline").empty();
  };
  ASSERT_TRUE(becomes_true(lives));  // no command line while it becomes sleep
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  EXPECT_TRUE(becomes_true([&] { return !lives(); }));
}

// As in the project's own folder, which has a folder `rtl`.
TEST_F(CliRtlTest, TheWordRtlIsOursWhateverFolderIsThere) {
  fs::create_directory(folder / "rtl");
  expect(0, {"render", "demo", "--use", "pixel_output=rtl", "-o", "o"});
  EXPECT_THAT(read_file(folder / "o/manifest.json"), HasSubstr("\"pixel_output\""));
}

TEST_F(CliRtlTest, AKnobThatTheRtlLacksIsNamed) {
  write("mine.sv",
        changed("interval_fifo", "parameter int FifoEntries", "localparam int FifoEntries"));
  expect(1, {"verify", "interval_fifo=mine.sv", "--frames", "1", "--set", "fifo_entries=12"},
         "mine.sv has no parameter FifoEntries; the knob fifo_entries does not reach it");
  Program usual(folder.path(), verify("interval_fifo=mine.sv"));
  EXPECT_EQ(usual.wait(), 0) << usual.err();
  EXPECT_THAT(usual.err(), Not(HasSubstr("no parameter")));
}

TEST_F(CliRtlTest, AKnobThatTheModelAloneHasIsRefusedForItsRtlOnly) {
  const std::string refused = "only the model of camera_unit has the knob camera_cosine so";
  const std::string with_file = "camera_unit=" + rtl_file("camera_unit");
  for (const std::string& word : {std::string("camera_unit"), with_file})
    expect(2, verify(word, {"--set", "camera_cosine=exact"}), refused);
  expect(2, {"render", "demo", "--use", "all=rtl", "--set", "camera_cosine=exact", "-o", "o"},
         refused);
  expect(0, verify("stacks", {"--set", "camera_cosine=exact"}));
}

TEST_F(CliRtlTest, RtlOfBeforeAKnobFitsWithoutTheKnobsPorts) {
  std::string text = read_file(rtl_file("interval_fifo"));
  const auto change = [&text](const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  change("input wire logic half_i,", "");
  change("output logic display_half_o,", "");
  change("half_i", "1'b0");
  change("assign display_half_o", "wire logic unseen");
  write("mine.sv", text);
  expect(0, verify("interval_fifo=mine.sv"));
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
  const std::string name = "racebeam-" + std::to_string(geteuid());
  add_run_time(folder / name);
  unsetenv("RACEBEAM_CACHE");
  unsetenv("XDG_CACHE_HOME");
  setenv("HOME", "/dev/null", 1);
  Program::Setting setting;
  setting.environment = "TMPDIR=" + folder.path();
  Program run(folder.path(), verify("stacks"), setting);
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.err(), HasSubstr("verilating stacks"));
  fs::create_directory(folder / "tmp");
  fs::rename(folder / name, fs::path(folder / "tmp") / name);
  setting.environment = "TMPDIR=tmp";
  Program relative(folder.path(), verify("vga_timing"), setting);
  EXPECT_EQ(relative.wait(), 0) << relative.err();
  EXPECT_THAT(relative.err(), HasSubstr("verilating vga_timing"));
  EXPECT_FALSE(fs::exists(folder / name));
  setting.environment = "TMPDIR=/nonexistent";
  Program nowhere(folder.path(), verify("stacks"), setting);
  EXPECT_EQ(nowhere.wait(), 2);
  EXPECT_THAT(nowhere.err(), HasSubstr("set TMPDIR or RACEBEAM_CACHE"));
}

TEST_F(CliRtlTest, WatchRunsAgainWhenAnEditorReplacesAnInclude) {
  write("mine.sv", "`include \"one.svh\"\n" + stacks_with("`ONE"));
  write("one.svh", "`define ONE 1\n");
  const std::string said = folder / "said";
  Program::Setting setting;
  setting.stdout_path = said;
  Program run(folder.path(), verify("stacks=mine.sv", {"--watch", "--json"}), setting);
  const auto has_said = [&](const std::string& text) {
    return becomes_true([&] { return read_file(said).find(text) != std::string::npos; });
  };
  ASSERT_TRUE(has_said("\"differences\": 0"));
  ASSERT_TRUE(becomes_true([&] { return run.children() == 0; }));
  write("fresh", "`define ONE 0\n");
  fs::rename(folder / "fresh", folder / "one.svh");
  EXPECT_TRUE(has_said("\"differences\": 1"));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_THAT(run.err(), HasSubstr("waiting until mine.sv or one of "));
}

}  // namespace
}  // namespace racebeam
