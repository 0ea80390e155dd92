// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/stacks.h"

namespace racebeam {

stacks::stacks(const sc_core::sc_module_name& name, const knobs& k) : stacks_pins(name), knobs_(k) {
  SC_HAS_PROCESS(stacks);
  SC_METHOD(seq);
  sensitive << push_en_i << fwrite_i;
  SC_METHOD(comb);
  sensitive << sp_i << tag_i << written_;
}

// Sleeps until something is to be written.
void stacks::seq() {
  const bool write = push_en_i.value() || fwrite_i.value();
  if (writing_ && write) {
    core_.clock({push_en_i.value() != 0, tag_i.value(), i2_i.value(), sp_i.value(),
                 fwrite_i.value() != 0, fdata_i.value(), depth()},
                knobs_);
    written_.notify(sc_core::SC_ZERO_TIME);
  }
  writing_ = write;
  if (writing_) next_trigger(clk_i->posedge_event());
  else next_trigger();
}

void stacks::comb() {
  const auto& top = core_.top(sp_i.value(), knobs_);
  top_tag_o.drive(top.tag);
  top_i2_o.drive(top.i2);
  fread_o.drive(core_.face(depth(), knobs_));
}

}  // namespace racebeam
