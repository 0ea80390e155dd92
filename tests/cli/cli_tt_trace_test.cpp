// `racebeam trace --tt` and `render --tt --vcd`: waveforms of a stranger's chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/cli/program.h"
#include "tests/cli/wave.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

const std::string Paddle = RACEBEAM_SOURCE_DIR "/tests/tt/paddle";
constexpr std::uint64_t Period = 39683;  // ps of 25.2 MHz
constexpr int LineClocks = 800;

class CliTtTraceTest : public testing::Test {
 protected:
  static Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void run(const Words& words, int code = 0) {
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), code) << program.err();
    err = program.err();
  }
  void trace(const Words& more, int code = 0) { run(with({"trace", "--tt", Paddle}, more), code); }
  void expect_refused(const Words& more, const std::string& text) {
    trace(more, 2);
    EXPECT_THAT(err, HasSubstr(text));
  }
  static std::uint64_t time_of(int frame, int line, int clock) {
    return ((frame * 525ULL + line + 273) * LineClocks + clock) * Period;
  }
  /// The pins of the chip at a place of the beam, computed anew.
  static int uo_at(int line, int clock, int left, int ui) {
    const int x = x_of(clock), y = y_of(line, clock);
    const bool visible = x < 640 && y < 480;
    const bool bar = visible && x >= left && x < left + 64;
    const bool now = visible && y < 256 && (ui & 4);
    const int hsync = !(x >= 656 && x < 752), vsync = !(y >= 490 && y < 492);
    const int blue = now || bar;
    return hsync << 7 | blue << 6 | bar << 5 | bar << 4 | vsync << 3 | blue << 2 | bar << 1 | bar;
  }
  static int x_of(int clock) { return (clock + 640) % LineClocks; }
  static int y_of(int line, int clock) { return (line + 240 - (clock < 160) + 525) % 525; }

  ScratchFolder folder;
  std::string err;
};

TEST_F(CliTtTraceTest, EveryClockOfAWindowHasTheChipsValues) {
  std::ofstream(folder / "in.csv") << "frame,line,clock,ui,uio\nreset,0,0,2,0\n"
                                      "3,-239,300,6,0\n3,-239,500,1,0\n";
  trace({"--inputs", "in.csv", "--from", "3:-242", "--to", "3:-238", "-o", "w.vcd"});
  EXPECT_THAT(err, HasSubstr("wrote w.vcd and w.gtkw"));
  const Wave wave(folder / "w.vcd");
  EXPECT_EQ(wave.begin, time_of(3, -242, 0));
  EXPECT_EQ(wave.end, time_of(3, -237, 0));
  for (int line = -242; line <= -238; ++line)
    for (int clock = 0; clock < LineClocks; ++clock) {
      const std::uint64_t at = time_of(3, line, clock);
      // The picture of frame 0 has moved once; the logic sees an input a clock after its change.
      const bool moved = line > -240 || (line == -240 && clock >= 160);
      const int left = 288 + 8 * (moved ? 4 : 3);
      const int since = (line + 239) * LineClocks + clock;
      const int ui = since > 500 ? 1 : since > 300 ? 6 : 2;
      const auto is = [&](const char* name, std::uint64_t value) {
        ASSERT_EQ(wave[name].number(at), value) << name << " at " << line << ":" << clock;
      };
      is("chip.uo_out", uo_at(line, clock, left, ui));
      is("chip.ui_in", ui);
      is("chip.uio_oe", 0x80);
      is("chip.left_q", left);
      is("chip.u_beam.x_q", x_of(clock));
      is("chip.u_beam.y_q", y_of(line, clock));
      is("beam.frame", 3);
      is("beam.line", line & 1023);
      is("beam.clock", clock);
      is("beam.clk_i", 1);
      ASSERT_EQ(wave["beam.clk_i"].number(at + Period / 2), 0u);
    }
  EXPECT_EQ(wave.code("chip.clk"), wave.code("beam.clk_i"));
  EXPECT_EQ(wave.code("chip.u_beam.clk"), wave.code("beam.clk_i"));
  EXPECT_THAT(read_file(folder / "w.gtkw"), HasSubstr("chip.u_beam.x_q[9:0]"));
}

