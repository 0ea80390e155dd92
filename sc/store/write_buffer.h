// write_buffer: words on their way from the tracer to the frame store.
//
// What    a circular FIFO of {address, data}. A word is put in a clock in which put_valid_i and
//         put_ready_o are 1, and taken in a clock in which take_valid_o and take_ready_i are 1, the
//         oldest first. Stall: put_ready_o is 0 while the buffer is full and nothing is taken in
//         the same clock. Drop: put_ready_o is always 1, and a word that finds the buffer full
//         while nothing is taken empties it and stays alone in it: head runs past tail.
// Size    write_buffer_depth entries of address_bits + data_bits bits, the low ones of the ports;
//         head, where the next word goes, and tail, the oldest, of $clog2(depth) bits, at least
//         one, each back to 0 after depth - 1; and full, which tells head = tail of a full buffer
//         from that of an empty one.
// Cycles  a word put is on take_* from the next clock on. One word in and one out a clock.
// Comb    take_ready_i -> put_ready_o (stall only). take_valid_o, take_address_o, take_data_o,
//         fill_o: registers only.
// Stall   take_address_o and take_data_o hold until taken. They are the entry at tail, also while
//         take_valid_o is 0.
// Reset   empty (rst_ni); nothing is put or taken in a clock with rst_ni = 0, whatever the
//         handshakes say. Entries are 0 at power-up, never cleared.
// Knobs   write_buffer_depth, when_full; address_bits, data_bits.
// Twin    rtl/store/write_buffer.sv: WriteBufferDepth, WhenFull, AddressBits, DataBits
// Test    tests/store/write_buffer_test.cpp
// Source  FPGA sphere tracer: 64 entries, pointers of 6 bits that nobody compares (drop).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

/// Behaviour of write_buffer.
struct write_buffer_core {
  struct entry {
    int address;
    std::uint64_t data;
  };
  entry entries_q[MaxWriteBuffer]{};
  int head_q = 0, tail_q = 0;
  bool full_q = false;

  struct inputs {
    bool rst_n, put_valid;
    entry put;
    bool take_ready;
  };

  bool take_valid() const { return full_q || head_q != tail_q; }
  const entry& take() const { return entries_q[tail_q]; }
  bool put_ready(bool take_ready, const store_knobs& k) const {
    return k.when_full == WhenFullDrop || !full_q || take_ready;
  }
  /// Words that it holds, 0..depth.
  int fill(const store_knobs& k) const {
    if (full_q) return k.write_buffer_depth;
    return head_q >= tail_q ? head_q - tail_q : head_q - tail_q + k.write_buffer_depth;
  }
  /// Words that are lost in this clock.
  int lost(const inputs& in, const store_knobs& k) const {
    const bool runs_past = in.rst_n && in.put_valid && full_q && !in.take_ready;
    return runs_past && k.when_full == WhenFullDrop ? k.write_buffer_depth : 0;
  }

  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in) const {
    return in.rst_n && !in.put_valid && !(in.take_ready && take_valid());
  }
  void clock(const inputs& in, const store_knobs& k) {
    if (!in.rst_n) {
      head_q = tail_q = 0;
      full_q = false;
      return;
    }
    const bool put = in.put_valid && put_ready(in.take_ready, k);
    const bool take = take_valid() && in.take_ready;
    if (put) {
      entries_q[head_q] = {static_cast<int>(raw_bits(in.put.address, k.address_bits())),
                           raw_bits(in.put.data, k.data_bits())};
      head_q = next(head_q, k);
    }
    if (take) tail_q = next(tail_q, k);
    // Dropping, head has run past tail: not full any more.
    if (put != take) full_q = put && head_q == tail_q;
  }

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const store_knobs& k) const {
    const int pointer_bits = std::max(1, count_bits(k.write_buffer_depth));
    visit("head_q", pointer_bits, [this] { return head_q; });
    visit("tail_q", pointer_bits, [this] { return tail_q; });
    visit("full_q", 1, [this] { return full_q; });
    for (int n = 0; n < k.write_buffer_depth; ++n) {
      visit(element("addresses_q", n), k.address_bits(),
            [this, n] { return entries_q[n].address; });
      visit(element("datas_q", n), k.data_bits(), [this, n] { return entries_q[n].data; });
    }
  }

 private:
  static int next(int pointer, const store_knobs& k) {
    return pointer == k.write_buffer_depth - 1 ? 0 : pointer + 1;
  }
};

/// Pins of write_buffer.
class write_buffer_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // Tracer
  in_port<1> put_valid_i{"put_valid_i"};
  in_port<StoreAddressBits> put_address_i{"put_address_i"};
  in_port<StoreDataBits> put_data_i{"put_data_i"};
  out_port<1> put_ready_o{"put_ready_o"};
  // store_arbiter
  out_port<1> take_valid_o{"take_valid_o"};
  out_port<StoreAddressBits> take_address_o{"take_address_o"};
  out_port<StoreDataBits> take_data_o{"take_data_o"};
  in_port<1> take_ready_i{"take_ready_i"};
  // For statistics
  out_port<8> fill_o{"fill_o"};  // words in it

  explicit write_buffer_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of write_buffer: its core behind the pins.
class write_buffer : public write_buffer_pins, public probed {
 public:
  using pins = write_buffer_pins;
  static constexpr const char* unit_name = "write_buffer";

  write_buffer(const sc_core::sc_module_name& name, const store_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void comb();

  const store_knobs knobs_;
  write_buffer_core core_;
};

}  // namespace racebeam
