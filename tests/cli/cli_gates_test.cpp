// Units as gates through the command line: made by yosys when needed, with the chip's knobs, kept.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <tuple>

#include "tb/scene/engines.h"
#include "tests/cli/cli_rtl_bench.h"
#include "tests/cli/wave.h"
#include "tests/support/fake_mapping.h"
#include "tests/support/fake_yosys.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string Project = RACEBEAM_SOURCE_DIR;

class CliGatesTest : public CliRtlTest {
 protected:
  using Words = std::vector<std::string>;

  /// A PATH without yosys, but with all else.
  static void hide_yosys(const ScratchFolder& bin) {
    for (const auto& entry : fs::directory_iterator("/usr/bin"))
      if (entry.path().filename() != "yosys")
        fs::create_symlink(entry.path(), bin / entry.path().filename().string());
    setenv("PATH", bin.path().c_str(), 1);
  }
  void expect_same(const std::string& unit, const std::string& kind, const Words& more) {
    Words words = {"verify", unit + "=gates:" + kind, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words);
    ASSERT_EQ(run.wait(), 0) << run.err();
    EXPECT_THAT(run.err(), Not(HasSubstr("warning")));
    const auto rows = run.json()["units"];
    ASSERT_GT(rows.size(), 0u);
    for (const Json& row : rows.elements()) {
      EXPECT_EQ(row["unit"], unit);
      EXPECT_EQ(row["differences"], 0);
      EXPECT_GE(row["clocks"], 2000);
    }
  }
};

// --- What gates are -----------------------------------------------------------------------------
class CliGatesOfUnits : public CliGatesTest,
                        public testing::WithParamInterface<std::tuple<const char*, const char*>> {};

TEST_P(CliGatesOfUnits, AreTheModel) {
  const auto [unit, kind] = GetParam();
  Words more = Short;
  if (engine_of_unit(unit).name != std::string("beam"))
    more.insert(more.end(), {"--engine", engine_of_unit(unit).name});
  expect_same(unit, kind, more);
}

INSTANTIATE_TEST_SUITE_P(SmallUnits, CliGatesOfUnits,
                         testing::Combine(testing::Values("stacks", "store_arbiter"),
                                          testing::Values("generic", "osu018")));

TEST_F(CliGatesTest, ADrawnUnitInGatesDrawsTheModelsPicture) {
  expect(0, {"render", "demo", "--frames", "1", "-o", "model"});
  expect(0, {"render", "demo", "--frames", "1", "--use", "stacks=gates", "-o", "gates"});
  expect(0, {"render", "demo", "--frames", "1", "--use", "stacks=lockstep:gates:osu018", "-o",
             "beside"});
  const std::string model = read_file(folder / "model/frame_0000.png");
  EXPECT_GT(model.size(), 1000u);
  EXPECT_TRUE(read_file(folder / "gates/frame_0000.png") == model);
  EXPECT_TRUE(read_file(folder / "beside/frame_0000.png") == model);
  const auto stacks = [&](const std::string& name) {
    return read_json(folder / (name + "/manifest.json"))["units"]["stacks"]["implementation"];
  };
  EXPECT_EQ(stacks("gates"), "gates:generic");
  EXPECT_EQ(stacks("beside"), "lockstep:gates:osu018");
}

TEST_F(CliGatesTest, TheBugOfAnExhibitIsInItsGatesToo) {
  fs::copy_file(rtl_file("store_arbiter"), folder / "mine.sv");
  const std::string patch = "cd '" + folder.path() + "' && patch -s mine.sv '" + Project +
                            "/tests/museum/61-beam-has-to-wait.patch'";
  ASSERT_EQ(std::system(patch.c_str()), 0);
  const Words more = {"--engine", "sphere"};
  Program rtl(folder.path(), verify("store_arbiter=mine.sv", more));
  EXPECT_EQ(rtl.wait(), 1) << rtl.err();
  const std::string said = rtl.err();
  const auto at = said.find("store_arbiter: port take_ready_o differs on random traffic (");
  ASSERT_NE(at, std::string::npos) << said;
  const std::string found = said.substr(at, said.find(" clocks compared)", at) - at);
  for (const char* gates : {"gates:mine.sv", "gates:osu018:mine.sv"}) {
    Program run(folder.path(), verify(std::string("store_arbiter=") + gates, more));
    EXPECT_EQ(run.wait(), 1) << run.err();
    EXPECT_THAT(run.err(), HasSubstr(found)) << gates;
  }
}

// --- Knobs --------------------------------------------------------------------------------------
TEST_F(CliGatesTest, GatesHaveTheKnobsOfTheChipAndNoOthers) {
  const Words shallow = {"--set", "interval_stack_depth=2"};
  Program first(folder.path(), verify("stacks=gates"), own_cache());
  ASSERT_EQ(first.wait(), 0) << first.err();
  ASSERT_EQ(in_cache(".so"), 1);
  for (const auto& entry : fs::directory_iterator(cache()))
    if (entry.path().extension() == ".so" && entry.file_size() > 0)
      fs::copy_file(entry.path(), folder / "gates.so");
  expect(0, verify("stacks=gates.so"));
  expect(2, verify("stacks=gates.so", shallow),
         "gates.so was built with other parameters; build it with IntervalStackDepth=2");
  Program run(folder.path(), verify("stacks=gates", shallow), own_cache());
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.err(), HasSubstr("making gates of stacks (generic)"));
  EXPECT_EQ(in_cache(".so"), 2);
}

