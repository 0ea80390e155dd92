// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/base/channel_delay.h"

namespace racebeam {

void channel_delay_core::clock(bool clear, const moves& m) {
  if (clear) {
    count_q = arrived_q = write_q = read_q = 0;
    on_the_way_q = 0;
    return;
  }
  const bool arrives = latency == 1 ? m.put : on_the_way_q >> (latency - 2) & 1;
  on_the_way_q = on_the_way_q << 1 | m.put;
  count_q += m.put - m.take;
  arrived_q += arrives - m.take;
  if (m.put) write_q = write_q + 1 == capacity ? 0 : write_q + 1;
  if (m.take) read_q = read_q + 1 == capacity ? 0 : read_q + 1;
}

channel_delay::channel_delay(const sc_core::sc_module_name& name, int latency, int capacity)
    : channel_delay_pins(name),
      core_{latency, capacity},
      entries_(static_cast<std::size_t>(capacity)) {
  SC_HAS_PROCESS(channel_delay);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << offer_valid_i << moved_;
}

void channel_delay::seq() {
  const auto moves = core_.comb(offer_valid_i.value(), take_ready_i.value());
  if (moves.put && !clear_i.value())
    entries_[static_cast<std::size_t>(core_.write_q)] = offer_data_i.value();
  core_.clock(clear_i.value(), moves);
  moved_.notify(sc_core::SC_ZERO_TIME);
}

void channel_delay::comb() {
  offer_ready_o.drive(core_.ready());
  offer_ack_o.drive(offer_valid_i.value() && core_.ready());
  take_valid_o.drive(core_.offers());
  take_data_o.drive(entries_[static_cast<std::size_t>(core_.read_q)]);
}

}  // namespace racebeam
