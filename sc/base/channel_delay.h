// channel_delay: registers in a channel between two units, as a pipeline would have them.
//
// What    an offer is taken from its source in a clock in which there is an entry free for it, and
//         is offered to its destination Latency clocks later and from then on until that takes it,
//         in order. While the destination waits, younger offers come nearer, until all entries are
//         in use.
// Size    Capacity entries of Width bits, Latency or more; the source may offer in every clock if
//         there is one more than Latency. Which of them are in use, and Latency - 1 bits of what
//         is on the way.
// Cycles  Latency from offer to offer, 1..63. One in and one out a clock.
// Comb    offer_valid_i -> offer_ack_o. offer_ready_o, take_valid_o, take_data_o: registers only.
// Stall   take_valid_o stays 1, and take_data_o what it is, until take_ready_i is 1.
// Reset   clear_i: empty, from the next clock on, whatever was offered or taken. Entries keep
//         their bits.
// Twin    rtl/base/channel_delay.sv
// Test    tests/base/channel_delay_test.cpp
// Source  no part of the chip: `racebeam delays`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/unit.h"

namespace racebeam {

/// Behaviour of channel_delay, without the bits of its entries.
struct channel_delay_core {
  static constexpr int LongestLatency = 63;

  int latency, capacity;
  int count_q = 0;                 // entries in use
  int arrived_q = 0;               // of them, those that are on offer or behind one that is
  int write_q = 0, read_q = 0;     // the entries that are next
  std::uint64_t on_the_way_q = 0;  // bit n: an offer was taken n + 1 clocks ago

  bool offers() const { return arrived_q > 0; }
  bool ready() const { return count_q < capacity; }

  struct moves {
    bool put, take;
  };
  moves comb(bool offered, bool taken) const { return {offered && ready(), taken && offers()}; }
  void clock(bool clear, const moves& m);
};

/// Pins of channel_delay; of the RTL the data are Width bits.
class channel_delay_pins : public sc_core::sc_module {
 public:
  static constexpr int DataBits = 64;
  // Clock; forget all
  in_port<1> clk_i{"clk_i"};
  in_port<1> clear_i{"clear_i"};
  // The unit that offers
  in_port<1> offer_valid_i{"offer_valid_i"};
  in_port<DataBits> offer_data_i{"offer_data_i"};
  out_port<1> offer_ready_o{"offer_ready_o"};  // there is an entry free
  out_port<1> offer_ack_o{"offer_ack_o"};      // taken in this clock
  // The unit that takes
  out_port<1> take_valid_o{"take_valid_o"};
  out_port<DataBits> take_data_o{"take_data_o"};
  in_port<1> take_ready_i{"take_ready_i"};  // it takes in this clock, if there is an offer

  explicit channel_delay_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of channel_delay: its core behind the pins.
class channel_delay : public channel_delay_pins {
 public:
  using pins = channel_delay_pins;
  static constexpr const char* unit_name = "channel_delay";

  channel_delay(const sc_core::sc_module_name& name, int latency, int capacity);

 private:
  void seq();
  void comb();

  channel_delay_core core_;
  std::vector<std::uint64_t> entries_;
  sc_core::sc_event moved_{"moved"};
};

}  // namespace racebeam
