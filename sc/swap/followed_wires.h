// followed_wires: inputs of verilated RTL that take what wires of the chip have.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/unit.h"
#include "sc/swap/rtl_model.h"

namespace racebeam {

class followed_wires {
 public:
  /// Both of as many bits; they live as long.
  void add(const wire_contents& wire, const rtl_port& port) {
    switch (port.bytes) {
      case 1: return bytes_.add(wire, port);
      case 2: return halves_.add(wire, port);
      case 4: return words_.add(wire, port);
      default: return doubles_.add(wire, port);
    }
  }
  /// Copies all; whether one has moved.
  bool take() { return bytes_.take() | halves_.take() | words_.take() | doubles_.take(); }
  bool empty() const {
    return bytes_.empty() && halves_.empty() && words_.empty() && doubles_.empty();
  }

 private:
  /// Ports of one size, without a branch for each.
  template <class Raw>
  class alike {
   public:
    void add(const wire_contents& wire, const rtl_port& port) {
      Raw* data = static_cast<Raw*>(port.data);
      if (wire.bit) bits_.push_back({wire.bit, data});
      else words_.push_back({wire.word, data});
    }
    bool take() {
      Raw moved = 0;
      for (const auto& [wire, data] : bits_) {
        const Raw now = *wire;
        moved = static_cast<Raw>(moved | (now ^ *data));
        *data = now;
      }
      for (const auto& [wire, data] : words_) {
        const Raw now = static_cast<Raw>(wire->value());
        moved = static_cast<Raw>(moved | (now ^ *data));
        *data = now;
      }
      return moved != 0;
    }
    bool empty() const { return bits_.empty() && words_.empty(); }

   private:
    template <class Wire>
    struct joint {
      const Wire* wire;
      Raw* data;
    };
    std::vector<joint<bool>> bits_;
    std::vector<joint<sc_dt::sc_uint_base>> words_;
  };

  alike<std::uint8_t> bytes_;
  alike<std::uint16_t> halves_;
  alike<std::uint32_t> words_;
  alike<std::uint64_t> doubles_;
};

}  // namespace racebeam
