// The frame store whole: wired units do in every clock what their cores do in a plain loop, and a
// screen takes what comes out.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "tb/monitor/vga_monitor.h"
#include "tb/twin/unit_bench.h"
#include "tests/store/frame_store_loop.h"
#include "tests/store/frame_store_rig.h"

namespace racebeam {
namespace {

template <class Kind>
class FrameStoreTest : public testing::Test {
 protected:
  void build(const store_knobs& k, int clocks_per_pixel) {
    rig.emplace("rig", k, clocks_per_pixel);
    bench.emplace(*rig);
  }
  UnitBench::Pin& pin(const char* name) { return (*bench)[name]; }
  int value(const char* name) { return static_cast<int>(pin(name).value()); }
  StoreClock now() {
    return {value("put_ready_o") != 0,
            rig->take_valid.read(),
            rig->take_ready.read(),
            rig->mem_write.read(),
            value("fill_o"),
            static_cast<int>(rig->mem_address.read()),
            value("red_o"),
            value("green_o"),
            value("blue_o"),
            value("hsync_no") != 0,
            value("vsync_no") != 0};
  }

  /// Random words, offered with pauses, beside the cores.
  void agrees_with_the_cores(const store_knobs& k, int clocks_per_pixel, int clocks) {
    build(k, clocks_per_pixel);
    FrameStoreLoop cores(k, clocks_per_pixel);
    const unsigned seed = 5 + k.write_policy;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    int written = 0, waited = 0, coloured = 0;
    for (int n = 0; n < clocks; ++n) {
      const bool rst_n = n > 0, put = random() % 9 < (k.write_policy == WritePolicyFree ? 8 : 1);
      // A few rows at the top, so that the beam comes by.
      const write_buffer_core::entry word{static_cast<int>(random() % 4096), random()};
      pin("rst_ni").drive(rst_n);
      pin("put_valid_i").drive(put);
      pin("put_address_i").drive(static_cast<std::uint64_t>(word.address));
      pin("put_data_i").drive(word.data);
      bench->settle();
      const StoreClock got = now(), want = cores.clock(rst_n, put, word);
      bench->clock();
      if (n == 0) continue;  // before any edge
      ASSERT_EQ(got.all(), want.all()) << "clock " << n;
      written += want.mem_write;
      waited += put && !want.put_ready;
      coloured += want.red + want.green + want.blue != 0;
    }
    EXPECT_GT(written, 100);
    EXPECT_GT(waited, 100) << "the buffer is full now and then";
    EXPECT_GT(coloured, 100);
  }

  std::optional<FrameStoreRig<Kind>> rig;
  std::optional<UnitBench> bench;
};

using Kinds = testing::Types<Models, Twins>;
TYPED_TEST_SUITE(FrameStoreTest, Kinds);

// The first visible line begins after 33 others.
constexpr int LightClocks = 36 * LinePixels;

TYPED_TEST(FrameStoreTest, WritingInSyncsWiredUnitsAreTheirCores) {
  this->agrees_with_the_cores(rgb_light(), 1, LightClocks);
}
TYPED_TEST(FrameStoreTest, WritingBetweenReadsWiredUnitsAreTheirCores) {
  this->agrees_with_the_cores(rgb888(), 2, 2 * LightClocks);
}
TYPED_TEST(FrameStoreTest, WritingPlanesInBlankingWiredUnitsAreTheirCores) {
  this->agrees_with_the_cores(planar(), 2, 2 * LightClocks);
}

// A whole frame of a picture that is in the memory already.
TYPED_TEST(FrameStoreTest, ScreenTakesTheFrameAndSeesThePicture) {
  this->build(rgb_light(), 1);
  const auto word = [](int column, int row) { return column * 5 + row * 77 + column * row; };
  for (int row = 0; row < VisibleRows; ++row)
    for (int column = 0; column < 512; ++column)
      this->rig->u_frame_memory.deposit(row << 9 | column, word(column, row) & 0xffff);
  this->bench->clock();
  this->pin("rst_ni").drive(1);
  this->bench->clock();  // its pins are a clock late

  int frames = 0;
  const Raster raster(1);
  VgaMonitor monitor(raster, [&](const VgaFrame& frame) {
    ++frames;
    for (int row = 0; row < VisibleRows; ++row)
      for (int column = 0; column < VisibleColumns; ++column) {
        const int bits = column < 512 ? word(column, row) : 0;
        // The upper two of five bits a channel
        const int colour = (bits >> 13 & 3) << 4 | (bits >> 8 & 3) << 2 | (bits >> 3 & 3);
        ASSERT_EQ(frame.colours[row * VisibleColumns + column], colour)
            << "(" << column << ", " << row << ")";
      }
  });
  for (int n = 0; n < raster.frame_clocks(); ++n, this->bench->clock())
    monitor.change(
        n, static_cast<std::uint8_t>(
               pins_of_colour(this->value("red_o") >> 8 << 4 | this->value("green_o") >> 8 << 2 |
                              this->value("blue_o") >> 8) |
               this->value("hsync_no") << PinHsync | this->value("vsync_no") << PinVsync));
  monitor.advance(raster.frame_clocks());
  EXPECT_EQ(frames, 1);
}

}  // namespace
}  // namespace racebeam
