// interval_fifo: run-length queue between the ray tracer and the beam.
//
// What    holds what the line shows next as (length, colour index). The head takes intervals in
//         and merges those of its own colour; a shift register of short entries follows; the tail
//         is on display and shrinks by one a pixel. A head of 64 pixels or more sheds entries of
//         64. When only the head is left and is used up the beam is starving: the head's length
//         goes on counting below zero, and the next interval is shortened by that debt.
// Size    10 entries: head 11 + 2 bits (signed length minus one), 8 x (6 + 2), tail 6 + 2.
//         Checkered dithering: each entry has a bit more, the half tone.
//         The interval 0..639 is shown one column late: the queue starts with one pixel of index 0.
// Cycles  one accepted interval a clock; shown from the next clock on.
// Comb    emit_i, len_m1_i, value_i, half_i, consume_i -> ack_o. starving_o, display_o,
//         display_half_o, fill_o: registers only.
// Stall   no ack while the head splits or the head alone is eaten; while full only an interval of
//         the head's own colour is taken. Checkered, a colour is index and half tone.
// Reset   one pixel of index 0 (tracer_reset_i).
// Knobs   fifo_entries, fifo_short_length_bits, fifo_merge, dithering.
// Twin    rtl/beam/interval_fifo.sv
// Test    tests/beam/interval_fifo_test.cpp
// Source  contract section 14; article "Interval FIFO".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <iterator>
#include <tuple>

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/beam/codes.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Behaviour of interval_fifo.
struct interval_fifo_core {
  static constexpr int MaxQueue = 62;
  static constexpr int HeadBits = 11;

  // Values are colour indices, checkered also HalfTone.
  int head_value_q = 0, head_len_q = 0;  // length minus one
  int tail_value_q = 0, tail_len_q = 0;  // length minus one
  int tail_ptr_q = 0;                    // free entries; all but the head free: only the head
  struct entry {
    int len_m1, value;
  };
  entry queue_q[MaxQueue]{};  // youngest last

  struct inputs {
    bool tracer_reset, consume, emit;
    int len_m1, value;
  };

  int queue_size(const knobs& k) const { return k.fifo_entries - 2; }
  bool head_only(const knobs& k) const { return tail_ptr_q == queue_size(k) + 1; }
  bool starving(const knobs& k) const { return head_only(k) && head_len_q < 0; }
  int display(const knobs& k) const { return head_only(k) ? head_value_q : tail_value_q; }
  /// Entries in use, 1..fifo_entries.
  int fill(const knobs& k) const { return queue_size(k) + 2 - tail_ptr_q; }

