// Promises of tb/wave/wave_picture.h, clocked_waves.h and signal_look.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/wave_picture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "tb/base/errors.h"
#include "tb/wave/signal_look.h"
#include "tb/wave/vcd_writer.h"
#include "tests/support/svg.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint64_t Period = 100, Begin = 5000;

std::string drawn(const std::string& vcd) {
  VcdReader reader(std::make_unique<std::istringstream>(vcd), "the dump");
  return wave_picture(read_waves(reader, [](const std::string&) { return true; }));
}

/// A waveform of some clocks from line 7 of frame 60, clock 10.
struct Dump {
  VcdWriter vcd;
  const int frame = vcd.add("beam", "frame", 14), line = vcd.add("beam", "line", 10),
            pixel = vcd.add("beam", "pixel", 11), clock = vcd.add("beam", "clock", 11),
            clk = vcd.add("beam", "clk_i", 1);

  void run(std::uint64_t clocks, const std::function<void(std::uint64_t, std::uint64_t)>& each) {
    for (std::uint64_t n = 0; n < clocks; ++n) {
      const std::uint64_t at = Begin + n * Period;
      vcd.change(at, clk, 1);
      vcd.change(at, frame, 60);
      vcd.change(at, line, 7 + (n + 10) / 1600);
      vcd.change(at, pixel, n / 2);
      vcd.change(at, clock, (n + 10) % 1600);
      each(at, n);
      vcd.change(at + Period / 2, clk, 0);
    }
    end = Begin + clocks * Period;
  }
  std::string svg() const { return drawn(vcd.text("by hand", end)); }
  Svg picture() const { return Svg(svg()); }

  std::uint64_t end = Begin;
};

