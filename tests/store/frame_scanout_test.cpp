// Promises of sc/store/frame_scanout.h: every pixel of a frame, from words that the test packs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/frame_scanout.h"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <functional>
#include <optional>

#include "tb/monitor/raster.h"
#include "tb/twin/unit_bench.h"
#include "tests/store/store_twins.h"

namespace racebeam {
namespace {

using Colour = std::array<unsigned, 3>;  // at the DAC
constexpr Colour Black{0, 0, 0};

/// A byte of the channel `n` of a pixel; no two neighbours have the same.
unsigned sample(int column, int row, int n) {
  return static_cast<unsigned>(column * 7 + row * 31 + n * 85 + column / 8) & 0xff;
}
unsigned dac(unsigned byte) { return byte << 2 | byte >> 6; }

/// A word of light and colours of `bits` bits, and what the DAC gets.
struct LightFormat {
  int bits = 5;
  int column_bits = 9;  // of an address

  unsigned light(int column, int row) const { return (column + row) % 3 == 0; }
  unsigned part(int column, int row, int n) const { return sample(column, row, n) >> (8 - bits); }
  std::uint64_t word(unsigned address) const {
    const int row = static_cast<int>(address) >> column_bits;
    const int column = static_cast<int>(address) - (row << column_bits);
    std::uint64_t word = light(column, row);
    for (int n = 0; n < 3; ++n) word = word << bits | part(column, row, n);
    return word;
  }
  Colour shown(int column, int row) const {
    Colour colour;
    for (int n = 0; n < 3; ++n)
      colour[n] =
          part(column, row, n) << (10 - bits) | (light(column, row) ? (1u << (10 - bits)) - 1 : 0);
    return colour;
  }
};

/// A pixel a word, bytes.
std::uint64_t rgb888_word(unsigned address) {
  const int row = static_cast<int>(address >> 10), column = static_cast<int>(address & 1023);
  return sample(column, row, 0) << 16 | sample(column, row, 1) << 8 | sample(column, row, 2);
}

/// Eight pixels a word, three planes.
std::uint64_t planar_word(unsigned address, int width) {
  const int words = width / 8, line = static_cast<int>(address) / words;
  std::uint64_t word = 0;
  for (int n = 7; n >= 0; --n)
    word = word << 8 | sample(static_cast<int>(address) % words * 8 + n, line % 480, line / 480);
  return word;
}

Colour shown_bytes(int column, int row) {
  return {dac(sample(column, row, 0)), dac(sample(column, row, 1)), dac(sample(column, row, 2))};
}

template <class Unit>
class FrameScanoutTest : public testing::Test {
 protected:
  using Word = std::function<std::uint64_t(unsigned address)>;
  using Shown = std::function<Colour(int column, int row)>;

  void build(const store_knobs& k) {
    words = k.group_words();
    unit.emplace("dut", k);
    bench.emplace(*unit);
    bench->clock();
    pin("rst_ni").drive(1);
  }
  UnitBench::Pin& pin(const char* name) { return (*bench)[name]; }

  /// The pins of vga_timing in clock `c` of line `y`.
  void beam(const Raster& raster, int y, int c) {
    const RasterClock& clock = raster.clocks[c];
    const bool column = c >= raster.active_begin;
    const bool last = c + 1 == raster.line_clocks();
    pin("consume_i").drive(column && clock.last);
    pin("active_i").drive(column && raster.visible_line(y));
    pin("line_end_i").drive(last);
    pin("y_i").drive(static_cast<std::uint64_t>(y));
    pin("hsync_ni").drive(clock.hsync);
    pin("vsync_ni").drive(raster.vsync(c < raster.vsync_at ? y - 1 : y));
  }

  /// Lines of the raster with a memory behind them: every pin in every clock, and how often it
  /// reads. `word`: what the memory holds; `shown`: the visible pixels.
  void check(int clocks_per_pixel, int y, int lines, const Word& word, const Shown& shown) {
    const Raster raster(clocks_per_pixel);
    std::deque<std::array<unsigned, 5>> late;  // what the pins show in the clocks to come
    std::uint64_t memory = 0;
    for (const int end = y + lines; y < end; ++y)
      for (int c = 0; c < raster.line_clocks(); ++c) {
        beam(raster, y, c);
        pin("mem_data_i").drive(memory);
        bench->settle();
        const bool visible = c >= raster.active_begin && raster.visible_line(y);
        const Colour colour = visible ? shown(raster.clocks[c].position + 320, y + 240) : Black;
        late.push_back({colour[0], colour[1], colour[2],
                        static_cast<unsigned>(pin("hsync_ni").value()),
                        static_cast<unsigned>(pin("vsync_ni").value())});
        if (late.size() > words) {
          const std::array<unsigned, 5> now = {value("red_o"), value("green_o"), value("blue_o"),
                                               value("hsync_no"), value("vsync_no")};
          ASSERT_EQ(now, late.front()) << "y = " << y << ", c = " << c;
          late.pop_front();
        }
        const bool read = pin("read_o").value();
        reads += read;
        memory = read ? word(value("read_address_o")) : ~std::uint64_t{0} / 3 * (c & 3);
        bench->clock();
      }
  }
  unsigned value(const char* name) { return static_cast<unsigned>(pin(name).value()); }

