// `racebeam trace` when nobody knows where to look: --when, --around mismatch, --record.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tb/base/project_folder.h"
#include "tb/trace/trace_window.h"
#include "tests/cli/cli_trace_bench.h"
#include "tests/cli/x_server.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

const Raster raster;

std::string told(const TracePoint& at) {
  return "frame " + std::to_string(at.frame) + ", line " + std::to_string(at.line) + ", clock " +
         std::to_string(at.clock);
}

std::string argument(const TracePoint& at) {
  return std::to_string(at.frame) + ":" + std::to_string(at.line) + ":" + std::to_string(at.clock);
}

class CliTraceEventTest : public CliTraceBench {
 protected:
  int run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"trace", "demo", "-o", "t.vcd"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program program(folder.path(), arguments);
    const int code = program.wait();
    said = program.err();
    return code;
  }
  Wave wave() const { return Wave(folder / "t.vcd"); }
  static std::int64_t first_clock(const Wave& wave) {
    return static_cast<std::int64_t>(wave.begin) / Period;
  }
  static std::int64_t clocks(const Wave& wave) {
    return static_cast<std::int64_t>(wave.end - wave.begin) / Period;
  }
  /// The RTL of a unit with one line of it replaced.
  void write_faulty(const std::string& unit, const std::string& right, const std::string& wrong) {
    std::string text = read_file(rtl_file(unit));
    const auto at = text.find(right);
    ASSERT_NE(at, std::string::npos) << right;
    std::ofstream(folder / (unit + ".sv")) << text.replace(at, right.size(), wrong);
  }
};

/// The first clock of a frame, from line `line` on, in which the interval stack has `entries`.
TracePoint first_with(int entries, int frame, int line) {
  const knobs k;
  chip_core chip;
  chip.clock(false, k);
  chip.deposit(frame, k);
  for (std::int64_t at = TracePoint{frame, FirstLine, 0}.ordinal(raster);; ++at) {
    const TracePoint point = point_at(at, raster);
    if (point.line >= line && chip.subdivider.sd_q == entries) return point;
    chip.clock(true, k);
  }
}

/// All of `window` is in `whole`, but for the sound's accumulators, which go on from frame to frame
/// and start anew where a run starts.
void expect_in(const Wave& window, const Wave& whole) {
  for (const auto& [path, signal] : window.signals) {
    if (path.find("pwm") != std::string::npos) continue;
    for (std::uint64_t at = window.begin; at < window.end; at += Period)
      ASSERT_EQ(signal.at(at), whole[path].at(at)) << path << " at " << at;
  }
}

TEST_F(CliTraceEventTest, WhenIsTheFirstClockInWhichItIsTrueForModelAndRtl) {
  const TracePoint there = first_with(3, 7223, -110);
  for (const char* units : {"all=model", "subdivider=rtl,stacks=rtl"}) {
    ASSERT_EQ(run({"--when", "u_subdivider.sd_q == 3 && line >= -110", "--from", "7223:-240",
                   "--pre", "20", "--post", "10", "--use", units}),
              0)
        << said;
    EXPECT_THAT(said, HasSubstr("--when holds in " + told(there)));
    const Wave w = wave();
    EXPECT_EQ(first_clock(w), there.ordinal(raster) - 20);
    EXPECT_EQ(clocks(w), 31);
    EXPECT_EQ(w["chip.u_subdivider.sd_q"].at(w.begin + 20 * Period), "011");
    EXPECT_NE(w["chip.u_subdivider.sd_q"].at(w.begin + 19 * Period), "011");
  }
}

// Frames of simulation lie between the first clock and the event: the copy is a late one.
TEST_F(CliTraceEventTest, FarFromTheBeginningTheWindowIsTheOneOfADirectTrace) {
  ASSERT_EQ(run({"--when", "frame == 62 && line == 3 && clock == 700", "--from", "60:-273", "--to",
                 "63:251", "--lines", "1"}),
            0)
      << said;
  Program direct(folder.path(), {"trace", "demo", "-o", "d.vcd", "--from", "62:2", "--to", "62:4"});
  EXPECT_EQ(direct.wait(), 0);
  expect_in(wave(), Wave(folder / "d.vcd"));
}