  /// Pixels until the beam starves if nothing is taken in; 0 or less: it does.
  int pixels(const knobs& k) const {
    int sum = head_len_q + 1;
    if (head_only(k)) return sum;
    for (int i = tail_ptr_q; i < queue_size(k); ++i) sum += queue_q[i].len_m1 + 1;
    return sum + tail_len_q + 1;
  }
  /// The head sheds an entry unless it is eaten.
  bool splitting(const knobs& k) const {
    return head_len_q >= 1 << k.fifo_short_length_bits && tail_ptr_q != 0;
  }
  /// Pixels that the beam can consume, without an offer, while nothing else happens than count_down
  /// and the display stays; if not splitting().
  int quiet_pixels(const knobs& k) const {
    return head_only(k) ? head_len_q + (1 << (HeadBits - 1)) : tail_len_q;
  }
  /// Up to quiet_pixels() clocks with consume at once, and any number without.
  void count_down(int pixels, const knobs& k) {
    if (head_only(k)) head_len_q -= pixels;
    hold(pixels, k);
  }
  /// The same number of clocks with consume in reset.
  void hold(int pixels, const knobs& k) {
    tail_len_q = (tail_len_q - pixels) & low_bits(k.fifo_short_length_bits);
  }
  bool operator==(const interval_fifo_core& other) const {
    const auto all = [](const interval_fifo_core& c) {
      return std::tie(c.head_value_q, c.head_len_q, c.tail_value_q, c.tail_len_q, c.tail_ptr_q);
    };
    return all(*this) == all(other) &&
           std::equal(std::begin(queue_q), std::end(queue_q), std::begin(other.queue_q),
                      [](const entry& a, const entry& b) {
                        return a.len_m1 == b.len_m1 && a.value == b.value;
                      });
  }

  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in, const knobs& k) const {
    return !in.tracer_reset && !in.consume && !in.emit &&
           (head_len_q < 1 << k.fifo_short_length_bits || tail_ptr_q == 0);
  }
  /// Offer accepted in this clock.
  bool ack(const inputs& in, const knobs& k) const {
    const auto m = move(in, k);
    return m.merge || m.take;
  }
  void clock(const inputs& in, const knobs& k) {
    const auto m = move(in, k);
    const bool only = head_only(k);
    const bool eat_entry = tail_len_q == 0 && in.consume && !only;
    const bool add = m.split || m.take;
    const int short_max = low_bits(k.fifo_short_length_bits);
    const entry pushed{m.split ? short_max : head_len_q & short_max, head_value_q};
    const int size = queue_size(k);

    if (eat_entry || (only && add)) {
      const entry next = tail_ptr_q >= size ? pushed : queue_q[tail_ptr_q];
      tail_len_q = next.len_m1;
      tail_value_q = next.value;
    } else {
      tail_len_q = (tail_len_q - in.consume) & short_max;
    }
    if (add) {
      for (int i = 0; i + 1 < size; ++i) queue_q[i] = queue_q[i + 1];
      queue_q[size - 1] = pushed;
    }
    tail_ptr_q += eat_entry - add;
    if (m.eat_head || m.split || m.merge) head_len_q = m.sum;
    if (m.take) head_len_q = in.len_m1;
    if (m.merge || m.take) head_value_q = in.value;
    if (in.tracer_reset) {
      head_value_q = head_len_q = 0;
      tail_ptr_q = size + 1;
    }
  }
  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const knobs& k) const {
    visit("head_len_q", HeadBits, [this] { return head_len_q; });
    const int value_bits = k.dithering == DitheringCheckered ? 3 : 2;
    visit("head_value_q", value_bits, [this] { return head_value_q; });
    visit("tail_len_q", k.fifo_short_length_bits, [this] { return tail_len_q; });
    visit("tail_value_q", value_bits, [this] { return tail_value_q; });
    visit("tail_ptr_q", count_bits(k.fifo_entries), [this] { return tail_ptr_q; });
    for (int n = 0; n < queue_size(k); ++n)
      visit(element("queue_q", n), k.fifo_short_length_bits + value_bits,
            [this, n, value_bits] { return queue_q[n].len_m1 << value_bits | queue_q[n].value; });
  }

 private:
  struct head_move {
    bool eat_head = false, split = false, merge = false, take = false;
    int sum = 0;
  };
  head_move move(const inputs& in, const knobs& k) const {
    head_move m;
    const bool full = tail_ptr_q == 0;
    const int short_size = 1 << k.fifo_short_length_bits;
    m.eat_head = head_only(k) && in.consume;
    m.split = !m.eat_head && head_len_q >= short_size && !full;
    if (!m.eat_head && !m.split && !in.emit) return m;
    m.sum = wrap_signed(head_len_q + (m.eat_head ? -1
                                      : m.split  ? -short_size
                                                 : in.len_m1 + 1),
                        HeadBits);
    if (m.eat_head || m.split) return m;
    const bool overflow = head_len_q >= 0 && m.sum < 0;
    m.merge = ((k.fifo_merge && in.value == head_value_q) || starving(k)) && !overflow;
    m.take = !m.merge && !full;
    return m;
  }
};

/// Pins of interval_fifo.
class interval_fifo_pins : public sc_core::sc_module {
 public:
  // Clock; phase of the line
  in_port<1> clk_i{"clk_i"};
  in_port<1> tracer_reset_i{"tracer_reset_i"};
  // subdivider and pixel_output: the interval on offer
  in_port<1> emit_i{"emit_i"};
  in_port<PixelBits> len_m1_i{"len_m1_i"};  // pixels minus one
  in_port<2> value_i{"value_i"};            // colour index
  in_port<1> half_i{"half_i", OfKnob};      // checkered: half a tone more
  out_port<1> ack_o{"ack_o"};               // taken in this clock
  out_port<1> starving_o{"starving_o"};     // nothing left to show
  // Beam
  in_port<1> consume_i{"consume_i"};   // last clock of a column
  out_port<2> display_o{"display_o"};  // colour index on show
  out_port<1> display_half_o{"display_half_o", OfKnob};
  // For statistics
  out_port<7> fill_o{"fill_o"};  // entries in use

  explicit interval_fifo_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of interval_fifo: its core behind the pins.
class interval_fifo : public interval_fifo_pins, public probed {
 public:
  using pins = interval_fifo_pins;
  static constexpr const char* unit_name = "interval_fifo";

  interval_fifo(const sc_core::sc_module_name& name, const knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void start_of_simulation() override { drive(); }
  void seq();
  void comb();
  void drive();
  interval_fifo_core::inputs inputs() const;

  const knobs knobs_;
  interval_fifo_core core_;
  sc_core::sc_event_or_list offer_events_;
};

}  // namespace racebeam
