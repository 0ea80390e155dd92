// `racebeam trace` through the command line: FST, save file, and triggers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tb/wave/trace_size.h"
#include "tests/cli/cli_trace_bench.h"
#include "tests/cli/x_server.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

using CliTraceFilesTest = CliTraceBench;

TEST_F(CliTraceFilesTest, AnFstHasTheChangesOfTheVcd) {
  const std::vector<std::string> window = {"--from", "60:0", "--to", "60:2"};
  const Wave vcd = trace(window);
  Program fst(folder.path(), {"trace", "demo", "-o", "t.fst", "--from", "60:0", "--to", "60:2"});
  ASSERT_EQ(fst.wait(), 0) << fst.err();
  const Wave other = read_back("t.fst");
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

// Whoever estimates by a factor of two has seen what he is in for.
TEST_F(CliTraceFilesTest, TheSizeThatIsSaidOfALongWindowIsThatOfTheFile) {
  const auto expect = [&](std::vector<std::string> more, const char* from, const char* to,
                          bool overview) {
    more.insert(more.end(), {"--from", from, "--to", to});
    const Wave wave = trace(more);
    const auto clocks = static_cast<std::int64_t>((wave.end - wave.begin) / Period);
    const auto expected = overview || more[0] != "--level"
                              ? TraceSize::of_signals(clocks, 0, wave.codes(), overview).bytes
                              : TraceSize::of_transactions(clocks).bytes;
    const auto real = static_cast<double>(std::filesystem::file_size(folder / "t.vcd"));
    EXPECT_GT(expected, real / 2) << more[0] << " from " << from;
    EXPECT_LT(expected, real * 2) << more[0] << " from " << from;
  };
  expect({"--depth", "0"}, "7223:-240", "7223:-235", false);
  expect({"--depth", "0"}, "60:0", "60:5", false);
  expect({"--scope", "chip.u_subdivider"}, "7223:-240", "7223:-235", false);
  expect({"--scope", "*_q"}, "1000:0", "1000:5", false);
  expect({"--depth", "0"}, "7223:-240", "7223:-140", true);
  expect({"--level", "tlm"}, "60:-273", "61:251", false);
  expect({"--level", "tlm"}, "7223:-273", "7223:251", false);
}

TEST_F(CliTraceFilesTest, SaysSizeAndTimeOfALongWindowBeforeItsFirstClock) {
  Program run(folder.path(), {"trace", "demo", "-o", "t.vcd", "--from", "0:0", "--to", "400:0"});
  ASSERT_TRUE(eventually([&] { return folder.files() > 0; }));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_THAT(run.err(), testing::StartsWith("racebeam: about 21 GB and 5 minutes; as FST about "
                                             "1.1 GB\n"));
}

TEST_F(CliTraceFilesTest, SaysThatALongWindowDoesNotFit) {
  EXPECT_EQ(TraceSize({3e15, 1}).text("t.vcd"), "about 3000 TB and 1 second; as FST about 150 TB");
  EXPECT_EQ(TraceSize({2e9, 600}).text("t.fst"),
            "about 100 MB and 11 minutes, made of 2.0 GB of VCD");
  EXPECT_EQ(TraceSize({1e9, 1}).room_text("t.vcd", 2e9), "");
  EXPECT_EQ(TraceSize({1e9, 1}).room_text("t.fst", 1.01e9),
            "it will not fit: 1.0 GB are free there, and it takes 1.1 GB");
}

TEST_F(CliTraceFilesTest, OfAShortWindowNothingIsSaidBefore) {
  trace({"--from", "60:0", "--to", "60:10"});
  EXPECT_THAT(said, testing::StartsWith("racebeam: wrote t.vcd"));
}

// GTKWave writes its own first line, whatever name it saves under.
TEST_F(CliTraceFilesTest, TheUsersOwnSaveFileIsKept) {
  const std::vector<std::string> clock = {"--from", "60:0:0", "--to", "60:0:0"};
  trace(clock);
  EXPECT_EQ(said.find("kept"), std::string::npos);
  const std::string ours = read_file(folder / "t.gtkw");
  EXPECT_THAT(ours, testing::StartsWith("[*] racebeam\n"));
  std::ofstream(folder / "t.gtkw") << ours << "old";
  trace(clock);
  EXPECT_EQ(read_file(folder / "t.gtkw"), ours);
  const std::string theirs = "[*]\n[*] GTKWave Analyzer v3.3.104 (w)1999-2020 BSI\n";
  std::ofstream(folder / "t.gtkw") << theirs;
  trace(clock);
  EXPECT_EQ(read_file(folder / "t.gtkw"), theirs);
  EXPECT_THAT(said, HasSubstr("kept t.gtkw, which is not ours; remove it to get a new one\n"));
  EXPECT_THAT(said, HasSubstr("wrote t.vcd: "));
}

TEST_F(CliTraceFilesTest, WithoutPlaceForTheSaveFileThereIsNoWaveform) {
  std::filesystem::create_directory(folder / "t.gtkw");
  for (const char* file : {"t.vcd", "t.fst"}) {
    Program run(folder.path(), {"trace", "demo", "-o", file, "--from", "60:0:0", "--to", "60:0:0"});
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.err(), HasSubstr("cannot write t.gtkw: Is a directory"));
    EXPECT_EQ(folder.files(), 1);
  }
}

// The first Ctrl-C comes after the window, the second while vcd2fst is at work.
TEST_F(CliTraceFilesTest, CtrlCDoesNotStopVcd2fst) {
  std::filesystem::create_directory(folder / "bin");
  std::ofstream(folder / "bin/vcd2fst") << "#!/bin/sh\n: >begun\n"
                                           "while [ ! -e interrupted ]; do sleep 0.01; done\n"
                                           "PATH=${PATH#*:} exec vcd2fst \"$@\"\n";
  std::filesystem::permissions(folder / "bin/vcd2fst", std::filesystem::perms::owner_all);
  Program::Setting slow;
  slow.environment = "PATH=" + (folder / "bin") + ":" + std::getenv("PATH");
  slow.group = true;
  Program run(folder.path(), {"trace", "demo", "-o", "t.fst", "--from", "60:0:0", "--to", "60:0:9"},
              slow);
  for (int n = 0; n < 3000 && !std::filesystem::exists(folder / "begun"); ++n) usleep(10000);
  run.signal_group(SIGINT);
  usleep(20000);
  run.signal_group(SIGINT);
  std::ofstream(folder / "interrupted") << "";
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_GT(read_file(folder / "t.fst").size(), 100u);
}

TEST_F(CliTraceFilesTest, ExtensionsAreReadInBothCases) {
  const std::vector<std::string> clock = {"--from", "60:0:0", "--to", "60:0:0"};
  trace(clock);
  trace(clock, "c.VCD");
  EXPECT_EQ(read_file(folder / "c.VCD"), read_file(folder / "t.vcd"));
  Program fst(folder.path(),
              {"trace", "demo", "-o", "c.FST", "--from", "60:0:0", "--to", "60:0:0"});
  EXPECT_EQ(fst.wait(), 0) << fst.err();
  EXPECT_NE(read_file(folder / "c.FST").substr(0, 8), read_file(folder / "t.vcd").substr(0, 8));
  Program picture(folder.path(),
                  {"trace", "c.VCD", "--picture", "c.SVG", "--scope", "chip.u_stacks"});
  EXPECT_EQ(picture.wait(), 0) << picture.err();
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