  std::optional<Unit> unit;
  std::optional<UnitBench> bench;
  std::size_t words = 1;  // clocks from vga_timing to the pins
  std::uint64_t reads = 0;
};

using Twins = testing::Types<frame_scanout, own_store_rtl<frame_scanout>>;
TYPED_TEST_SUITE(FrameScanoutTest, Twins);

/// Black from a column on.
template <class Shown>
auto up_to(int width, const Shown& shown) {
  return
      [width, shown](int column, int row) { return column < width ? shown(column, row) : Black; };
}

TYPED_TEST(FrameScanoutTest, ShowsAWordAPixelOneClockLate) {
  this->build(rgb_light());
  const LightFormat format;
  this->check(
      1, -244, 10, [&](unsigned address) { return format.word(address); },
      up_to(512, [&](int column, int row) { return format.shown(column, row); }));
  EXPECT_EQ(this->reads, 6u * 512) << "once a pixel of the picture";
}

TYPED_TEST(FrameScanoutTest, LastRowsAndVsyncAreInPlace) {
  this->build(rgb_light());
  const LightFormat format;
  this->check(
      1, 236, 16, [&](unsigned address) { return format.word(address); },
      up_to(512, [&](int column, int row) { return format.shown(column, row); }));
  EXPECT_EQ(this->reads, 4u * 512);
}

TYPED_TEST(FrameScanoutTest, PixelsOfSeveralClocksAreReadOnce) {
  this->build(rgb_light());
  const LightFormat format;
  this->check(
      3, -242, 5, [&](unsigned address) { return format.word(address); },
      up_to(512, [&](int column, int row) { return format.shown(column, row); }));
  EXPECT_EQ(this->reads, 3u * 512);
}

TYPED_TEST(FrameScanoutTest, WrappingShowsTheLeftPartAgainOnTheRight) {
  this->build(wrapped());
  const LightFormat format{8};
  this->check(
      1, -241, 4, [&](unsigned address) { return format.word(address); },
      [&](int column, int row) { return format.shown(column % 512, row); });
  EXPECT_EQ(this->reads, 3u * 640);
}

TYPED_TEST(FrameScanoutTest, WordsOfAWidePictureFillTheWholeScreen) {
  this->build(wide_light());
  const LightFormat format{5, 10};
  this->check(
      1, -241, 4, [&](unsigned address) { return format.word(address); },
      [&](int column, int row) { return format.shown(column, row); });
  EXPECT_EQ(this->reads, 3u * 640);
}

TYPED_TEST(FrameScanoutTest, BytesOfAWordFillTheWholeScreen) {
  this->build(rgb888());
  this->check(2, -241, 4, rgb888_word, shown_bytes);
  EXPECT_EQ(this->reads, 3u * 640);
}

// It reads three words in the clocks of eight pixels.
TYPED_TEST(FrameScanoutTest, PlanesAreShownThreeClocksLate) {
  this->build(planar());
  this->check(
      2, -241, 5, [](unsigned address) { return planar_word(address, 640); }, shown_bytes);
  EXPECT_EQ(this->reads, 4u * 240);
}

TYPED_TEST(FrameScanoutTest, PlanesKeepUpWithPixelsOfOneClock) {
  this->build(planar());
  this->check(
      1, 236, 6, [](unsigned address) { return planar_word(address, 640); }, shown_bytes);
}

TYPED_TEST(FrameScanoutTest, NarrowPlanesAreBlackOnTheRight) {
  this->build(narrow_planar());
  this->check(
      2, -241, 3, [](unsigned address) { return planar_word(address, 512); },
      up_to(512, shown_bytes));
  EXPECT_EQ(this->reads, 2u * 192);
}

TYPED_TEST(FrameScanoutTest, ResetMakesItBlackAndStartsTheLine) {
  this->build(rgb_light());
  const LightFormat format;
  const auto word = [&](unsigned address) { return format.word(address); };
  this->check(1, 0, 1, word,
              up_to(512, [&](int column, int row) { return format.shown(column, row); }));
  const Raster raster(1);
  for (int c = 0; c < raster.active_begin + 100; ++c) {
    this->beam(raster, 1, c);
    this->bench->clock();
  }
  this->pin("mem_data_i").drive(0xffff);
  this->bench->settle();
  EXPECT_EQ(this->value("red_o"), 1023u);
  EXPECT_EQ(this->value("read_address_o") & 511, 100u);
  this->pin("rst_ni").drive(0);
  this->bench->clock();
  EXPECT_EQ(this->value("red_o"), 0u);
  EXPECT_EQ(this->value("read_address_o") & 511, 0u);
  this->pin("rst_ni").drive(1);
  this->bench->settle();
  EXPECT_EQ(this->value("read_o"), 1u) << "the first clock of a pixel";
}

}  // namespace
}  // namespace racebeam
