// `racebeam trace` through the command line: the signals of its waveforms.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "tb/base/text_pattern.h"
#include "tests/cli/cli_trace_bench.h"
#include "tests/cli/traced_window.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

using CliTraceTest = CliTraceBench;

TEST_F(CliTraceTest, RtlHasTheSignalsOfTheModelWithTheSameChanges) {
  const std::vector<std::string> window = {"--from", "7223:-100", "--to", "7223:-98"};
  const Wave model = trace(window, "model.vcd");
  std::vector<std::string> with_rtl = window;
  with_rtl.insert(with_rtl.end(), {"--use", "all=rtl"});
  const Wave rtl = trace(with_rtl, "rtl.vcd");
  EXPECT_GT(rtl.signals.size(), model.signals.size()) << "RTL shows its inner signals too";
  int same = 0;
  for (const auto& [path, signal] : model.signals) {
    ASSERT_TRUE(rtl.signals.count(path)) << path;
    EXPECT_EQ(rtl[path].bits, signal.bits) << path;
    EXPECT_TRUE(rtl[path] == signal) << path << " changes otherwise";
    same += rtl[path] == signal;
  }
  EXPECT_GT(same, 300);
  Program shared(folder.path(), {"trace", "--diff", "model.vcd", "rtl.vcd", "--shared"});
  EXPECT_EQ(shared.wait(), 0) << shared.out();
  Program all(folder.path(), {"trace", "--diff", "model.vcd", "rtl.vcd"});
  EXPECT_EQ(all.wait(), 1) << "the RTL has more signals";
  EXPECT_THAT(all.out(), HasSubstr("only in rtl.vcd"));
}

TEST_F(CliTraceTest, OtherKnobsHaveTheSameRegistersInModelAndRtl) {
  const std::vector<std::string> window = {"--from", "7223:0",
                                           "--to",   "7223:1",
                                           "--set",  "skip_shared_edges=on",
                                           "--set",  "stepping=fraction",
                                           "--set",  "interval_stack_depth=5"};
  const Wave model = trace(window, "model.vcd");
  EXPECT_EQ(model["chip.u_ray_stepper.g_axis[2].dr1_q"].bits, 19);
  std::vector<std::string> with_rtl = window;
  with_rtl.insert(with_rtl.end(),
                  {"--use", "decision_datapath=rtl,ray_stepper=rtl,stacks=rtl,subdivider=rtl"});
  const Wave rtl = trace(with_rtl, "rtl.vcd");
  for (const auto& [path, signal] : model.signals)
    EXPECT_TRUE(rtl[path] == signal) << path << " changes otherwise";
}

TEST_F(CliTraceTest, BeginsWithTheFirstClockOfTheShow) {
  const Wave wave = trace({"--from", "0:-273:0", "--to", "0:-273:3"});
  EXPECT_EQ(wave.begin, 0u);
  EXPECT_EQ(wave.end, 4u * Period);
  EXPECT_THAT(said, Not(HasSubstr("Warning")));
}

TEST_F(CliTraceTest, LockstepShowsBothSides) {
  const Wave wave =
      trace({"--from", "60:0", "--to", "60:1", "--use", "stacks=lockstep,subdivider=rtl", "--scope",
             "chip.u_stacks", "--scope", "*.i1_q"});
  EXPECT_TRUE(wave.signals.count("chip.u_subdivider.i1_q"));
  EXPECT_FALSE(wave.signals.count("chip.u_subdivider.i2_q"));
  EXPECT_GE(expect_both_sides(wave, "chip.u_stacks"), 20) << "outputs and registers";
}

TEST_F(CliTraceTest, StatesAreWordsToo) {
  const Wave wave = trace({"--from", "60:10", "--to", "60:10", "--scope", "*.state_q*"});
  const auto& number = wave["chip.u_subdivider.state_q"];
  const auto& word = wave["chip.u_subdivider.state_q_name"];
  EXPECT_EQ(word.kind, "string");
  const std::map<std::string, std::string> words = {
      {"00", "left"}, {"01", "right"}, {"10", "bisect"}, {"11", "return"}};
  ASSERT_EQ(word.changes.size(), number.changes.size());
  for (const auto& [time, digits] : number.changes) EXPECT_EQ(word.at(time), words.at(digits));
  EXPECT_THAT(wave["beam.part"].at(wave.end), Not(""));
}

