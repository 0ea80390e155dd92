// The wired sphere tracer and sphere_core draw the same pictures in the same clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_chip.h"

#include <gtest/gtest.h>

#include "sc/sphere/sphere_core.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/four_scene.h"

namespace racebeam {
namespace {

class ChipAndCore {
 public:
  ChipAndCore(const sphere_knobs& k, const sphere_board& board)
      : board_(board), chip_("sphere", k, tables_), bench_(chip_), core_(k, tables_, board) {
    bench_["sw_i"].drive(static_cast<unsigned>(board.sw));
    bench_["key_ni"].drive(static_cast<unsigned>(board.key_n));
    bench_.clock(2);
    bench_["rst_ni"].drive(1);
    bench_.settle();
  }

  /// Draws a picture of scene four in both.
  void draw() {
    const auto spheres = four_spheres();
    const unsigned number = static_cast<unsigned>(spheres.size());
    for (unsigned n = 0; n <= number; ++n) {
      if (n < number) send(spheres[n]);
      bench_["sphere_i"].drive(number << 4 | (n < number ? n : 0));
      for (const unsigned valid : {1u, 0u}) {
        bench_["valid_i"].drive(valid);
        bench_.settle();
        clock();
      }
    }
    core_.load(spheres);
    core_.draw(board_);
    const int pictures = chip_.collector().pictures() + 1;
    for (std::uint64_t n = 0; n < core_.counters().clocks; ++n) clock();
    ASSERT_EQ(chip_.collector().pictures(), pictures) << "after as many clocks as the core's";
  }
  void expect_same() {
    const frame_counts core = counted(core_.counters()), chip = counted(chip_.collector().last());
    const auto infos = sphere_counter_infos();
    ASSERT_EQ(infos.size(), core.counters.size());
    for (std::size_t n = 0; n < infos.size(); ++n)
      EXPECT_EQ(chip.counters[n], core.counters[n]) << infos[n].name;
    EXPECT_EQ(chip.histograms, core.histograms);
    const auto& memory = core_.store().memory();
    ASSERT_EQ(chip_.memory().size(), memory.size());
    for (std::size_t n = 0; n < memory.size(); ++n)
      ASSERT_EQ(chip_.memory()[n], memory[n]) << "address " << n;
  }
  const sphere_counters& counters() const { return core_.counters(); }

 private:
  void clock() {
    chip_.count();
    bench_.clock();
  }
  void send(const sphere_row& s) {
    const auto drive = [this](const char* pin, int value, int bits) {
      bench_[pin].drive(raw_bits(static_cast<std::uint64_t>(value), bits));
    };
    drive("color_i", s.colour[0] << 10 | s.colour[1] << 5 | s.colour[2], 16);
    drive("x1_i", s.centre[0], 24);
    drive("y1_i", s.centre[1], 24);
    drive("z1_i", s.centre[2], 24);
    drive("reflect_i", s.reflect, 12);
    drive("radius_i", s.radius, 12);
    drive("r2_i", s.radius2, 24);
    drive("r_inv_i", s.inverse, 12);
  }

  const sphere_tables tables_ = four_tables();
  const sphere_board board_;
  sphere_chip chip_;
  UnitBench bench_;
  sphere_core core_;
};

TEST(SphereChip, TwoPlainPicturesAreTheCores) {
  ChipAndCore both({}, {0, 15});
  for (int picture = 0; picture < 2; ++picture) {
    ASSERT_NO_FATAL_FAILURE(both.draw());
    both.expect_same();
  }
}

TEST(SphereChip, StallsOfASmallBufferAreTheCores) {
  sphere_knobs k;
  k.write_buffer_depth = 8;
  k.write_policy = WritePolicyBlanking;
  k.write_each_pass = 1;
  ChipAndCore both(k, {2 << 2, 15});
  ASSERT_NO_FATAL_FAILURE(both.draw());
  EXPECT_GT(both.counters().buffer_stalls, 0u);
  both.expect_same();
}

TEST(SphereChip, LostWordsAreTheCores) {
  sphere_knobs k;
  k.write_buffer_depth = 4;
  k.when_full = WhenFullDrop;
  k.clocks_per_pixel = 2;
  ChipAndCore both(k, {0, 15});
  ASSERT_NO_FATAL_FAILURE(both.draw());
  EXPECT_GT(both.counters().buffer_lost, 0u);
  both.expect_same();
}

TEST(SphereChip, OtherNumbersAreTheCores) {
  sphere_knobs k;
  k.fraction_bits = 8;
  k.colour_bits = 8;
  k.root_bits_per_clock = 3;
  k.divide_clocks = 9;
  k.shadow_rays = 0;
  ChipAndCore both(k, {3 << 2, 15});
  ASSERT_NO_FATAL_FAILURE(both.draw());
  both.expect_same();
}

TEST(LongSphereChip, PlanesAndTheirShadowsAreTheCores) {
  sphere_knobs k;
  k.plane_shadows = 1;
  k.write_policy = WritePolicyFree;
  ChipAndCore both(k, {3 << 2, 15 & ~4});
  ASSERT_NO_FATAL_FAILURE(both.draw());
  both.expect_same();
}

}  // namespace
}  // namespace racebeam
