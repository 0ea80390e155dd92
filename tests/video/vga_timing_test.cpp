// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/video/vga_timing.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {
namespace {

/// One clock of a line.
struct LineClock {
  int h_pos;
  bool last;  // last clock of its pixel
};

/// The clocks of a line: every pixel takes `clocks_per_pixel`, a fast one takes one (contract 6).
std::vector<LineClock> line_clocks(int speed, int clocks_per_pixel) {
  static const std::vector<int> fast[3] = {{7, 15}, {5, 9, 11, 13}, {6, 8, 10}};
  std::vector<LineClock> line;
  for (int h_pos = -480; h_pos <= 319; ++h_pos) {
    int clocks = clocks_per_pixel;
    for (int pin = 0; pin < 3; ++pin)
      for (const int low : fast[pin])
        if ((speed >> pin & 1) && (h_pos & 15) == low) clocks = 1;
    for (int n = 1; n <= clocks; ++n) line.push_back({h_pos, n == clocks});
  }
  return line;
}

constexpr int Pins = 11;
using Levels = std::array<int, Pins>;
const char* const PinNames[Pins] = {"x2_o",           "y_o",         "hsync_no",  "vsync_no",
                                    "active_o",       "h_active_o",  "consume_o", "line_end_o",
                                    "active_start_o", "frame_end_o", "nav_line_o"};

/// All outputs in one clock of line `y` (contract 5.1, 5.2 and the table of 6).
Levels expected(int y, const LineClock& c) {
  const bool sync = c.h_pos >= -464 && c.h_pos <= -369;
  const bool h_active = c.h_pos >= -320;
  const bool visible_row = y >= -240 && y <= 239;
  const bool after_sync = c.h_pos > -369;
  const bool vsync = (y == 250 && after_sync) || y == 251 || (y == -273 && !after_sync);
  const bool line_end = c.h_pos == 319 && c.last;
  return {2 * c.h_pos + c.last,
          y,
          !sync,
          !vsync,
          h_active && visible_row,
          h_active,
          h_active && c.last,
          line_end,
          c.h_pos == -321 && c.last,
          line_end && y == 251,
          y == 251};
}

template <class Unit>
class VgaTimingKnobTest : public testing::Test {
 protected:
  void build(int clocks_per_pixel) {
    unit.emplace("dut", clocks_per_pixel);
    bench.emplace(*unit);
    for (int n = 0; n < Pins; ++n) pins[n] = &(*bench)[PinNames[n]];
    // The first clock with rst_ni = 1 is c = 0 of y = -273 (contract 5.3).
    bench->clock(2);
    pin("rst_ni").drive(1);
    bench->settle();
  }

  UnitBench::Pin& pin(const char* name) { return (*bench)[name]; }

  void speed(int pins) {
    pin("speed_i").drive(pins);
    bench->settle();
  }

  Levels levels() const {
    Levels now;
    for (int n = 0; n < Pins; ++n) now[n] = n < 2 ? pins[n]->signed_value() : pins[n]->value();
    return now;
  }

  /// Compares whole lines, from the start of line `y` on.
  void check_lines(int y, int lines, const std::vector<LineClock>& line, bool check_x2 = true) {
    for (int n = 0; n < lines; ++n, y = y == 251 ? -273 : y + 1)
      for (std::size_t c = 0; c < line.size(); ++c) {
        Levels want = expected(y, line[c]), got = levels();
        if (!check_x2) want[0] = got[0] = 0;
        ASSERT_EQ(got, want) << "y = " << y << ", c = " << c;
        bench->clock();
      }
  }

  /// Counts what happens in one whole frame, from its first clock on.
  void check_counts(int clocks) {
    int total = 0, line_ends = 0, consumed = 0, starts = 0, sync_low = 0;
    bool end = false;
    do {
      const Levels now = levels();
      ++total;
      sync_low += !now[3];
      consumed += now[6];
      line_ends += now[7];
      starts += now[8];
      end = now[9];
      bench->clock();
    } while (!end && total < 2'000'000);
    EXPECT_EQ(total, clocks);
    EXPECT_EQ(line_ends, 525);
    EXPECT_EQ(starts, 525);
    EXPECT_EQ(consumed, 525 * 640);
    EXPECT_EQ(sync_low, 2 * clocks / 525);
  }