TEST_F(CliTraceTest, ScopeAndDepthChooseSignals) {
  const auto count = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"--from", "0:0:0", "--to", "0:0:9"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    int wires = 0, inside = 0;
    for (const auto& [path, signal] : trace(arguments).signals) {
      if (path.rfind("beam.", 0) == 0) continue;
      ++(std::count(path.begin(), path.end(), '.') == 1 ? wires : inside);
    }
    return std::pair{wires, inside};
  };
  const auto all = count({}), top = count({"--depth", "1"}),
             unit = count({"--scope", "chip.u_sc*"});
  EXPECT_GT(all.second, 250);
  EXPECT_EQ(top, (std::pair{all.first, 0}));
  EXPECT_EQ(unit.first, 0);
  EXPECT_EQ(unit.second, 15) << "the ports of scene";
}

TEST_F(CliTraceTest, FollowsTheClockAndTheFramesOfTheScene) {
  const Wave slow =
      trace({"--from", "60:251:2000", "--to", "61:-273:5", "--set", "clocks_per_pixel=3"});
  EXPECT_EQ(slow["beam.frame"].changes.size(), 2u);
  EXPECT_EQ(slow["beam.clock"].number(slow.begin), 2000u);
  EXPECT_EQ(slow["beam.pixel"].number(slow.begin), (2000u / 3 - 160) & 2047);
  EXPECT_EQ(slow.end - slow.begin, 406u * clock_period_ps(3));
  EXPECT_EQ(slow["chip.u_sequencer.frame_q"].number(slow.end), 61u);
}

/// The paths that a waveform declares; one of many lines is not to be read whole.
std::set<std::string> paths_of(const ScratchFolder& folder, const std::string& file) {
  const std::string text = read_file(folder / file);
  std::ofstream(folder / "head.vcd") << text.substr(0, text.find("\n#") + 1);
  std::set<std::string> paths;
  for (const auto& [path, signal] : Wave(folder / "head.vcd").signals) paths.insert(path);
  return paths;
}

/// A port, or a wire of the chip; not the clock, rays and the geometry of rooms.
bool belongs_to_an_overview(const std::string& path) {
  static const TextPattern calm(
      "beam\\.(frame|line|pixel|clock|part)|chip\\.\\w+|chip\\.u_\\w+\\.\\w+_n?[io]");
  static const TextPattern busy(
      ".*\\.(clk_i|(x2|consume)(_[io])?|(corner|dr2|neighbour|half_size|position|look)(_.*)?)");
  return calm.matches(path) && !busy.matches(path);
}

TEST_F(CliTraceTest, MoreThanAHundredLinesAreAnOverviewOfPortsAndWires) {
  const auto run = [&](const std::string& last, std::vector<std::string> more) {
    more.insert(more.begin(), {"trace", "demo", "--from", "7223:-150", "--to", last, "--set",
                               "clocks_per_pixel=1", "-o"});
    Program program(folder.path(), more);
    EXPECT_EQ(program.wait(), 0) << program.err();
    return program.err();
  };
  const auto is_said =
      HasSubstr("a long window is an overview: no registers, clock, rays or geometry");
  EXPECT_THAT(run("7223:-51", {"whole.vcd", "--depth", "1"}), Not(is_said)) << "a hundred lines";
  EXPECT_THAT(run("7223:-50:0", {"overview.vcd"}), is_said);
  EXPECT_THAT(run("7223:-50:0", {"all.vcd", "--scope", "*"}), Not(is_said));
  std::set<std::string> calm;
  for (const std::string& path : paths_of(folder, "all.vcd"))
    if (belongs_to_an_overview(path)) calm.insert(path);
  EXPECT_EQ(paths_of(folder, "overview.vcd"), calm);
  Program diff(folder.path(), {"trace", "--diff", "overview.vcd", "all.vcd", "--shared"});
  EXPECT_EQ(diff.wait(), 0);
  EXPECT_THAT(diff.out(), testing::StartsWith(std::to_string(calm.size()) + " shared signals"));
}

}  // namespace
}  // namespace racebeam
