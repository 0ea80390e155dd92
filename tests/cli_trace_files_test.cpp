// `racebeam trace` through the command line: FST, save file, triggers, and two files compared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/cli_trace_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

using CliTraceFilesTest = CliTraceBench;

TEST_F(CliTraceFilesTest, AnFstHasTheChangesOfTheVcd) {
  const std::vector<std::string> window = {"--from", "60:0", "--to", "60:2"};
  const Wave vcd = trace(window);
  Program fst(folder.path(), {"trace", "demo", "-o", "t.fst", "--from", "60:0", "--to", "60:2"});
  ASSERT_EQ(fst.wait(), 0) << fst.err();
  const std::string back = "fst2vcd " + (folder / "t.fst") + " > " + (folder / "back.vcd");
  ASSERT_EQ(std::system(back.c_str()), 0);
  const Wave other(folder / "back.vcd");
  for (const auto& [path, signal] : vcd.signals)
    EXPECT_EQ(other[path].changes, signal.changes) << path;
  Program diff(folder.path(), {"trace", "--diff", "t.vcd", "back.vcd"});
  EXPECT_EQ(diff.wait(), 0) << diff.out();
}

TEST_F(CliTraceFilesTest, TheSaveFileShowsEverySignalInTheGroupOfItsUnit) {
  const Wave wave = trace({"--from", "60:0:0", "--to", "60:0:9"});
  std::istringstream save(read_file(folder / "t.gtkw"));
  std::string scope;
  std::set<std::string> shown;
  bool groups = false;
  for (std::string line; std::getline(save, line);) {
    if (line[0] == '-') {
      scope = line.substr(1);
      groups = true;
    }
    if (line[0] == '-' || line[0] == '@' || line[0] == '[') continue;
    if (scope == "overview") continue;  // shows some of them once more
    for (const auto& [path, signal] : wave.signals) {
      const std::string range =
          signal.bits > 1 ? "[" + std::to_string(signal.bits - 1) + ":0]" : "";
      if (line != path + range) continue;
      shown.insert(path);
      EXPECT_EQ(path.substr(0, path.rfind('.')), scope);
    }
  }
  EXPECT_TRUE(groups);
  EXPECT_EQ(shown.size(), wave.signals.size());
}

TEST_F(CliTraceFilesTest, DiffExplainsTheFirstDifference) {
  trace({"--from", "60:0", "--to", "60:3"}, "a.vcd");
  Program same(folder.path(), {"trace", "--diff", "a.vcd", "a.vcd"});
  EXPECT_EQ(same.wait(), 0);
  EXPECT_THAT(same.out(), HasSubstr("no difference"));
  std::string text = read_file(folder / "a.vcd");
  const auto line = "#" + std::to_string(ordinal(60, 1, 700) * Period + Period / 2) + "\n";
  const auto at = text.find(line);
  ASSERT_NE(at, std::string::npos);
  const auto variable = text.find(" idx2_q ");  // $var wire 10 CODE idx2_q
  const auto blank = text.rfind(' ', variable - 1);
  const std::string code = text.substr(blank + 1, variable - blank - 1);
  std::ofstream(folder / "c.vcd") << text.insert(at + line.size(), "b111 " + code + "\n");
  Program changed(folder.path(), {"trace", "--diff", "a.vcd", "c.vcd"});
  EXPECT_EQ(changed.wait(), 1);
  EXPECT_THAT(changed.out(), HasSubstr("(frame 60, line 1, clock 700): 1 signal\n"));
  EXPECT_THAT(changed.out(), HasSubstr("  chip.u_subdivider.idx2_q: "));
  EXPECT_THAT(changed.out(), HasSubstr("111 in c.vcd\n"));
}

TEST_F(CliTraceFilesTest, AroundShowsTheLinesOfItsTrigger) {
  const Wave wave = trace({"--around", "first-restart", "--from", "7223:-240", "--lines", "0"});
  EXPECT_EQ(wave.end - wave.begin, static_cast<std::uint64_t>(LineClocks) * Period);
  const auto& restart = wave["chip.restart"];
  bool seen = false;
  for (const auto& [time, value] : restart.changes)
    if (value == "1" && wave["chip.line_done"].at(time) == "0") {
      const std::string told =
          "frame 7223, line " +
          std::to_string(wrap_signed(static_cast<int>(wave["beam.line"].number(time)), 10)) +
          ", clock " + std::to_string(wave["beam.clock"].number(time)) + "\n";
      seen = seen || said.find(told) != std::string::npos;
    }
  EXPECT_TRUE(seen) << said;
}

// The frames of a render, in one file, without registers.
TEST_F(CliTraceFilesTest, RenderWritesTheWaveformOfItsFrames) {
  const auto render = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"render", "demo"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program run(folder.path(), arguments);
    const int code = run.wait();
    said = run.err();
    return code;
  };
  ASSERT_EQ(render({"--first", "60", "--frames", "2", "--vcd", "r.vcd", "-o", "with"}), 0) << said;
  EXPECT_THAT(said, HasSubstr("wrote 2 frames in with, r.vcd"));
  Program window(folder.path(),
                 {"trace", "demo", "-o", "t.vcd", "--from", "60:-273", "--to", "61:251"});
  ASSERT_EQ(window.wait(), 0) << window.err();
  EXPECT_TRUE(read_file(folder / "r.vcd") == read_file(folder / "t.vcd"));
  EXPECT_NE(read_file(folder / "r.gtkw"), "");
  ASSERT_EQ(render({"--first", "60", "--frames", "2", "-o", "without"}), 0) << said;
  EXPECT_TRUE(read_file(folder / "with/frame_0061.png") ==
              read_file(folder / "without/frame_0061.png"));
  const auto refused = [&](std::vector<std::string> more, const char* words) {
    more.insert(more.end(), {"--vcd", "x.vcd"});
    EXPECT_EQ(render(more), 2);
    EXPECT_THAT(said, HasSubstr(words));
    EXPECT_EQ(read_file(folder / "x.vcd"), "");
  };
  refused({"--level", "tlm"}, "leave out --level tlm");
  refused({"--frames", "4", "--jobs", "2"}, "leave out --every and --jobs");
  refused({"--golden", "trace4"}, "leave out --golden");
  refused({"--gif", "x.vcd"}, "rename x.vcd");
}

}  // namespace
}  // namespace racebeam
