// Scene four in sphere_chip on the bench, and in sphere_core.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "sc/sphere/sphere_chip.h"
#include "sc/sphere/sphere_core.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/four_scene.h"

namespace racebeam {

/// What the CPU does for a picture: its spheres, and the edge for the light; two `clock`s each.
template <class Clock>
void send_four(UnitBench& bench, const Clock& clock) {
  const auto drive = [&bench](const char* port, int value) {
    auto& pin = bench[port];
    pin.drive(raw_bits(static_cast<std::uint64_t>(value), pin.bits));
  };
  const auto spheres = four_spheres();
  const int number = static_cast<int>(spheres.size());
  for (int n = 0; n <= number; ++n) {
    drive("sphere_i", number << 4 | (n < number ? n : 0));
    if (n < number) {
      const sphere_row& s = spheres[static_cast<std::size_t>(n)];
      drive("color_i", s.colour[0] << 10 | s.colour[1] << 5 | s.colour[2]);
      drive("x1_i", s.centre[0]);
      drive("y1_i", s.centre[1]);
      drive("z1_i", s.centre[2]);
      drive("reflect_i", s.reflect);
      drive("radius_i", s.radius);
      drive("r2_i", s.radius2);
      drive("r_inv_i", s.inverse);
    }
    for (const int valid : {1, 0}) {
      drive("valid_i", valid);
      bench.settle();
      clock();
    }
  }
}

class ChipAndCore {
 public:
  ChipAndCore(const sphere_knobs& k, const sphere_board& board, const unit_choices& choices = {})
      : board_(board),
        chip_("sphere", k, tables_, choices),
        bench_(chip_),
        core_(k, tables_, board) {
    bench_["sw_i"].drive(static_cast<unsigned>(board.sw));
    bench_["key_ni"].drive(static_cast<unsigned>(board.key_n));
    bench_.clock(2);
    bench_["rst_ni"].drive(1);
    bench_.settle();
  }

  /// Draws a picture of scene four in both.
  void draw() {
    send_four(bench_, [this] { clock(); });
    core_.load(four_spheres());
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

  const sphere_tables tables_ = four_tables();
  const sphere_board board_;
  sphere_chip chip_;
  UnitBench bench_;
  sphere_core core_;
};

}  // namespace racebeam
