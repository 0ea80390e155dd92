// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_core.h"

#include <utility>

namespace racebeam {

block_core::block_core(const sc_core::sc_module_name& name, const block_knobs& k)
    : block_core_pins(name), knobs_(k) {
  SC_HAS_PROCESS(block_core);
  SC_METHOD(seq);
  sensitive << job_valid_i << job_x_i << job_y_i << write_i << word_ready_i << rst_ni;
  SC_METHOD(drive);
}

// While it waits for a job or for the bus it sleeps.
void block_core::seq() {
  if (!std::exchange(asleep_, false)) {
    const block_core_core::inputs in = inputs();
    asleep_ = core_.idle(in);
    core_.clock(in, knobs_);
    drive();
  }
  if (asleep_) next_trigger();
  else next_trigger(clk_i->posedge_event());
}

block_core_core::inputs block_core::inputs() const {
  return {rst_ni.value() != 0,
          job_valid_i.value() != 0,
          job_x_i.value(),
          job_y_i.value(),
          {write_i.value() != 0, field_i.value(), index_i.value(),
           static_cast<int>(value_i.signed_value()), static_cast<int>(eye_k_i.signed_value())},
          spheres_i.value(),
          eye_i.signed_value(),
          light_i.signed_value(),
          start_i.signed_value(),
          static_cast<int>(ax_i.signed_value()),
          static_cast<int>(ay_i.signed_value()),
          static_cast<int>(cone_sine_i.signed_value()),
          static_cast<int>(cone_cosine2_i.signed_value()),
          word_ready_i.value() != 0};
}

void block_core::drive() {
  job_ready_o.drive(core_.state_q == BlockIdle);
  busy_o.drive(core_.state_q != BlockIdle);
  word_valid_o.drive(core_.word_valid());
  word_address_o.drive(core_.word_address(knobs_));
  word_o.drive(core_.word(knobs_));
  state_o.drive(core_.state_q);
  event_o.drive(core_.event_q);
}

}  // namespace racebeam