TEST_F(CliGatesTest, GatesHaveTheTablesOfTheScene) {
  const std::string scene = Project + "/scenes/museum.toml";
  expect_same("scene_rom", "generic", {"--frames", "0", "--random", "2000", "--scene", scene});
}

// --- The cache and what is missing --------------------------------------------------------------
TEST_F(CliGatesTest, AreMadeOnceAndKept) {
  Program first(folder.path(), verify("stacks=gates"), own_cache());
  EXPECT_EQ(first.wait(), 0) << first.err();
  EXPECT_THAT(first.err(), AllOf(HasSubstr("racebeam: making gates of stacks (generic)\n"),
                                 HasSubstr("racebeam: verilating stacks (stacks-generic-")));
  const FakeYosys none("echo it has run; exit 1", "exec /usr/bin/yosys -V");
  Program second(folder.path(), verify("stacks=gates"), own_cache());
  EXPECT_EQ(second.wait(), 0) << second.err();
  EXPECT_EQ(second.err(), "");
  Program other(folder.path(), verify("stacks=gates:osu018"), own_cache());
  EXPECT_EQ(other.wait(), 2);
  EXPECT_THAT(other.err(), AllOf(HasSubstr("stacks.sv does not become gates:"),
                                 HasSubstr("it has run"), HasSubstr("yosys cannot read stacks")));
}

TEST_F(CliGatesTest, AnotherYosysMakesOthers) {
  Program first(folder.path(), verify("stacks=gates"), own_cache());
  EXPECT_EQ(first.wait(), 0) << first.err();
  const FakeYosys newer("exec /usr/bin/yosys \"$@\"");
  Program second(folder.path(), verify("stacks=gates"), own_cache());
  EXPECT_EQ(second.wait(), 0) << second.err();
  EXPECT_THAT(second.err(), HasSubstr("making gates of stacks"));
}

TEST_F(CliGatesTest, CtrlCEndsYosysAndLeavesNothing) {
  const FakeYosys hangs(FakeYosys::Hangs);
  Program run(folder.path(), verify("stacks=gates"), own_cache());
  ASSERT_TRUE(becomes_true([&] { return hangs.hangs(); }));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_TRUE(hangs.is_gone());
  EXPECT_EQ(in_cache(".gates"), 0);
}

TEST_F(CliGatesTest, WithoutYosysItsPackageIsNamed) {
  expect(0, verify("stacks"));
  const ScratchFolder bin;
  hide_yosys(bin);
  expect(3, verify("stacks=gates"), "yosys is not installed; install the package `yosys`");
  expect(0, verify("stacks"));
}

// --- Bad input ----------------------------------------------------------------------------------
TEST_F(CliGatesTest, WhatThereIsNotIsRefusedWithAllThatThereIs) {
  expect(2, verify("stacks=gates:osu"),
         "unknown gates 'osu'; did you mean 'osu018'? (there is: generic, osu018, FILE.sv, "
         "osu018:FILE.sv)");
  expect(2, verify("stacks=gates:"), "unknown gates ''");
  expect(2, verify("stacks=gates:none.sv"), "there is no file 'none.sv' to be made into gates");
  expect(2, verify("stacks=gates:osu018:"), "unknown gates 'osu018:'");
  expect(2, verify("stacks=gate"), "unknown implementation 'gate'; did you mean 'gates'?");
  write("mine.sv", "module stacks; endmodul");
  expect(2, verify("stacks=gates:mine.sv"), "mine.sv");
  expect(2, verify("all=gates:mine.sv"), "a file is for one");
  expect(2, {"render", "demo", "--frames", "1", "--use", "racebeam_top=gates", "-o", "o"},
         "it runs beside the chip only, as racebeam_top=lockstep; for gates in the chip write "
         "all=gates");
}

// Verilator takes it, yosys 0.23 does not: nothing is compared.
TEST_F(CliGatesTest, RtlThatYosysCannotReadIsToldInItsOwnWords) {
  write("mine.sv", changed("stacks", "endmodule",
                           "  typedef int unused_t [string];\n  unused_t unused;\nendmodule"));
  Program run(folder.path(), verify("stacks=gates:mine.sv"));
  EXPECT_EQ(run.wait(), 2) << run.err();
  EXPECT_THAT(run.err(), AllOf(HasSubstr("mine.sv does not become gates:"), HasSubstr("ERROR")));
}

