// `racebeam trace --level tlm` through the command line: its transactions.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <random>
#include <thread>

#include "tb/monitor/vga_monitor.h"
#include "tests/cli/cli_trace_bench.h"
#include "tests/cli/traced_chip.h"
#include "tests/cli/transaction_account.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::StartsWith;

const char* const Paths[] = {"tlm.tracer.line",    "tlm.tracer.interval", "tlm.tracer.room",
                             "tlm.tracer.restart", "tlm.display.shown",   "tlm.display.line",
                             "tlm.display.frame"};

class CliTraceTlmTest : public CliTraceBench {
 protected:
  Wave trace(const std::string& level, std::vector<std::string> more,
             const std::string& scene = "demo") {
    more.insert(more.end(), {"--level", level});
    return CliTraceBench::trace(more, level + ".vcd", scene);
  }

  /// Compares the window, both ends in it, with the cores.
  TransactionAccount expect_the_cores(FrameClock from, FrameClock to, const knobs& k = {},
                                      const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"--from", from.text(), "--to", to.text()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Wave wave = trace("tlm", arguments);
    const int line_clocks = LinePixels * k.clocks_per_pixel;
    const std::int64_t start = FrameClock{from.frame, FirstLine, 0}.ordinal(line_clocks),
                       begin = from.ordinal(line_clocks) - start,
                       end = to.ordinal(line_clocks) - start + 1;
    const auto period = static_cast<std::uint64_t>(clock_period_ps(k.clocks_per_pixel));
    const std::uint64_t origin = static_cast<std::uint64_t>(start) * period;
    EXPECT_EQ(wave.scale, "1ps");
    EXPECT_EQ(wave.begin, origin + static_cast<std::uint64_t>(begin) * period);
    EXPECT_EQ(wave.end, origin + static_cast<std::uint64_t>(end) * period);
    TransactionAccount account(k, from.frame, begin, end);
    for (const char* path : Paths)
      EXPECT_EQ(wave[path].changes, account.changes(path, origin))
          << path << " from " << from.text() << " to " << to.text();
    return account;
  }
};

TEST_F(CliTraceTlmTest, TransactionsAreThoseOfTheCoresInRandomFrames) {
  std::minstd_rand random(11);
  for (int n = 0; n < 4; ++n) {
    const int frame = static_cast<int>(random() % (DemoFrames - 1));
    const auto account = expect_the_cores({frame, FirstLine, 0}, {frame, LastLine, 1599});
    EXPECT_EQ(account.count("tlm.tracer.line"), FrameLines);
    EXPECT_EQ(account.count("tlm.display.line"), VisibleRows);
    EXPECT_EQ(account.count("tlm.display.frame"), 1);
    EXPECT_GT(account.count("tlm.tracer.interval"), FrameLines);
  }
}

TEST_F(CliTraceTlmTest, TransactionsAreThoseOfTheCoresWhereItIsHard) {
  const auto starving = expect_the_cores({7223, -121, 0}, {7223, -60, 1599});
  EXPECT_GT(starving.count("tlm.tracer.restart"), 50);
  expect_the_cores({3900, -20, 0}, {3900, 20, 1599});  // the ray pattern
}

TEST_F(CliTraceTlmTest, AWindowCutsTransactionsAtBothEndsAndGoesOverFrames) {
  expect_the_cores({7223, 0, 700}, {7223, 0, 760});
  expect_the_cores({2303, 239, 801}, {2304, -239, 399});
  expect_the_cores({0, FirstLine, 0}, {0, FirstLine, 3});
}

TEST_F(CliTraceTlmTest, TransactionsFollowTheKnobs) {
  knobs k;
  k.clocks_per_pixel = 1;
  k.interval_stack_depth = 1;
  const auto hurried =
      expect_the_cores({1000, -240, 0}, {1000, -100, 799}, k,
                       {"--set", "clocks_per_pixel=1", "--set", "interval_stack_depth=1"});
  EXPECT_GT(hurried.count("tlm.tracer.restart"), 100);
}

/// Both levels on one time axis: a scene and a knob.
class TraceLevels : public CliTraceTlmTest,
                    public testing::WithParamInterface<std::pair<std::string, std::string>> {};

TEST_P(TraceLevels, TransactionsBeginAndEndWithTheSignalsOfTheWiredChip) {
  const auto [name, knob] = GetParam();
  const std::string scene = name == "demo" ? name : RACEBEAM_SOURCE_DIR "/scenes/" + name + ".toml";
  const std::vector<std::string> window = {"--from", "20:-30", "--to", "20:-27", "--set", knob};
  const Wave tlm = trace("tlm", window, scene), wires = trace("signal", window, scene);
  EXPECT_EQ(tlm.begin, wires.begin);
  EXPECT_EQ(tlm.end, wires.end);
  for (const char* same : {"beam.frame", "beam.line", "beam.part"})
    EXPECT_TRUE(tlm[same] == wires[same]) << same;
  const auto high = [&](const char* path, std::uint64_t t) { return wires[path].at(t) == "1"; };
  const Wave::Signal &interval = tlm["tlm.tracer.interval"], &room = tlm["tlm.tracer.room"];
  int taken = 0;
  for (std::uint64_t t = tlm.begin, period = clock_period_ps(2); t < tlm.end; t += period) {
    const bool takes =
        high("chip.emit", t) && high("chip.u_interval_fifo.ack_o", t) && !high("chip.line_done", t);
    const std::string now = interval.at(t), next = interval.at(t + period);
    const bool ends = now != "-" && now != next && now.find("not_taken") == std::string::npos;
    ASSERT_EQ(takes, ends) << now << " at " << t;
    taken += takes;
    if (room.at(t) != "-") {
      const auto number = wires["chip.u_decision_datapath.room_q"].number(t);
      ASSERT_THAT(room.at(t), StartsWith("room_" + std::to_string(number) + "_depth_"));
    }
    if (high("chip.consume", t)) {
      const int c = colour_of_pins(static_cast<std::uint8_t>(wires["chip.uo_o"].number(t)));
      ASSERT_EQ(tlm["tlm.display.shown"].at(t), TransactionAccount::rgb(c));
    }
  }
  EXPECT_GT(taken, 20);
}