std::string refused(const std::string& vcd) {
  try {
    drawn(vcd);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "taken";
}

TEST(WavePicture, EverySignalHasALaneUnderItsUnitButTheClockOne) {
  Dump dump;
  dump.vcd.alias("chip.u_stacks", "clk_i", dump.clk);
  const int tag = dump.vcd.add("chip.u_stacks", "tag_i", 9), top = dump.vcd.add("chip", "top", 1);
  dump.vcd.alias("chip.u_stacks", "top_o", top);
  dump.run(4, [&](auto at, auto n) {
    dump.vcd.change(at, tag, n);
    dump.vcd.change(at, top, n & 1);
  });
  const Svg svg = dump.picture();
  std::vector<std::string> paths, headings;
  for (const auto& lane : svg.lanes) {
    paths.push_back(lane.path);
    EXPECT_EQ(lane.name, lane.path.substr(lane.path.rfind('.') + 1));
  }
  for (const auto& text : svg.headings) headings.push_back(text.text);
  EXPECT_THAT(paths, ElementsAre("beam.clk_i", "beam.pixel", "chip.top", "chip.u_stacks.tag_i",
                                 "chip.u_stacks.top_o"));
  EXPECT_THAT(headings, ElementsAre("beam", "chip", "u_stacks"));
  for (std::size_t n = 1; n < svg.lanes.size(); ++n)
    EXPECT_GE(svg.lanes[n].y, svg.lanes[n - 1].y + 20) << "lanes overlap";
  EXPECT_GT(svg.height, svg.lanes.back().y + 20);
  EXPECT_EQ(svg["chip.u_stacks.tag_i"].role, "input");
  EXPECT_EQ(svg["chip.u_stacks.top_o"].role, "output");
}

TEST(WavePicture, ValuesStandOncePerRunInTheFormatOfTheirName) {
  Dump dump;
  const int i1 = dump.vcd.add("chip", "i1_q", 10), dr1 = dump.vcd.add("chip", "dr1_x", 13),
            tag = dump.vcd.add("chip", "tag", 9), state = dump.vcd.add("chip", "state", 2),
            word = dump.vcd.add_text("chip", "state_q_name");
  dump.run(6, [&](auto at, auto n) {
    dump.vcd.change(at, i1, n < 3 ? 306 : 639);
    dump.vcd.change(at, dr1, n < 2 ? 0x1fff : n < 4 ? 0x1000 : 4095);
    dump.vcd.change(at, tag, 0x1e + n / 3);
    dump.vcd.change(at, state, n / 2);
    dump.vcd.change(at, word, std::string(n < 3 ? "left & right" : "<up>"));
  });
  const Svg svg = dump.picture();
  EXPECT_THAT(svg["chip.i1_q"].values(), ElementsAre("306", "639"));
  EXPECT_THAT(svg["chip.dr1_x"].values(), ElementsAre("-1", "-4096", "4095"));
  EXPECT_THAT(svg["chip.tag"].values(), ElementsAre("0x01e", "0x01f"));
  EXPECT_THAT(svg["chip.state"].values(), ElementsAre("0", "1", "2"));
  EXPECT_THAT(svg["chip.state_q_name"].values(), ElementsAre("left_&_right", "<up>"));
}

TEST(WavePicture, AValueThatTheDumpRepeatsStandsOnce) {
  const Svg svg(
      drawn("$var wire 1 ! clk_i $end $var wire 2 \" a [1:0] $end $enddefinitions $end\n"
            "#0\n1!\nb10 \"\n#5\n0!\n#10\n1!\nb10 \"\n#15\n0!\n#20\n1!\nb11 \"\n#30\n"));
  EXPECT_THAT(svg["a"].values(), ElementsAre("2", "3"));
}

TEST(WavePicture, EdgesBeginAtTheLinesOfTheirClocks) {
  Dump dump;
  const int bit = dump.vcd.add("chip", "emit", 1), bus = dump.vcd.add("chip", "fill", 4);
  dump.run(8, [&](auto at, auto n) {
    dump.vcd.change(at, bit, n == 3 || n == 4);
    dump.vcd.change(at, bus, n < 6 ? 9 : 10);
  });
  const Svg svg = dump.picture();
  ASSERT_EQ(svg.grid.size(), 8u);
  const double clock = svg.grid[1] - svg.grid[0];
  for (std::size_t n = 1; n < 8; ++n) EXPECT_NEAR(svg.grid[n] - svg.grid[n - 1], clock, 0.02);
  // A line to the rising edge, its slope, to the falling one, its slope, to the end.
  const auto& bends = svg["chip.emit"].level_xs;
  ASSERT_EQ(bends.size(), 6u);
  EXPECT_DOUBLE_EQ(bends[0], svg.grid[0]);
  EXPECT_DOUBLE_EQ(bends[1], svg.grid[3]);
  EXPECT_DOUBLE_EQ(bends[2], bends[1] + 4);
  EXPECT_DOUBLE_EQ(bends[3], svg.grid[5]);
  EXPECT_NEAR(bends[5], svg.grid[7] + clock, 0.02);
  EXPECT_DOUBLE_EQ(svg["chip.fill"].buses[0].xs[0], svg.grid[6]);
  EXPECT_EQ(svg["beam.clk_i"].level_xs.size(), 2u * 16) << "up and down in each clock";
  EXPECT_NEAR(svg["beam.clk_i"].level_xs[1], svg.grid[0] + clock / 2, 0.02);
}

TEST(WavePicture, ALaneIsHatchedUntilItsFirstChange) {
  Dump dump;
  const int bit = dump.vcd.add("chip", "late", 1), bus = dump.vcd.add("chip", "tag", 9);
  dump.vcd.add("chip", "never", 3);
  dump.run(5, [&](auto at, auto n) {
    if (n >= 2) dump.vcd.change(at, bit, 1);
    if (n >= 3) dump.vcd.change(at, bus, 5);
  });
  const Svg svg = dump.picture();
  EXPECT_THAT(svg["chip.late"].unknown, ElementsAre(svg.grid[0]));
  EXPECT_DOUBLE_EQ(svg["chip.late"].level_xs[0], svg.grid[2]);
  EXPECT_THAT(svg["chip.tag"].unknown, ElementsAre(svg.grid[0]));
  EXPECT_THAT(svg["chip.tag"].values(), ElementsAre("0x005"));
  EXPECT_THAT(svg["chip.never"].unknown, ElementsAre(svg.grid[0]));
  EXPECT_TRUE(svg["chip.never"].buses.empty());
}

TEST(WavePicture, NoTextLeavesItsShapeOrMeetsAnother) {
  Dump dump;
  const int wide = dump.vcd.add("chip", "colours", 24), words = dump.vcd.add_text("chip", "words");
  dump.run(400, [&](auto at, auto n) {
    dump.vcd.change(at, wide, n / (1 + n % 7) * 777);
    dump.vcd.change(at, words, std::string(1 + n % 9, 'w'));
  });
  constexpr double Character = 11 * 0.602;  // DejaVu Sans Mono
  const Svg svg = dump.picture();
  int inside = 0, outside = 0;
  for (const auto& lane : svg.lanes)
    for (const auto& bus : lane.buses) {
      const auto [left, right] = std::minmax_element(bus.xs.begin(), bus.xs.end());
      const double half = static_cast<double>(bus.value.size()) * Character / 2;
      ++(bus.in_title ? outside : inside);
      if (bus.in_title) continue;
      EXPECT_GT(bus.text_x - half, *left + 2) << bus.value;
      EXPECT_LT(bus.text_x + half, *right - 2) << bus.value;
    }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100) << "in titles";
  ASSERT_GE(svg.clocks.size(), 80u);
  for (std::size_t n = 1; n < svg.clocks.size(); ++n)
    EXPECT_GT(svg.clocks[n].x - svg.clocks[n - 1].x, 4 * Character + 4);
}