// --- Area and slack -----------------------------------------------------------------------------
TEST_F(CliGatesTest, AreaAndSlackAreWhatTheToolsSay) {
  Program run(folder.path(), {"units", "--area", "stacks", "interval_fifo", "--json"});
  ASSERT_EQ(run.wait(), 0) << run.err();
  const Json json = run.json();
  ASSERT_EQ(json["units"].size(), 2u);
  const std::string command = "cd '" + folder.path() + "' && '" + Project +
                              "/scripts/netlist' --osu018 stacks s.v >figures && "
                              "(echo \"// $(cat figures)\"; cat s.v) >s.gates && '" +
                              Project +
                              "/scripts/timing' osu018 stacks --netlist s.gates --pins "
                              ">path";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream path(folder / "path");
  std::string name, multipliers, from, to;
  double flip_flops = 0, cells = 0, area = 0, ns = 0;
  path >> name >> flip_flops >> cells >> area >> multipliers >> ns >> from >> to;
  const Json stacks = json["units"][0];
  EXPECT_EQ(stacks["name"], "stacks");
  EXPECT_EQ(stacks["flip_flops"], flip_flops);
  EXPECT_EQ(stacks["cells"], cells);
  EXPECT_EQ(stacks["area"], area);
  EXPECT_EQ(stacks["longest_path"], ns);
  EXPECT_EQ(stacks["from"], from);
  EXPECT_EQ(stacks["to"], to);
  EXPECT_GT(ns, 1) << "of a path through cells";
  EXPECT_LT(ns, 1000 / 50.4);
}

TEST_F(CliGatesTest, StaWithoutASlackIsAFault) {
  expect(0, {"units", "--area", "stacks"});
  {
    const FakeTool silent("sta", "exit 0");
    expect(2, {"units", "--area", "stacks"}, "sta has not found the WORST path of stacks");
  }
  expect(2, {"units", "--area", "stakcs"}, "unknown unit 'stakcs'; did you mean 'stacks'?");
  expect(2, {"units", "stacks"}, "units takes names of units with --area only");
}

// --- Waves --------------------------------------------------------------------------------------
TEST_F(CliGatesTest, TracesShowPortsAndRegistersOfGatesByName) {
  const auto trace = [&](const std::string& how) {
    expect(0, {"trace", "demo", "--from", "7223:-100", "--to", "7223:-98", "--use",
               "interval_fifo=" + how, "-o", "t.vcd"});
    return Wave(folder / "t.vcd");
  };
  const std::string unit = "chip.u_interval_fifo.";
  const Wave rtl = trace("rtl"), gates = trace("gates"), cells = trace("gates:osu018");
  for (const char* name : {"consume_i", "ack_o", "display_o", "head_len_q", "tail_ptr_q"}) {
    ASSERT_TRUE(gates.signals.count(unit + name)) << name;
    EXPECT_EQ(gates[unit + name].bits, rtl[unit + name].bits) << name;
    EXPECT_TRUE(gates[unit + name] == rtl[unit + name]) << name;
  }
  EXPECT_TRUE(cells[unit + "display_o"] == rtl[unit + "display_o"]);
  for (const auto& [path, signal] : gates.signals)
    EXPECT_THAT(path, Not(HasSubstr("._"))) << "a wire that yosys has named";
}

// --- All of them: minutes -----------------------------------------------------------------------
struct Unit {
  const engine* of;
  std::string name;
};

std::vector<Unit> all_units() {
  std::vector<Unit> all;
  for (const engine* one : engines())
    for (const unit_row& row : one->units) all.push_back({one, row.name});
  return all;
}

class GatesOfEveryUnit : public CliGatesTest,
                         public testing::WithParamInterface<std::tuple<Unit, std::string>> {};

TEST_P(GatesOfEveryUnit, AreTheModel) {
  const auto& [unit, kind] = GetParam();
  Words more = {"--random", "20000", "--frames", "2"};
  if (unit.of->unit(unit.name)->shows == unit_row::SceneFile)
    more.insert(more.end(), {"--scene", Project + "/scenes/museum.toml"});
  else more.insert(more.end(), {"--engine", unit.of->name});
  expect_same(unit.name, kind, more);
}

std::string name_of(const testing::TestParamInfo<std::tuple<Unit, std::string>>& info) {
  const auto& [unit, kind] = info.param;
  return std::string(unit.of->name) + "_" + unit.name + "_" + kind;
}

INSTANTIATE_TEST_SUITE_P(LongUnits, GatesOfEveryUnit,
                         testing::Combine(testing::ValuesIn(all_units()),
                                          testing::Values("generic", "osu018")),
                         name_of);

using LongCliGatesTest = CliGatesTest;

TEST_F(LongCliGatesTest, TheWholeChipInGatesIsTheChipInLaterFramesToo) {
  Program run(folder.path(), {"verify", "racebeam_top=gates", "--frames", "3", "--json"});
  ASSERT_EQ(run.wait(), 0) << run.err();
  EXPECT_EQ(run.json()["units"][0]["differences"], 0);
  EXPECT_GE(run.json()["units"][0]["clocks"], 3 * 840000);
}

TEST_F(LongCliGatesTest, TheWholeChipInStandardCellsIsTheChip) {
  Program run(folder.path(), {"verify", "racebeam_top=gates:osu018", "--frames", "1", "--json"});
  ASSERT_EQ(run.wait(), 0) << run.err();
  EXPECT_EQ(run.json()["units"][0]["differences"], 0);
}

}  // namespace
}  // namespace racebeam
