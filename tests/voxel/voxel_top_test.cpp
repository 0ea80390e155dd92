// Promises of rtl/voxel/voxel_top.sv: all RTL units together are the voxel tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "sc/store/store_knobs.h"
#include "sc/voxel/engine.h"
#include "sc/voxel/voxel_levels.h"
#include "sc/voxel/voxel_memory_core.h"
#include "tb/host/voxel_player.h"
#include "tb/twin/unit_bench.h"
#include "tests/voxel/twins.h"

namespace racebeam {
namespace {

/// The pins of voxel_chip, and those of its memories.
struct voxel_top {
  static constexpr const char* unit_name = "voxel_top";
  class pins : public sc_core::sc_module {
   public:
    in_port<1> clk_i{"clk_i"};
    in_port<1> rst_ni{"rst_ni"};
    in_port<1> palette_write_i{"palette_write_i"};
    in_port<VoxelPaletteBits> palette_index_i{"palette_index_i"};
    in_port<VoxelColourBits> palette_colour_i{"palette_colour_i"};
    in_port<1> column_write_i{"column_write_i"};
    in_port<VoxelColumnBits> column_address_i{"column_address_i"};
    in_port<VoxelMemoryBits> column_data_i{"column_data_i"};
    in_port<1> build_i{"build_i"};
    in_port<VoxelRectangleBits> rect_x_low_i{"rect_x_low_i"}, rect_y_low_i{"rect_y_low_i"};
    in_port<VoxelRectangleBits> rect_x_high_i{"rect_x_high_i"}, rect_y_high_i{"rect_y_high_i"};
    out_port<1> built_o{"built_o"};
    axes_in<VoxelPositionBits> origin_i{"origin", "_i"};
    axes_in<VoxelCameraBits> d00_i{"d00", "_i"}, dx_i{"dx", "_i"}, dy_i{"dy", "_i"};
    axes_in<VoxelDirectionBits> light_i{"light", "_i"};
    in_port<1> start_i{"start_i"};
    out_port<1> picture_done_o{"picture_done_o"};
    out_port<1> column_read_o{"column_read_o"}, column_write_o{"column_write_o"};
    out_port<VoxelColumnBits> column_address_o{"column_address_o"};
    out_port<VoxelMemoryBits> column_data_o{"column_data_o"};
    in_port<VoxelMemoryBits> column_word_i{"column_word_i"};
    out_port<1> occupancy_read_o{"occupancy_read_o"}, occupancy_write_o{"occupancy_write_o"};
    out_port<VoxelWordBits> occupancy_address_o{"occupancy_address_o"};
    out_port<VoxelMemoryBits> occupancy_data_o{"occupancy_data_o"};
    in_port<VoxelMemoryBits> occupancy_word_i{"occupancy_word_i"};
    out_port<1> mem_write_o{"mem_write_o"};
    out_port<StoreAddressBits> mem_address_o{"mem_address_o"};
    out_port<StoreDataBits> mem_data_o{"mem_data_o"};
    in_port<StoreDataBits> mem_data_i{"mem_data_i"};
    out_port<1> hsync_no{"hsync_no"}, vsync_no{"vsync_no"};
    out_port<DacBits> red_o{"red_o"}, green_o{"green_o"}, blue_o{"blue_o"};

    explicit pins(const sc_core::sc_module_name& name) : sc_module(name) {}
  };
};

/// A memory of the world at the pins of that name.
class WorldMemory {
 public:
  WorldMemory(UnitBench& bench, const std::string& name, std::size_t words, int clocks)
      : core_(words, clocks),
        read_(bench[name + "_read_o"]),
        write_(bench[name + "_write_o"]),
        address_(bench[name + "_address_o"]),
        data_(bench[name + "_data_o"]),
        word_(bench[name + "_word_i"]) {}
  void drive() { word_.drive(core_.data()); }
  void clock() {
    core_.clock({read_.value() != 0, write_.value() != 0,
                 static_cast<std::uint32_t>(address_.value()),
                 static_cast<std::uint32_t>(data_.value())});
  }
  const std::vector<std::uint32_t>& words() const { return core_.words_q; }

