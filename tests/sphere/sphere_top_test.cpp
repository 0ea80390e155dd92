// Promises of rtl/sphere/sphere_top.sv: all RTL units together are the sphere tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sc/base/constants.h"
#include "sc/store/frame_memory.h"
#include "tests/sphere/chip_and_core.h"
#include "tests/sphere/picture_checksum.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

/// The pins of sphere_chip, and those of its memory.
struct sphere_top {
  static constexpr const char* unit_name = "sphere_top";
  class pins : public sc_core::sc_module {
   public:
    in_port<1> clk_i{"clk_i"};
    in_port<1> rst_ni{"rst_ni"};
    in_port<18> sw_i{"sw_i"};
    in_port<4> key_ni{"key_ni"};
    in_port<8> sphere_i{"sphere_i"};
    in_port<16> color_i{"color_i"};
    in_port<SphereBits> x1_i{"x1_i"}, y1_i{"y1_i"}, z1_i{"z1_i"};
    in_port<UnitBits> reflect_i{"reflect_i"}, radius_i{"radius_i"};
    in_port<SphereBits> r2_i{"r2_i"};
    in_port<UnitBits> r_inv_i{"r_inv_i"};
    in_port<1> valid_i{"valid_i"};
    out_port<8> rotz_o{"rotz_o"};
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

/// With a memory and a CPU.
class SphereTopTest : public testing::Test {
 protected:
  /// Draws a picture, and waits until all of it is in the memory.
  void draw(const sphere_board& board) {
    bench_["sw_i"].drive(static_cast<unsigned>(board.sw));
    bench_["key_ni"].drive(static_cast<unsigned>(board.key_n));
    bench_.clock(2);
    bench_["rst_ni"].drive(1);
    bench_.settle();
    send_four(bench_, [this] { clock(); });
    while (!done_.value()) {
      clock();
      ++clocks;
      ASSERT_LT(clocks, 100'000'000) << "a hang";
    }
    for (int n = 0; n < 2 * LinePixels; ++n) clock();
  }
  const std::vector<std::uint64_t>& words() const { return memory_.words_q; }

  void expect_four(const sphere_board& board, int clocks_of_page, std::uint32_t checksum) {
    draw(board);
    EXPECT_EQ(clocks, clocks_of_page);
    EXPECT_EQ(picture_checksum(words(), 512, 480), checksum);
  }

  const sphere_tables tables = four_tables();
  int clocks = 0;

 private:
  void clock() {
    const frame_memory_core::inputs access{
        mem_write_.value() != 0, static_cast<int>(mem_address_.value()), mem_data_.value()};
    bench_.clock();
    memory_.clock(access, knobs_.store());
    mem_data_read_.drive(memory_.data_q);
  }

  const sphere_knobs knobs_;
  own_sphere_rtl<sphere_top> top_{"dut", tables};
  UnitBench bench_{top_};
  UnitBench::Pin &done_ = bench_["done_o"], &mem_write_ = bench_["mem_write_o"],
                 &mem_address_ = bench_["mem_address_o"], &mem_data_ = bench_["mem_data_o"],
                 &mem_data_read_ = bench_["mem_data_i"];
  frame_memory_core memory_{knobs_.store()};
};

constexpr int Size512 = 1 << 5, Reflections3 = 3 << 2, NoKey = 15, PlanesKey = 15 & ~4;

TEST_F(SphereTopTest, SmallPictureIsTheCores) {
  const sphere_board board{0, NoKey};
  draw(board);
  sphere_core core({}, tables, board);
  core.load(four_spheres());
  core.draw(board);
  EXPECT_EQ(static_cast<std::uint64_t>(clocks), core.counters().clocks);
  EXPECT_EQ(words(), core.picture());
}

using LongSphereTopTest = SphereTopTest;
TEST_F(LongSphereTopTest, PlainPictureOfFour) {
  expect_four({Size512, NoKey}, 9'000'673, 0xb8c354c2);
}
TEST_F(LongSphereTopTest, PictureOfFourWithReflections) {
  expect_four({Size512 | Reflections3, NoKey}, 9'425'850, 0x38209886);
}
TEST_F(LongSphereTopTest, PictureOfFourWithReflectionsAndPlanes) {
  expect_four({Size512 | Reflections3, PlanesKey}, 79'822'445, 0xb9cbe708);
}

}  // namespace
}  // namespace racebeam