TEST_F(CliTtTraceTest, ScopeDepthAndClocksChoose) {
  trace({"--from", "0:0:100", "--to", "0:0:109", "--scope", "chip.u_beam", "-o", "w.vcd"});
  const Wave beam(folder / "w.vcd");
  EXPECT_EQ(beam.begin, time_of(0, 0, 100));
  EXPECT_EQ(beam.end, time_of(0, 0, 110));
  EXPECT_EQ(beam.signals.count("chip.u_beam.x_q"), 1u);
  EXPECT_EQ(beam.signals.count("chip.left_q"), 0u);
  trace({"--from", "0:0:100", "--to", "0:0:109", "--depth", "1", "-o", "w.vcd"});
  const Wave top(folder / "w.vcd");
  EXPECT_EQ(top.signals.count("chip.u_beam.x_q"), 0u);
  EXPECT_EQ(top.signals.count("chip.left_q"), 1u);
  expect_refused({"--from", "0:0", "--to", "0:0", "--scope", "none", "-o", "w.vcd"},
                 "names look like chip.");
}

TEST_F(CliTtTraceTest, AConditionFindsItsClockAndTheWindowLiesAroundIt) {
  trace({"--ui", "1", "--when", "left_q == 272 && u_beam.x_q == 5", "--to", "9:0", "--pre", "3",
         "--post", "4", "-o", "w.vcd"});
  EXPECT_THAT(err, HasSubstr("--when: frame 1, line -240, clock 165"));
  const Wave wave(folder / "w.vcd");
  EXPECT_EQ(wave.begin, time_of(1, -240, 162));
  EXPECT_EQ(wave.end, time_of(1, -240, 170));
  EXPECT_EQ(wave["chip.left_q"].number(time_of(1, -240, 165)), 272u);
  expect_refused({"--when", "left_q == 1", "--to", "0:0", "-o", "w.vcd"}, "nothing of --when");
  expect_refused({"--when", "lefd_q == 1", "--to", "0:0", "-o", "w.vcd"}, "did you mean 'left_q'");
}

TEST_F(CliTtTraceTest, ALongWindowIsThePinsAlone) {
  trace({"--from", "0:-273", "--to", "0:251", "-o", "w.vcd"});
  EXPECT_THAT(err, HasSubstr("an overview: the chip's pins"));
  const Wave wave(folder / "w.vcd");
  EXPECT_EQ(wave.signals.count("chip.left_q"), 0u);
  EXPECT_EQ(wave["chip.uo_out"].number(time_of(0, 0, 160 + 300)), 0xffu);
}

TEST_F(CliTtTraceTest, RenderWritesThePinsOfItsFrames) {
  std::ofstream(folder / "in.csv") << "frame,line,clock,ui,uio\n1,0,5,4,0\n";
  run({"render", "--tt", Paddle, "--inputs", "in.csv", "--first", "1", "--frames", "2", "--vcd",
       "r.vcd"});
  EXPECT_THAT(err, HasSubstr("r.vcd"));
  trace({"--inputs", "in.csv", "--from", "1:-273", "--to", "2:251", "-o", "t.vcd"});
  EXPECT_TRUE(Wave(folder / "r.vcd").signals == Wave(folder / "t.vcd").signals);
  EXPECT_TRUE(fs::exists(folder / "r.gtkw"));
  EXPECT_FALSE(fs::exists(folder / "racebeam_out"));
  run({"render", "--tt", Paddle, "--frames", "2", "--every", "2", "--vcd", "r.vcd"}, 2);
  EXPECT_THAT(err, HasSubstr("--vcd needs consecutive frames"));
}

TEST_F(CliTtTraceTest, RefusesWhatItCannotDo) {
  const Words window = {"--from", "0:0", "--to", "0:0", "-o", "w.vcd"};
  for (const Words& words : {Words{"demo"},
                             {"--set", "speed=1"},
                             {"--use", "all=rtl"},
                             {"--level", "tlm"},
                             {"--record", "5"},
                             {"--around", "max-stack"}})
    expect_refused(with(words, window), "--tt runs a chip of its own; leave out ");
  expect_refused({"--from", "0:0", "--to", "0:0"}, "-o FILE.vcd");
  expect_refused({"--from", "-1:0", "--to", "0:0", "-o", "w.vcd"}, "frame -1 is out of range");
  expect_refused({"--from", "0:0", "--to", "0:252", "-o", "w.vcd"}, "line 252 is out of range");
  run(with({"trace", "demo", "--ui", "3"}, window), 2);
  EXPECT_THAT(err, HasSubstr("--tt"));
  EXPECT_FALSE(fs::exists(folder / "w.vcd"));
}

}  // namespace
}  // namespace racebeam
