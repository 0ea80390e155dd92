// Promises of rtl/block/block_top.sv: all RTL units together are the block renderer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <vector>

#include "sc/store/store_knobs.h"
#include "tb/twin/unit_bench.h"
#include "tests/block/quad.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

/// The pins of block_chip, and those of its memory.
struct block_top {
  static constexpr const char* unit_name = "block_top";
  class pins : public sc_core::sc_module {
   public:
    in_port<1> clk_i{"clk_i"};
    in_port<1> rst_ni{"rst_ni"};
    in_port<1> valid_i{"valid_i"};
    in_port<32> float_i{"float_i"};
    in_port<BlockFieldBits> field_i{"field_i"};
    in_port<BlockIndexBits> index_i{"index_i"};
    out_port<1> ready_o{"ready_o"};
    in_port<BlockCountBits> spheres_i{"spheres_i"};
    in_port<BlockBits> ax_i{"ax_i"}, ay_i{"ay_i"};
    in_port<BlockBits> cone_sine_i{"cone_sine_i"}, cone_cosine2_i{"cone_cosine2_i"};
    in_port<1> start_i{"start_i"};
    out_port<1> done_o{"done_o"};
    out_port<1> mem_write_o{"mem_write_o"};
    out_port<StoreAddressBits> mem_address_o{"mem_address_o"};
    out_port<StoreDataBits> mem_data_o{"mem_data_o"};
    in_port<StoreDataBits> mem_data_i{"mem_data_i"};
    out_port<1> hsync_no{"hsync_no"}, vsync_no{"vsync_no"};
    out_port<DacBits> red_o{"red_o"}, green_o{"green_o"}, blue_o{"blue_o"};

    explicit pins(const sc_core::sc_module_name& name) : sc_module(name) {}
  };
};

constexpr int Width = 640, Height = 480, PlaneWords = Width * Height / 8;

/// With a memory and a host.
class Dut {
 public:
  explicit Dut(const block_knobs& k) : top_("dut", k), bench_(top_) {
    bench_.clock(2);
    bench_["rst_ni"].drive(1);
    bench_["ax_i"].drive(QuadStep);
    bench_["ay_i"].drive(QuadStep);
    bench_.settle();
  }
  /// The world of quad; the clocks in which the chip took it.
  int load() {
    for (int k = 0; k < 3; ++k) {
      put(BlockEyeX + k, quad().eye[k]);
      put(BlockLightX + k, quad().light[k]);
    }
    put(BlockScreenWidth, quad().screen[0]);
    put(BlockScreenHeight, quad().screen[1]);
    for (unsigned n = 0; n < quad().balls.size(); ++n) {
      const block_ball& s = quad().balls[n];
      for (int k = 0; k < 3; ++k) put(BlockCentreX + k, s.centre[k], n);
      put(BlockRadius, s.radius, n);
      for (int k = 0; k < 3; ++k) put(BlockRed + k, s.colour[k], n);
    }
    const int taken = clocks_;
    for (int n = 0; n < 3; ++n) clock();
    return taken + 3;
  }
  /// Draws a picture, and waits until all of it is in the memory; the clocks from start to done.
  int draw(unsigned spheres) {
    bench_["spheres_i"].drive(spheres);
    bench_["start_i"].drive(1);
    clock();
    bench_["start_i"].drive(0);
    bench_.settle();
    clocks_ = 0;
    while (!done_.value() && clocks_ < 10'000'000) clock();
    const int drawn = clocks_;
    for (int n = 0; n < 200; ++n) clock();
    return drawn;
  }
  int pixel(int x, int y, int plane) const {
    const std::uint64_t word =
        memory_[static_cast<std::size_t>(plane * PlaneWords + (y * Width + x) / 8)];
    return static_cast<int>(word >> x % 8 * 8 & 255);
  }
  /// FNV-1a over r, g, b, row by row.
  std::uint32_t checksum() const {
    std::uint32_t sum = 2166136261u;
    for (int n = 0; n < 3 * Width * Height; ++n)
      sum = (sum ^ static_cast<unsigned>(pixel(n / 3 % Width, n / 3 / Width, n % 3))) * 16777619u;
    return sum;
  }

 private:
  void clock() {
    const std::size_t address = mem_address_.value();
    mem_data_read_.drive(memory_[address]);
    if (mem_write_.value()) memory_[address] = mem_data_.value();
    bench_.clock();
    ++clocks_;
  }
  void put(int field, float value, unsigned index = 0) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    bench_["valid_i"].drive(1);
    bench_["field_i"].drive(static_cast<unsigned>(field));
    bench_["index_i"].drive(index);
    bench_["float_i"].drive(bits);
    bench_.settle();
    while (!bench_["ready_o"].value()) clock();
    clock();
    bench_["valid_i"].drive(0);
    bench_.settle();
  }

  own_block_rtl<block_top> top_;
  UnitBench bench_;
  UnitBench::Pin &done_ = bench_["done_o"], &mem_write_ = bench_["mem_write_o"],
                 &mem_address_ = bench_["mem_address_o"], &mem_data_ = bench_["mem_data_o"],
                 &mem_data_read_ = bench_["mem_data_i"];
  std::vector<std::uint64_t> memory_ = std::vector<std::uint64_t>(1 << StoreAddressBits);
  int clocks_ = 0;
};

block_knobs with_cores(int cores) {
  block_knobs k;
  k.cores = cores;
  return k;
}

/// Of two cores: one library for both tests.
block_knobs coloured() {
  block_knobs k = with_cores(2);
  k.background = 0x123456;
  return k;
}

TEST(BlockTopTest, WorldOfFourSpheresTakes48Clocks) {
  Dut d(coloured());
  EXPECT_EQ(d.load(), 8 + 4 * 10);
}

TEST(BlockTopTest, PictureWithoutSpheresIsTheBackground) {
  Dut d(coloured());
  d.load();
  d.draw(0);
  for (int y = 0; y < Height; ++y)
    for (int x = 0; x < Width; ++x) {
      ASSERT_EQ(d.pixel(x, y, 0), 0x12) << x << ", " << y;
      ASSERT_EQ(d.pixel(x, y, 1), 0x34);
      ASSERT_EQ(d.pixel(x, y, 2), 0x56);
    }
}

TEST(LongBlockTopTest, QuadIsTheDesignsOnOneCore) {
  Dut d(with_cores(1));
  d.load();
  EXPECT_EQ(d.draw(4), 3'172'601 + 1200) << "each block waits a clock for the core";
  EXPECT_EQ(d.checksum(), 0xe7be7668);
}

TEST(LongBlockTopTest, QuadIsTheDesignsOnSixteenCores) {
  Dut d(with_cores(16));
  d.load();
  EXPECT_EQ(d.draw(4), 251'684) << "the bus costs a quarter";
  EXPECT_EQ(d.checksum(), 0xe7be7668);
}

}  // namespace
}  // namespace racebeam