  std::optional<Unit> unit;
  std::optional<UnitBench> bench;
  UnitBench::Pin* pins[Pins];
};

template <class Unit>
class VgaTimingTest : public VgaTimingKnobTest<Unit> {
 protected:
  VgaTimingTest() { this->build(2); }

  /// A whole frame and the start of the next, at one setting of the speed pins (contract 5.6).
  void check_speed(int pins, int frame_clocks) {
    const auto line = line_clocks(pins, 2);
    ASSERT_EQ(static_cast<int>(line.size()) * 525, frame_clocks);
    this->speed(pins);
    this->check_counts(frame_clocks);
    if (!this->HasFailure()) this->check_lines(-273, 525 + 2, line);
  }
};

struct rtl_vga_timing : own_rtl<vga_timing> {
  rtl_vga_timing(const char* name, int clocks_per_pixel) : own_rtl(name, with(clocks_per_pixel)) {}

 private:
  static knobs with(int clocks_per_pixel) {
    knobs k;
    k.clocks_per_pixel = clocks_per_pixel;
    return k;
  }
};

using Twins = testing::Types<vga_timing, rtl_vga_timing>;
TYPED_TEST_SUITE(VgaTimingTest, Twins);
TYPED_TEST_SUITE(VgaTimingKnobTest, Twins);

// Contract 6, micro-trace.
TYPED_TEST(VgaTimingTest, FirstLineFollowsTheMicroTrace) {
  auto& bench = *this->bench;
  int now = 0;
  const auto at = [&](int c, const char* pin) {
    if (c > now) bench.clock(c - now);
    now = c;
    return bench[pin].bits == 1 ? bench[pin].value() : bench[pin].signed_value();
  };
  EXPECT_EQ(at(0, "x2_o"), -960);
  EXPECT_EQ(at(0, "y_o"), -273);
  EXPECT_EQ(at(1, "x2_o"), -959);
  EXPECT_EQ(at(2, "x2_o"), -958);
  EXPECT_EQ(at(31, "hsync_no"), 1);
  EXPECT_EQ(at(32, "hsync_no"), 0);
  EXPECT_EQ(at(223, "hsync_no"), 0);
  EXPECT_EQ(at(224, "hsync_no"), 1);
  EXPECT_EQ(at(318, "active_start_o"), 0);
  EXPECT_EQ(at(319, "active_start_o"), 1);
  EXPECT_EQ(at(319, "h_active_o"), 0);
  EXPECT_EQ(at(320, "x2_o"), -640);
  EXPECT_EQ(at(320, "h_active_o"), 1);
  EXPECT_EQ(at(320, "active_start_o"), 0);
  EXPECT_EQ(at(320, "consume_o"), 0);
  EXPECT_EQ(at(321, "consume_o"), 1);
  EXPECT_EQ(at(1598, "line_end_o"), 0);
  EXPECT_EQ(at(1599, "x2_o"), 639);
  EXPECT_EQ(at(1599, "line_end_o"), 1);
  EXPECT_EQ(at(1600, "y_o"), -272);
  EXPECT_EQ(at(1600, "x2_o"), -960);
}

// Contract 5.6: clocks per frame; every output in every clock by contract 5.1, 5.2 and 6.
TYPED_TEST(VgaTimingTest, FrameAtSpeed0Takes840000Clocks) { this->check_speed(0, 840'000); }
TYPED_TEST(VgaTimingTest, FrameAtSpeed1Takes787500Clocks) { this->check_speed(1, 787'500); }
TYPED_TEST(VgaTimingTest, FrameAtSpeed2Takes735000Clocks) { this->check_speed(2, 735'000); }
TYPED_TEST(VgaTimingTest, FrameAtSpeed4Takes761250Clocks) { this->check_speed(4, 761'250); }
TYPED_TEST(VgaTimingTest, FrameAtSpeed7Takes603750Clocks) { this->check_speed(7, 603'750); }

// Contract 5.2: vsync is low from c = 224 of y = 250 to c = 223 of y = -273.
TYPED_TEST(VgaTimingTest, VsyncFallsAndRisesAtTheEndOfHsync) {
  auto& bench = *this->bench;
  const auto vsync = [&] { return bench["vsync_no"].value(); };
  bench.clock((250 + 273) * 1600 + 223);
  EXPECT_EQ(bench["y_o"].signed_value(), 250);
  EXPECT_EQ(vsync(), 1);
  bench.clock();
  EXPECT_EQ(vsync(), 0);
  bench.clock(2 * 1600 - 1);
  EXPECT_EQ(bench["y_o"].signed_value(), -273);
  EXPECT_EQ(vsync(), 0);
  bench.clock();
  EXPECT_EQ(vsync(), 1);
}

// Contract 6: `fast` is a function of the speed pins of the same clock.
TYPED_TEST(VgaTimingTest, SpeedPinsActWithinTheClock) {
  auto& bench = *this->bench;
  const auto consume = [&](int speed) {
    this->speed(speed);
    return bench["consume_o"].value();
  };
  bench.clock(320);
  for (int pixel = 0; pixel < 16; ++pixel) {  // h_pos[3:0] = pixel
    for (int speed = 0; speed < 8; ++speed) {
      const bool fast = (speed & 1 && (pixel == 7 || pixel == 15)) ||
                        (speed & 2 && (pixel == 5 || pixel == 9 || pixel == 11 || pixel == 13)) ||
                        (speed & 4 && (pixel == 6 || pixel == 8 || pixel == 10));
      EXPECT_EQ(consume(speed), fast) << "pixel " << pixel << ", speed " << speed;
      EXPECT_EQ(bench["x2_o"].signed_value(), 2 * (pixel - 320) + fast);
    }
    this->speed(0);
    bench.clock();
    for (const int speed : {0, 7}) EXPECT_EQ(consume(speed), 1);  // the second clock of a pixel
    this->speed(0);
    bench.clock();
  }
}

TYPED_TEST(VgaTimingTest, SpeedPinsCanBringTheEventsForward) {
  auto& bench = *this->bench;
  const auto event = [&](const char* name, int speed) {
    this->speed(speed);
    return bench[name].value();
  };
  bench.clock(318);  // first clock of h_pos = -321
  EXPECT_EQ(event("active_start_o", 0), 0);
  EXPECT_EQ(event("active_start_o", 1), 1);
  bench.clock();
  EXPECT_EQ(bench["x2_o"].signed_value(), -640);
  this->speed(0);
  bench.clock(1600 * 524 + 1278);  // first clock of the last pixel of the frame
  EXPECT_EQ(event("line_end_o", 0), 0);
  EXPECT_EQ(event("frame_end_o", 6), 0);
  EXPECT_EQ(event("frame_end_o", 1), 1);
  EXPECT_EQ(event("line_end_o", 1), 1);
  bench.clock();
  EXPECT_EQ(this->levels(), expected(-273, {-480, false}));
}

// Contract 5.3: everything but vs goes to the start of the frame.
TYPED_TEST(VgaTimingTest, ResetRestartsTheFrameButHoldsVsync) {
  auto& bench = *this->bench;
  bench.clock(5 * 1600 + 777);
  bench["rst_ni"].drive(0);
  bench.clock();
  bench["rst_ni"].drive(1);
  bench.settle();
  Levels first = expected(-273, {-480, false});
  first[3] = 1;  // was high when the reset came
  for (int c = 0; c < 224; ++c, bench.clock()) ASSERT_EQ(bench["vsync_no"].value(), 1) << c;
  bench["rst_ni"].drive(0);
  bench.clock();
  bench["rst_ni"].drive(1);
  bench.settle();
  EXPECT_EQ(this->levels(), first);
  bench.clock(1600);
  this->check_lines(-272, 3, line_clocks(0, 2));
}

// Knob clocks_per_pixel: a pixel takes that many clocks, a fast one still one. What x2 means is
// promised for 2 only.
TYPED_TEST(VgaTimingKnobTest, PixelsOfOneClock) {
  this->build(1);
  this->check_counts(420'000);
  this->check_lines(-273, 60, line_clocks(0, 1), false);
}

TYPED_TEST(VgaTimingKnobTest, PixelsOfThreeClocks) {
  this->build(3);
  this->check_counts(1'260'000);
  this->speed(7);
  this->check_lines(-273, 60, line_clocks(7, 3), false);
}

TYPED_TEST(VgaTimingKnobTest, PixelsOfEightClocks) {
  this->build(8);
  this->check_lines(-273, 60, line_clocks(0, 8), false);
}

}  // namespace
}  // namespace racebeam
