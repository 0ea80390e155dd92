// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/subdivider.h"

namespace racebeam {

subdivider::subdivider(const sc_core::sc_module_name& name, const knobs& k)
    : subdivider_pins(name), knobs_(k) {
  SC_HAS_PROCESS(subdivider);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << tracer_reset_i << dec_i << mask_i << wall_i << second_i << tag_i << starving_i
            << ack_i << top_tag_i << top_i2_i << lock_i;
}

void subdivider::seq() {
  in_.idx_load = idx_load_i.value();
  in_.idx_start = idx_start_i.value();
  in_.i2_init = i2_init_i.value();
  core_.clock(in_, out_, knobs_);
  state_o.drive(core_.state_q);
  idx2_o.drive(core_.idx2_q);
  i2_o.drive(core_.i2_q);
  len_m1_o.drive(core_.len_m1());
  ray_signs_o.drive(core_.signs());
  sp_o.drive(core_.sp_q);
  sd_o.drive(core_.sd_q);
  line_done_o.drive(core_.line_done_q);
  drive();  // with the inputs of before the edge; again when one of them changes
}

void subdivider::drive() {
  in_.tracer_reset = tracer_reset_i.value();
  in_.dec = dec_i.value();
  in_.mask = mask_i.value();
  in_.wall = wall_i.value();
  in_.second = second_i.value();
  in_.tag = tag_i.value();
  in_.starving = starving_i.value();
  in_.ack = ack_i.value();
  in_.top_tag = top_tag_i.value();
  in_.top_i2 = top_i2_i.value();
  in_.lock = lock_i.value();
  in_.consume = consume_i.value();
  emit_o.drive(core_.emit(in_, knobs_));
  out_ = core_.comb(in_, knobs_);
  step_o.drive(out_.step);
  neg_o.drive(out_.neg);
  step_size_o.drive(out_.step_size);
  copy_sub_o.drive(out_.copy_sub);
  push_en_o.drive(out_.push);
  descend_o.drive(out_.descend);
  climb_o.drive(out_.climb);
  cur_o.drive(out_.cur);
  leave_o.drive(out_.leave);
  restart_o.drive(out_.restart);
}

void subdivider::comb() {
  drive();
  if (!in_.lock) return;
  // The beam's clock matters only while it drives the steps.
  if (lock_events_.size() == 0)
    lock_events_ = consume_i->value_changed_event() | tracer_reset_i->value_changed_event() |
                   dec_i->value_changed_event() | mask_i->value_changed_event() |
                   wall_i->value_changed_event() | second_i->value_changed_event() |
                   tag_i->value_changed_event() | starving_i->value_changed_event() |
                   ack_i->value_changed_event() | top_tag_i->value_changed_event() |
                   top_i2_i->value_changed_event() | lock_i->value_changed_event();
  next_trigger(lock_events_);
}

}  // namespace racebeam
