// `racebeam trace --diff` through the command line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/cli_trace_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Arguments = std::vector<std::string>;

class CliTraceDiffTest : public CliTraceBench {
 protected:
  int diff(Arguments arguments) {
    arguments.insert(arguments.begin(), "trace");
    Program run(folder.path(), arguments);
    const int code = run.wait();
    out = run.out();
    said = run.err();
    return code;
  }
  /// A copy of a.vcd in which a signal of 10 bits has a value more in a clock.
  void write_changed(const std::string& name, const std::string& signal, const FrameClock& at,
                     const std::string& digits) {
    std::string text = read_file(folder / "a.vcd");
    const auto line =
        "#" + std::to_string(ordinal(at.frame, at.line, at.clock) * Period + Period / 2) + "\n";
    const auto time = text.find(line);
    ASSERT_NE(time, std::string::npos);
    const auto variable = text.find(" " + signal + " ");  // $var wire 10 CODE idx2_q
    const auto blank = text.rfind(' ', variable - 1);
    const std::string code = text.substr(blank + 1, variable - blank - 1);
    text.insert(time + line.size(), "b" + digits + " " + code + "\n");
    std::ofstream(folder / name) << text;
  }

  std::string out;
};

TEST_F(CliTraceDiffTest, ExplainsTheFirstDifferenceWithTheValuesOfGtkWave) {
  trace({"--from", "60:0", "--to", "60:3"}, "a.vcd");
  EXPECT_EQ(diff({"--diff", "a.vcd", "a.vcd"}), 0);
  EXPECT_THAT(out, HasSubstr("no difference"));
  write_changed("c.vcd", "idx2_q", {60, 1, 700}, "111");
  EXPECT_EQ(diff({"--diff", "a.vcd", "c.vcd"}), 1);
  EXPECT_THAT(out, HasSubstr("(frame 60, line 1, clock 700): 1 signal\n"));
  EXPECT_THAT(out, HasSubstr("  chip.u_subdivider.idx2_q: "));
  EXPECT_THAT(out, HasSubstr(" 7 in c.vcd\n"));
  write_changed("d.vcd", "line", {60, 1, 700}, "1011101111");
  EXPECT_EQ(diff({"--diff", "a.vcd", "d.vcd"}), 1);
  EXPECT_THAT(out, HasSubstr("  beam.line: 1 in a.vcd, -273 in d.vcd\n"));
}

TEST_F(CliTraceDiffTest, ScopeAndDepthChooseWhatIsCompared) {
  trace({"--from", "60:0", "--to", "60:1"}, "a.vcd");
  write_changed("c.vcd", "idx2_q", {60, 1, 700}, "111");
  EXPECT_EQ(diff({"--diff", "a.vcd", "c.vcd", "--scope", "chip.u_stacks"}), 0) << out;
  EXPECT_EQ(diff({"--diff", "a.vcd", "c.vcd", "--depth", "1"}), 0) << out;
  EXPECT_EQ(diff({"--diff", "a.vcd", "c.vcd", "--scope", "*.idx2_q"}), 1);
  EXPECT_EQ(diff({"--diff", "a.vcd", "c.vcd", "--scope", "nosuch"}), 2);
  EXPECT_THAT(said, HasSubstr("no signal in common, or none under --scope and --depth"));
}

TEST_F(CliTraceDiffTest, OfTwoWindowsTheCommonPartIsCompared) {
  trace({"--from", "60:0", "--to", "60:2"}, "a.vcd");
  trace({"--from", "60:1", "--to", "60:3"}, "b.vcd");
  EXPECT_EQ(diff({"--diff", "a.vcd", "b.vcd"}), 1) << "the windows differ";
  const auto time = [](int line) { return std::to_string(ordinal(60, line) * Period) + " ps"; };
  EXPECT_THAT(out, StartsWith("a.vcd begins at " + time(0) + ", b.vcd at " + time(1) +
                              ": compared from the later one on\none file ends at " + time(3) +
                              ", the other goes on: compared up to there\n"));
  EXPECT_THAT(out, HasSubstr("no difference"));
  EXPECT_THAT(out, Not(HasSubstr("unknown")));
  EXPECT_EQ(diff({"--diff", "a.vcd", "b.vcd", "--shared"}), 0) << out;
  trace({"--from", "60:5", "--to", "60:5"}, "c.vcd");
  EXPECT_EQ(diff({"--diff", "a.vcd", "c.vcd"}), 2);
  EXPECT_THAT(said, HasSubstr("no time in common"));
}

TEST_F(CliTraceDiffTest, RefusesWhatMeansNothingWithIt) {
  for (const Arguments& more : {Arguments{"demo"},
                                {"-o", "z.vcd"},
                                {"--from", "60:0"},
                                {"--to", "60:0"},
                                {"--lines", "1"},
                                {"--pre", "3"},
                                {"--around", "first-starved"},
                                {"--when", "line == 3"},
                                {"--record", "3"},
                                {"--level", "tlm"},
                                {"--picture", "z.svg"},
                                {"--set", "speed=2"},
                                {"--use", "all=rtl"}}) {
    Arguments arguments = {"--diff", "a.vcd", "b.vcd"};
    arguments.insert(more[0] == "demo" ? arguments.begin() : arguments.end(), more.begin(),
                     more.end());
    EXPECT_EQ(diff(arguments), 2);
    EXPECT_THAT(said, HasSubstr("only --shared, --scope and --depth")) << more[0];
  }
  EXPECT_EQ(diff({"demo", "-o", "z.vcd", "--from", "60:0", "--to", "60:0", "--shared"}), 2);
  EXPECT_THAT(said, HasSubstr("--shared is for the two files of --diff"));
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace racebeam
