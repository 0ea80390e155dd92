// interval_fifo alone on the bench.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "sc/beam/interval_fifo.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {

constexpr int Entries = 10;

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const knobs& k = {}) : unit("dut", k), bench(unit) { reset(); }

  void reset() {
    drive(0, 0, 0, 0);
    bench["tracer_reset_i"].drive(1);
    bench.clock();
    bench["tracer_reset_i"].drive(0);
    bench.settle();
  }
  void drive(int consume, int emit, int pixels, int value) {
    bench["consume_i"].drive(consume);
    bench["emit_i"].drive(emit);
    bench["len_m1_i"].drive(pixels - 1);
    bench["value_i"].drive(value);
    bench.settle();
  }
  /// One clock; returns whether the offer was accepted in it.
  bool clock(int consume, int emit = 0, int pixels = 1, int value = 0) {
    drive(consume, emit, pixels, value);
    const bool ack = this->ack();
    bench.clock();
    return ack;
  }
  bool offer(int pixels, int value) { return clock(0, 1, pixels, value); }
  /// Fills all entries but the head with single pixels; the head holds `head` pixels of index 1.
  void fill_up(int entries, int head = 1) {
    for (int n = 1; n < entries - 1; ++n) offer(1, n % 2 ? 3 : 2);
    offer(head, 1);
  }
  bool ack() { return bench["ack_o"].value(); }
  bool starving() { return bench["starving_o"].value(); }
  int display() { return bench["display_o"].value(); }
  int fill() { return bench["fill_o"].value(); }
};

template <class Unit>
class IntervalFifoTest : public testing::Test {
 protected:
  Dut<Unit> dut;
};

using Twins = testing::Types<interval_fifo, own_rtl<interval_fifo>>;

}  // namespace racebeam