TEST_F(CliTraceEventTest, WhatNeverIsTrueIsSaidAndLeavesNothing) {
  EXPECT_EQ(run({"--when", "u_subdivider.sd_q == 7", "--from", "0:-240", "--to", "0:-230"}), 2);
  EXPECT_THAT(said, HasSubstr("nothing of --when 'u_subdivider.sd_q == 7' from 0:-240 to 0:-230"));
  EXPECT_EQ(run({"--record", "3", "--from", "0:-240", "--to", "0:-230"}), 0);
  EXPECT_THAT(said, HasSubstr("nothing happened from 0:-240 to 0:-230; nothing is written"));
  EXPECT_EQ(run({"--around", "mismatch", "--to", "0:-260", "--use", "stacks=lockstep"}), 0);
  EXPECT_THAT(said, HasSubstr("nothing happened"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(CliTraceEventTest, AMismatchIsSeenInTheClockThatIsTold) {
  write_faulty("subdivider", "if (sd_q != Full) sd_d =", "sd_d =");
  Program verify(folder.path(), {"verify", "subdivider=subdivider.sv", "--random", "0"});
  EXPECT_EQ(verify.wait(), 1);
  const std::string command =
      "racebeam trace demo --from 0:-273 --use subdivider=lockstep:subdivider.sv --around mismatch "
      "-o subdivider_mismatch.vcd";
  EXPECT_THAT(verify.err(), HasSubstr("all signals: " + command));
  ASSERT_EQ(run({"--from", "0:-273", "--use", "subdivider=lockstep:subdivider.sv", "--around",
                 "mismatch"}),
            1);
  EXPECT_THAT(said, HasSubstr("subdivider.sd_o differs in frame 0, line "));
  const Wave w = wave();
  const auto &model = w["chip.u_subdivider.sd_o"], &rtl = w["chip.u_subdivider.rtl.sd_o"];
  std::uint64_t first = w.end;
  for (const auto& [time, value] : rtl.changes)
    if (model.at(time) != value) first = std::min(first, time);
  ASSERT_LT(first, w.end);
  EXPECT_THAT(said, HasSubstr(told(point_at(static_cast<std::int64_t>(first) / Period, raster))));
}

/// The recorder runs for a while, and is then sent a signal.
class CliTraceRecordTest : public CliTraceEventTest, public testing::WithParamInterface<int> {};

TEST_P(CliTraceRecordTest, AnEndThatNobodyExpectedKeepsTheLastLines) {
  const int number = GetParam();
  Program program(folder.path(), {"trace", "demo", "-o", "t.vcd", "--record", "5", "--from",
                                  "7000:-273", "--to", "7900:251"});
  ASSERT_TRUE(eventually([&] { return program.children() == 2; })) << "it has left copies behind";
  program.signal(number);
  EXPECT_EQ(program.wait(), number == SIGINT ? 130 : -number);
  const Wave w = wave();
  EXPECT_EQ(clocks(w), 5 * raster.line_clocks()) << program.err();
  const TracePoint first = point_at(first_clock(w), raster),
                   last = point_at(first_clock(w) + clocks(w) - 1, raster);
  EXPECT_THAT(program.err(),
              HasSubstr((number == SIGINT ? "stopped after " : "crashed after ") + told(last)));
  Program direct(folder.path(), {"trace", "demo", "-o", "d.vcd", "--from", argument(first), "--to",
                                 argument(last)});
  ASSERT_EQ(direct.wait(), 0) << direct.err();
  expect_in(w, Wave(folder / "d.vcd"));
}

INSTANTIATE_TEST_SUITE_P(Signals, CliTraceRecordTest, testing::Values(SIGINT, SIGSEGV, SIGABRT),
                         [](const auto& number) {
                           return std::string(number.param == SIGINT    ? "CtrlC"
                                              : number.param == SIGSEGV ? "Crash"
                                                                        : "Abort");
                         });

// $fatal is no signal: Verilator throws.
TEST_F(CliTraceEventTest, RtlThatEndsTheSimulationIsACrash) {
  write_faulty("subdivider", "endmodule",
               "  int unsigned clocks_q = 0;\n"
               "  always_ff @(posedge clk_i) clocks_q <= clocks_q + 1;\n"
               "  always_ff @(posedge clk_i) if (clocks_q == 900000) $fatal(1, \"enough\");\n"
               "endmodule");
  EXPECT_EQ(run({"--use", "subdivider=subdivider.sv", "--record", "2", "--to", "3:0"}), 2);
  EXPECT_THAT(said, HasSubstr("the RTL of subdivider has ended the simulation in clock 900000: "));
  EXPECT_THAT(said, testing::ContainsRegex("subdivider.sv:[0-9]+: error: enough"));
  const Wave w = wave();
  EXPECT_EQ(clocks(w), 2 * raster.line_clocks());
  EXPECT_THAT(said,
              HasSubstr("crashed after " + told(point_at(first_clock(w) + clocks(w) - 1, raster))));
  EXPECT_EQ(w["chip.u_subdivider.clocks_q"].number(w.end - 1), 900000u);
}

TEST_F(CliTraceEventTest, OfTwoEventsTheEarlierCounts) {
  write_faulty("subdivider", "if (sd_q != Full) sd_d =", "sd_d =");
  const auto with = [&](const char* condition, const char* from) {
    return std::vector<std::string>{
        "--use", "subdivider=lockstep:subdivider.sv", "--when", condition, "--from", from, "--pre",
        "1"};
  };
  EXPECT_EQ(run(with("line == -256 && clock == 1500", "0:-273")), 1);
  EXPECT_THAT(said, HasSubstr("subdivider.sd_o differs in frame 0, line -256, clock 111"));
  EXPECT_EQ(run(with("line == -256 && clock == 110", "0:-273")), 0);
  EXPECT_THAT(said, HasSubstr("--when holds in frame 0, line -256, clock 110"));
  EXPECT_EQ(run(with("line == -256 && clock == 250", "0:-256:200")), 1);
  EXPECT_THAT(said, Not(HasSubstr("clock 111"))) << "it was before --from";
}

TEST_F(CliTraceEventTest, MistakesEndWithTwoAndSayWhatToDo) {
  const auto refused = [&](const std::vector<std::string>& more, const char* words) {
    EXPECT_EQ(run(more), 2);
    EXPECT_THAT(said, HasSubstr(words));
  };
  refused({"--around", "mismatch"}, "compares nothing; add --use UNIT=lockstep");
  refused({"--around", "first-restart", "--when", "line == 3"}, "give one");
  refused({"--around", "mismatch", "--record", "3"}, "leave out --around, or --record");
  refused({"--record", "-1"}, "--record -1 is out of range; 0..5250");
  refused({"--when", "line == 3", "--pre", "-1"}, "--pre -1 is out of range");
  refused({"--from", "0:0", "--to", "0:1", "--post", "3"}, "--pre and --post are clocks around");
  refused({"--record", "3", "--pre", "3"}, "leave out --pre");
  refused({"--use", "stacks=lockstep:none.sv", "--around", "mismatch"}, "none.sv");
  refused({"--when", "u_stack.tag_i == 3"}, "did you mean");
  refused({"--when", "line == 3", "--scope", "nosuch"}, "no signal is under");
  refused({"--record", "1", "--picture", "p.svg"}, "more than 400 clocks");
  Program nowhere(folder.path(), {"trace", "demo", "-o", "none/t.vcd", "--when", "line == 3"});
  EXPECT_EQ(nowhere.wait(), 2);
  EXPECT_THAT(nowhere.err(), HasSubstr("cannot write none/t.vcd"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace racebeam