TEST(WavePicture, TheRulerSaysWhereFramesAndLinesBegin) {
  Dump dump;
  const int bit = dump.vcd.add("chip", "emit", 1);
  dump.run(4, [&](auto at, auto n) {
    dump.vcd.change(at, dump.line, n < 2 ? 1023 : 0);  // -1, 0
    dump.vcd.change(at, bit, 0);
  });
  const Svg svg = dump.picture();
  ASSERT_EQ(svg.places.size(), 2u);
  EXPECT_EQ(svg.places[0].text, "frame 60, line -1");
  EXPECT_EQ(svg.places[1].text, "frame 60, line 0");
  EXPECT_LT(svg.places[0].x, svg.grid[2]) << "left of the line that begins too soon for it";
  EXPECT_GT(svg.places[1].x, svg.grid[2]);
  EXPECT_EQ(svg.clocks.at(3).text, "13");
  EXPECT_NEAR(svg.clocks[3].x, (svg.grid[3] + svg.grid[3] + svg.grid[1] - svg.grid[0]) / 2, 0.02);
}

TEST(WavePicture, AWaveformOfVerifyIsDrawnWithItsClocks) {
  VcdWriter vcd;
  const int clk = vcd.add("chip", "clk_i", 1), clock = vcd.add("chip", "clock", 64),
            tag = vcd.add("rtl.u_stacks", "tag_o", 9);
  for (std::uint64_t n = 0; n < 3; ++n) {
    vcd.change(n * Period, clk, 1);
    vcd.change(n * Period, clock, 900 + n);
    vcd.change(n * Period, tag, n);
    vcd.change(n * Period + Period / 2, clk, 0);
  }
  const Svg svg(drawn(vcd.text("", 3 * Period)));
  EXPECT_EQ(svg.clocks.at(2).text, "902");
  EXPECT_THAT(svg["rtl.u_stacks.tag_o"].values(), ElementsAre("0x000", "0x001", "0x002"));
  EXPECT_TRUE(svg.places.empty());
}

TEST(WavePicture, NothingIsLoadedAndNothingRuns) {
  Dump dump;
  const int bit = dump.vcd.add("chip", "emit", 1);
  dump.run(2, [&](auto at, auto) { dump.vcd.change(at, bit, 0); });
  const std::string text = dump.svg();
  for (const char* word : {"href", "script", "@import", "font-face"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  EXPECT_THAT(text, HasSubstr("<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"));
  EXPECT_EQ(text.find("url("), text.find("url(#unknown)"));
}

TEST(WavePicture, RefusesWhatNobodyCouldReadAndSaysWhatToDo) {
  const std::string end = "$enddefinitions $end\n#0\n";
  EXPECT_THAT(refused("$var wire 1 ! a $end\n" + end), HasSubstr("no signal is called clk_i"));
  EXPECT_THAT(refused("$var wire 1 ! clk_i $end\n" + end), HasSubstr("--scope"));
  EXPECT_THAT(refused("$var wire 1 ! clk_i $end\n$var wire 1 \" a $end\n" + end + "1!\n"),
              HasSubstr("a whole clock"));
  Dump fits, longer;
  longer.vcd.add("chip", "a", 1);
  longer.run(401, [](auto, auto) {});
  EXPECT_THAT(refused(longer.vcd.text("", longer.end)), HasSubstr("--from FRAME:LINE:CLOCK"));
  for (int n = 0; n < MostPictureLanes - 2; ++n) fits.vcd.add("chip", "a" + std::to_string(n), 1);
  Dump more = fits;
  fits.run(400, [](auto, auto) {});
  EXPECT_EQ(refused(fits.vcd.text("", fits.end)), "taken");
  more.vcd.add("chip", "b", 1);
  more.run(1, [](auto, auto) {});
  EXPECT_THAT(refused(more.vcd.text("", more.end)), HasSubstr("101 signals cannot be read"));
}

}  // namespace
}  // namespace racebeam
