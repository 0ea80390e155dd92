// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_scheduler.h"

#include <utility>

namespace racebeam {

block_scheduler::block_scheduler(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_scheduler_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_scheduler);
  SC_METHOD(seq);
  sensitive << start_i << job_ready_i << rst_ni;
  SC_METHOD(comb);
  sensitive << job_ready_i << busy_i << clocked_;
}

// While nothing is dealt it sleeps.
void block_scheduler::seq() {
  if (!std::exchange(asleep_, false)) {
    const block_scheduler_core::inputs in = {rst_ni.value() != 0, start_i.value() != 0,
                                             width_i.value(), height_i.value(),
                                             job_ready_i.value()};
    asleep_ = core_.idle(in, knobs_);
    core_.clock(in, knobs_);
    job_x_o.drive(core_.job_x_q);
    job_y_o.drive(core_.job_y_q);
    clocked_.notify(sc_core::SC_ZERO_TIME);
  }
  if (asleep_) next_trigger();
  else next_trigger(clk_i->posedge_event());
}

void block_scheduler::comb() {
  job_valid_o.drive(core_.valid(job_ready_i.value(), knobs_));
  done_o.drive(core_.done(busy_i.value(), knobs_));
}

}  // namespace racebeam