 private:
  voxel_memory_core core_;
  UnitBench::Pin &read_, &write_, &address_, &data_, &word_;
};

/// With its memories and a host.
class Dut {
 public:
  explicit Dut(const voxel_knobs& k)
      : knobs_(k),
        top_("dut", k),
        bench_(top_),
        columns_(bench_, "column", static_cast<std::size_t>(k.size_x * k.size_y), k.memory_clocks),
        occupancy_(bench_, "occupancy", voxel_levels(k).words(), k.memory_clocks) {
    bench_.clock(2);
    bench_["rst_ni"].drive(1);
    bench_.settle();
  }
  /// Sends colours and columns, and has all built; the clocks of the build.
  int load(const VoxelProgram& program) {
    bench_["palette_write_i"].drive(1);
    for (unsigned n = 0; n < program.palette.size(); ++n) {
      bench_["palette_index_i"].drive(n);
      bench_["palette_colour_i"].drive(static_cast<unsigned>(program.palette[n]));
      clock();
    }
    bench_["palette_write_i"].drive(0);
    bench_["column_write_i"].drive(1);
    for (unsigned n = 0; n < program.columns.size(); ++n) {
      bench_["column_address_i"].drive(n);
      bench_["column_data_i"].drive(program.columns[n]);
      clock();
    }
    bench_["column_write_i"].drive(0);
    bench_["rect_x_high_i"].drive(static_cast<unsigned>(knobs_.size_x));
    bench_["rect_y_high_i"].drive(static_cast<unsigned>(knobs_.size_y));
    bench_["build_i"].drive(1);
    clock();
    bench_["build_i"].drive(0);
    return until(built_);
  }
  /// Draws a picture, and waits until all of it is in the memory; the clocks after that of start.
  int draw(const voxel_view& view) {
    bench_.drive("origin", "_i", view.origin);
    bench_.drive("d00", "_i", view.d00);
    bench_.drive("dx", "_i", view.dx);
    bench_.drive("dy", "_i", view.dy);
    bench_.drive("light", "_i", view.light);
    bench_["start_i"].drive(1);
    clock();
    bench_["start_i"].drive(0);
    const int drawn = until(done_);
    for (int n = 0; n < 200; ++n) clock();
    return drawn;
  }
  std::uint64_t pixel(int x, int y) const { return memory_[static_cast<std::size_t>(y << 10 | x)]; }
  const std::vector<std::uint32_t>& occupancy() const { return occupancy_.words(); }

 private:
  /// The clocks up to that in which `pin` is 1, with it.
  int until(const UnitBench::Pin& pin) {
    int clocks = 0;
    for (bool over = false; !over && clocks < 10'000'000; ++clocks) {
      settle();
      over = pin.value() != 0;
      clock();
    }
    return clocks;
  }
  void settle() {
    columns_.drive();
    occupancy_.drive();
    bench_.settle();
  }
  void clock() {
    settle();
    const std::size_t address = mem_address_.value();
    mem_data_read_.drive(memory_[address]);
    if (mem_write_.value()) memory_[address] = mem_data_.value();
    columns_.clock();
    occupancy_.clock();
    bench_.clock();
  }

  const voxel_knobs knobs_;
  own_voxel_rtl<voxel_top> top_;
  UnitBench bench_;
  WorldMemory columns_, occupancy_;
  UnitBench::Pin &built_ = bench_["built_o"], &done_ = bench_["picture_done_o"],
                 &mem_write_ = bench_["mem_write_o"], &mem_address_ = bench_["mem_address_o"],
                 &mem_data_ = bench_["mem_data_o"], &mem_data_read_ = bench_["mem_data_i"];
  std::vector<std::uint64_t> memory_ = std::vector<std::uint64_t>(1 << StoreAddressBits);
};

/// That `dut` has the picture and the octree of the tlm level.
void expect_players(const Dut& dut, const VoxelProgram& program, const voxel_knobs& k) {
  VoxelPlayer player(program, k);
  player.draw();
  EXPECT_EQ(dut.occupancy(), player.machine().world().occupancy());
  const std::vector<std::uint64_t> picture = player.machine().picture();
  for (int y = 0; y < k.picture_height; ++y)
    for (int x = 0; x < k.picture_width; ++x)
      ASSERT_EQ(dut.pixel(x, y), picture[static_cast<std::size_t>(y << 10 | x)]) << x << ", " << y;
}

TEST(VoxelTopTest, TinyTakesTheClocksOfTheVectors) {
  const VoxelProgram& program = builtin_voxel_program();
  const voxel_knobs k = voxel_engine().standard(&program);
  Dut d(k);
  d.load(program);
  EXPECT_EQ(d.draw(program.views.front()), 312'737 + 64 * 48) << "a clock a pixel more";
  expect_players(d, program, k);
}

/// `tiny`, of 16 x 12 pixels, with roofs over every fourth column.
VoxelProgram roofed_program() {
  VoxelProgram program = builtin_voxel_program();
  program.width = 16;
  program.height = 12;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    program.views.front().dx[axis] *= 4;
    program.views.front().dy[axis] *= 4;
  }
  for (std::size_t n = 0; n < program.columns.size(); n += 4) {
    voxel_column column = unpacked_column(program.columns[n]);
    column.middle = column.low + 6;
    column.high = column.low + 8;
    column.high_material = 3;
    program.columns[n] = packed(column);
  }
  return program;
}

TEST(LongVoxelTopTest, ShadowsAndSlopesAreThoseOfTheTlmLevel) {
  const VoxelProgram program = roofed_program();
  voxel_knobs k = voxel_engine().standard(&program);
  k.shadows = 1;
  k.shading = VoxelShadingSlope;
  k.sky = VoxelSkyGradient;
  k.memory_clocks = 2;
  k.leaf_steps = 2;
  k.group_fetch = 1;
  k.raise = VoxelRaiseAll;
  Dut d(k);
  d.load(program);
  d.draw(program.views.front());
  expect_players(d, program, k);
}

}  // namespace
}  // namespace racebeam
