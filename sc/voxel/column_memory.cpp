// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/column_memory.h"

#include <utility>

namespace racebeam {

column_memory::column_memory(const sc_core::sc_module_name& name, const voxel_knobs& k)
    : column_memory_pins(name),
      core_(static_cast<std::size_t>(k.size_x) * static_cast<std::size_t>(k.size_y),
            k.memory_clocks) {
  SC_HAS_PROCESS(column_memory);
  SC_METHOD(seq);
  sensitive << read_i << write_i;
}

// Sleeps while nothing is asked of it and nothing is on its way.
void column_memory::seq() {
  if (!std::exchange(asleep_, false)) {
    const voxel_memory_core::inputs in = {read_i.value() != 0, write_i.value() != 0,
                                          static_cast<std::uint32_t>(address_i.value()),
                                          static_cast<std::uint32_t>(data_i.value())};
    core_.clock(in);
    asleep_ = core_.idle(in);
    data_o.drive(core_.data());
  }
  if (asleep_) next_trigger();
  else next_trigger(clk_i->posedge_event());
}

}  // namespace racebeam
