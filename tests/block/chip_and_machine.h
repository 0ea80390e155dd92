// A scene in block_chip on the bench, and in block_machine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "sc/block/block_chip.h"
#include "sc/block/block_machine.h"
#include "tb/host/block_numbers.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

/// The host of a chip on the bench.
class SceneSender {
 public:
  /// Ends the reset.
  SceneSender(UnitBench& bench, const block_tables& tables, const block_knobs& k)
      : bench_(bench), numbers_(block_numbers(tables)) {
    const block_world world = converted(tables, k);
    bench_["spheres_i"].drive(tables.balls.size());
    bench_["ax_i"].drive(static_cast<std::uint32_t>(world.ax));
    bench_["ay_i"].drive(static_cast<std::uint32_t>(world.ay));
    bench_["cone_sine_i"].drive(static_cast<std::uint32_t>(world.cone_sine));
    bench_["cone_cosine2_i"].drive(static_cast<std::uint32_t>(world.cone_cosine2));
    bench_.clock(2);
    bench_["rst_ni"].drive(1);
    bench_.settle();
  }

  /// What it does for a picture; the next clock deals the first job.
  template <class Clock>
  void send(const Clock& clock) {
    for (const BlockNumber& number : numbers_) {
      bench_["valid_i"].drive(1);
      bench_["float_i"].drive(number.bits);
      bench_["field_i"].drive(static_cast<unsigned>(number.field));
      bench_["index_i"].drive(static_cast<unsigned>(number.index));
      wait(clock);
      clock();
    }
    bench_["valid_i"].drive(0);
    wait(clock);
    bench_["start_i"].drive(1);
    bench_.settle();
    clock();
    bench_["start_i"].drive(0);
    bench_.settle();
  }

 private:
  template <class Clock>
  void wait(const Clock& clock) {
    bench_.settle();
    while (!bench_["ready_o"].value()) clock();
  }

  UnitBench& bench_;
  const std::vector<BlockNumber> numbers_;
};

class ChipAndMachine {
 public:
  ChipAndMachine(const block_knobs& k, const block_tables& tables, const unit_choices& choices = {})
      : tables_(tables),
        chip_("block", k, choices),
        bench_(chip_),
        sender_(bench_, tables, k),
        machine_(k) {}

  /// Draws a picture in both.
  void draw() {
    sender_.send([this] { clock(); });
    machine_.draw(tables_);
    const int pictures = chip_.collector().pictures() + 1;
    for (std::uint64_t n = 0; n <= machine_.counters().clocks; ++n) clock();
    ASSERT_EQ(chip_.collector().pictures(), pictures) << "after as many clocks as the machine's";
    machine_.go_to(machine_.store().clock() + 1);
  }
  void expect_same() {
    const frame_counts machine = counted(counters()), chip = counted(chip_.collector().last());
    const auto infos = block_counter_infos();
    ASSERT_EQ(infos.size(), machine.counters.size());
    for (std::size_t n = 0; n < infos.size(); ++n)
      EXPECT_EQ(chip.counters[n], machine.counters[n]) << infos[n].name;
    EXPECT_EQ(chip.histograms, machine.histograms);
    const auto& memory = machine_.store().memory();
    ASSERT_EQ(chip_.memory().size(), memory.size());
    for (std::size_t n = 0; n < memory.size(); ++n)
      ASSERT_EQ(chip_.memory()[n], memory[n]) << "address " << n;
  }
  const block_counters& counters() const { return machine_.counters(); }

 private:
  void clock() {
    chip_.count();
    bench_.clock();
  }

  const block_tables tables_;
  block_chip chip_;
  UnitBench bench_;
  SceneSender sender_;
  block_machine machine_;
};

}  // namespace racebeam
