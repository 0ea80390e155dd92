// frame_memory: the frame store itself, a synchronous memory with one port, outside of the chip.
//
// What    in each clock it writes mem_data_i to mem_address_i if mem_write_i is 1, else it reads.
// Size    2^address_bits words of data_bits bits, the low ones of the ports.
// Cycles  a word read is on mem_data_o in the next clock, and stays while others are written.
// Comb    none.
// Stall   none.
// Reset   none; 0 at power-up.
// Knobs   address_bits, data_bits.
// Twin    none: model only.
// Test    tests/store/frame_memory_test.cpp
// Source  SRAM of the FPGA sphere tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sc/base/fixed_point.h"
#include "sc/base/unit.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

/// Behaviour of frame_memory.
struct frame_memory_core {
  std::vector<std::uint64_t> words_q;
  std::uint64_t data_q = 0;  // the word read last

  struct inputs {
    bool write;
    int address;
    std::uint64_t data;
  };

  explicit frame_memory_core(const store_knobs& k) : words_q(std::size_t{1} << k.address_bits()) {}

  void clock(const inputs& in, const store_knobs& k) {
    std::uint64_t& word = words_q[raw_bits(in.address, k.address_bits())];
    if (in.write) word = raw_bits(in.data, k.data_bits());
    else data_q = word;
  }
};

/// Pins of frame_memory.
class frame_memory_pins : public sc_core::sc_module {
 public:
  // Clock
  in_port<1> clk_i{"clk_i"};
  // store_arbiter
  in_port<1> mem_write_i{"mem_write_i"};
  in_port<StoreAddressBits> mem_address_i{"mem_address_i"};
  in_port<StoreDataBits> mem_data_i{"mem_data_i"};
  // frame_scanout
  out_port<StoreDataBits> mem_data_o{"mem_data_o"};

  explicit frame_memory_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of frame_memory: its core behind the pins.
class frame_memory : public frame_memory_pins {
 public:
  using pins = frame_memory_pins;
  static constexpr const char* unit_name = "frame_memory";

  frame_memory(const sc_core::sc_module_name& name, const store_knobs& k);

  /// All words, by address: what the bench sees of a picture, and may put there.
  const std::vector<std::uint64_t>& words() const { return core_.words_q; }
  void deposit(int address, std::uint64_t word) { core_.words_q.at(address) = word; }
  void clear() { std::fill(core_.words_q.begin(), core_.words_q.end(), 0); }

 private:
  void seq();

  const store_knobs knobs_;
  frame_memory_core core_;
};

}  // namespace racebeam
