// block_scheduler: deals the blocks of a picture to the cores.
//
// What    start_i, while no picture is dealt, begins one of width_i x height_i pixels. Jobs go row
// by
//         row, left to right, each to the lowest core that is ready: job_valid_o has that core's
//         bit, job_x_o and job_y_o are the block's upper left pixel, and at the end of the clock
//         the next block is up; while nothing is dealt it is the first. done_o: all blocks are
//         dealt and no core is busy.
// Size    two places, a priority encoder of the cores.
// Cycles  a job a clock; the first in the clock after start_i.
// Comb    job_ready_i -> job_valid_o; busy_i -> done_o.
// Stall   waits while no core is ready.
// Reset   rst_ni = 0: nothing is dealt, done_o if no core is busy; places 0.
// Knobs   cores, 1..64: parameter Cores; bits of cores that there are not do not count.
// Twin    rtl/block/block_scheduler.sv
// Test    tests/block/block_scheduler_test.cpp
// Source  article "Command and Control".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_scheduler_core.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// Pins of block_scheduler.
class block_scheduler_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // Host
  in_port<1> start_i{"start_i"};
  in_port<BlockPlaceBits> width_i{"width_i"};
  in_port<BlockPlaceBits> height_i{"height_i"};
  out_port<1> done_o{"done_o"};
  // block_core, a bit each
  out_port<BlockCores> job_valid_o{"job_valid_o"};
  out_port<BlockPlaceBits> job_x_o{"job_x_o"};
  out_port<BlockPlaceBits> job_y_o{"job_y_o"};
  in_port<BlockCores> job_ready_i{"job_ready_i"};
  in_port<BlockCores> busy_i{"busy_i"};

  explicit block_scheduler_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_scheduler: its core behind the pins.
class block_scheduler : public block_scheduler_pins, public probed {
 public:
  using pins = block_scheduler_pins;
  static constexpr const char* unit_name = "block_scheduler";

  block_scheduler(const sc_core::sc_module_name& name, const block_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();

  const block_knobs knobs_;
  block_scheduler_core core_;
  bool asleep_ = true;
  sc_core::sc_event clocked_{"clocked"};
};

}  // namespace racebeam