INSTANTIATE_TEST_SUITE_P(Scenes, TraceLevels,
                         testing::Values(std::pair{"demo", "dithering=on"},
                                         std::pair{"demo", "speed=3"},
                                         std::pair{"house", "dithering=on"}),
                         [](const auto& info) {
                           std::string name = info.param.first + "_" + info.param.second;
                           std::replace(name.begin(), name.end(), '=', '_');
                           return name;
                         });

TEST_F(CliTraceTlmTest, AnFstHasTheChangesOfTheVcd) {
  const Wave vcd = trace("tlm", {"--from", "60:0", "--to", "60:20"});
  Program fst(folder.path(), {"trace", "demo", "--level", "tlm", "-o", "t.fst", "--from", "60:0",
                              "--to", "60:20"});
  ASSERT_EQ(fst.wait(), 0) << fst.err();
  const Wave other = read_back("t.fst");
  for (const auto& [path, signal] : vcd.signals)
    EXPECT_EQ(other[path].changes, signal.changes) << path;
}

TEST_F(CliTraceTlmTest, ScopeAndDepthChooseStreamsAndTheSaveFileShowsThem) {
  const std::vector<std::string> window = {"--from", "60:0", "--to", "60:0"};
  const auto streams = [&](std::vector<std::string> more) {
    more.insert(more.end(), window.begin(), window.end());
    std::vector<std::string> paths;
    for (const auto& [path, signal] : trace("tlm", more).signals)
      if (path.rfind("beam.", 0) != 0) paths.push_back(path);
    return paths;
  };
  EXPECT_THAT(streams({}), testing::UnorderedElementsAreArray(Paths));
  EXPECT_THAT(streams({"--depth", "2"}), testing::SizeIs(7));
  EXPECT_THAT(streams({"--scope", "tlm.tracer"}), testing::SizeIs(4));
  EXPECT_THAT(
      streams({"--scope", "*.line", "--scope", "*.shown"}),
      testing::UnorderedElementsAre("tlm.tracer.line", "tlm.display.line", "tlm.display.shown"));
  EXPECT_THAT(read_file(folder / "tlm.gtkw"), HasSubstr("\ntlm.display.shown\n"));
}

TEST_F(CliTraceTlmTest, AroundShowsTheLineOfItsTrigger) {
  const Wave wave =
      trace("tlm", {"--around", "first-restart", "--from", "7223:-240", "--lines", "0"});
  const auto period = static_cast<std::uint64_t>(clock_period_ps(2));
  EXPECT_EQ(wave.end - wave.begin, 1600 * period);
  bool seen = false;
  for (const auto& [time, text] : wave["tlm.tracer.restart"].changes)
    seen |= text != "-" && said.find("clock " + std::to_string((time - wave.begin) / period) +
                                     "\n") != std::string::npos;
  EXPECT_TRUE(seen) << said;
}

TEST_F(CliTraceTlmTest, RefusesWhatTheLevelDoesNotHave) {
  const auto refused = [&](std::vector<std::string> more, const std::string& words) {
    std::vector<std::string> all = {"trace", "demo", "-o", "t.vcd"};
    all.insert(all.end(), more.begin(), more.end());
    Program run(folder.path(), all);
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.err(), HasSubstr(words));
  };
  const std::vector<std::string> window = {"--from", "0:0", "--to", "0:0"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), window.begin(), window.end());
    return more;
  };
  refused(with({"--level", "tml"}), "unknown level 'tml'; did you mean 'tlm'?");
  refused(with({"--level", "tlm", "--use", "stacks=rtl"}), "leave out --level tlm, or --use");
  refused(with({"--level", "tlm", "--scope", "chip.u_stacks"}), "names look like tlm.tracer");
  refused(with({"--level", "tlm", "--depth", "1"}), "no signal is under");
  refused({"--level", "tlm"}, "say --from FRAME:LINE and --to FRAME:LINE");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST_F(CliTraceTlmTest, AnInterruptKeepsWholeFrames) {
  Program run(folder.path(), {"trace", "demo", "--level", "tlm", "-o", "t.vcd", "--from", "0:-273",
                              "--to", "12798:251"});
  const auto started = [&] {
    for (const auto& file : fs::directory_iterator(folder.path()))
      if (fs::file_size(file.path()) > 0) return true;
    return false;
  };
  for (int i = 0; i < 1000 && !started(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_THAT(run.err(), HasSubstr("stopped early"));
  const Wave wave(folder / "t.vcd");
  const auto frame_time = static_cast<std::uint64_t>(840000) * clock_period_ps(2);
  EXPECT_GE(wave.end, frame_time);
  EXPECT_EQ(wave.end % frame_time, 0u);
  EXPECT_EQ(wave["beam.frame"].changes.size(), wave.end / frame_time);
}

}  // namespace
}  // namespace racebeam
