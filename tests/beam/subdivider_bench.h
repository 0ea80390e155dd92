// subdivider alone on the bench.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "sc/beam/subdivider.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {

constexpr int SignMask = 14, BitMask = 1;
constexpr int tag_of(int depth, int level) { return depth << LevelBits | level; }

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const knobs& k = {}) : unit("dut", k), bench(unit) {}

  int get(const char* port) { return bench[port].value(); }
  void set(const char* port, int value) { bench[port].drive(value); }
  /// Sets an input and lets the outputs follow.
  void see(const char* port, int value) {
    set(port, value);
    bench.settle();
  }
  void clock(int edges = 1) { bench.clock(edges); }

  /// The interval 0..i2 at the top of the tree, with dr2 at pixel `at`, all other inputs 0.
  void start(int i2, int at) {
    for (auto* pin : bench.pins())
      if (pin->input) pin->drive(0);
    set("tracer_reset_i", 1);
    set("idx_load_i", 1);
    set("idx_start_i", at);
    set("i2_init_i", i2);
    set("mask_i", BitMask);
    clock();
    set("idx_load_i", 0);
    set("tracer_reset_i", 0);
    bench.settle();
  }
  int state() { return get("state_o"); }
  int idx2() { return get("idx2_o"); }
  int i2() { return get("i2_o"); }
  int i1() { return (get("i2_o") - get("len_m1_o")) & 1023; }
  /// Step on request in this clock; 0 if none.
  int step() { return get("step_o") ? (get("neg_o") ? -1 : 1) * get("step_size_o") : 0; }
  /// LEFT and RIGHT (aligned), then bisects to `last`, the last pixel with decision 0. The split
  /// ends in the clock that stays settled: push_en is 1 there. Returns the clocks in BISECT.
  int split_at(int last) {
    see("dec_i", i1() > last);
    clock();
    int clocks = 0;
    for (see("dec_i", idx2() > last); !get("push_en_o") && clocks < 700; ++clocks) {
      clock();
      see("dec_i", idx2() > last);
    }
    return clocks;
  }
};

template <class Unit>
class SubdividerTest : public testing::Test {
 protected:
  Dut<Unit> dut;
};

using Twins = testing::Types<subdivider, own_rtl<subdivider>>;

}  // namespace racebeam
