// changed_ports: which ports of verilated RTL have another value than before.
//
// Who drives or shows many outputs asks after each evaluation, and few have changed. A verilated
// class has its ports side by side: eight bytes are looked at together, and the first byte that
// differs says which port it is.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "sc/swap/rtl_model.h"

namespace racebeam {

/// A port's bits.
inline std::uint64_t port_value(const rtl_port& port) {
  switch (port.bytes) {
    case 1: return *static_cast<const std::uint8_t*>(port.data);
    case 2: return *static_cast<const std::uint16_t*>(port.data);
    case 4: return *static_cast<const std::uint32_t*>(port.data);
    default: return *static_cast<const std::uint64_t*>(port.data);
  }
}

class changed_ports {
 public:
  changed_ports() = default;
  /// Of ports that live as long; each is called by its place among them.
  explicit changed_ports(const std::vector<const rtl_port*>& ports) {
    std::map<const char*, std::pair<word, parts>> words;  // by where they begin
    for (std::size_t n = 0; n < ports.size(); ++n) {
      const char* data = static_cast<const char*>(ports[n]->data);
      const std::size_t offset = reinterpret_cast<std::uintptr_t>(data) % sizeof(std::uint64_t);
      auto& [in, of] = words[data - offset];
      in.data = data - offset;
      const auto bytes = static_cast<std::size_t>(ports[n]->bytes);
      for (std::size_t at = offset; at < offset + bytes; ++at)
        of[at] = {n, static_cast<unsigned>(8 * offset), low_bits(8 * bytes)};
      in.mask |= low_bits(8 * bytes) << 8 * offset;
    }
    for (const auto& [begin, both] : words) {
      words_.push_back(both.first);
      parts_.push_back(both.second);
    }
  }

  /// Calls changed(n, value) for each port whose value is not that of the last time; at first: 0.
  template <class Changed>
  void visit(const Changed& changed) {
    for (std::size_t w = 0; w < words_.size(); ++w) {
      word& in = words_[w];
      std::uint64_t now = 0;  // the machine's bytes begin with the lowest
      std::memcpy(&now, in.data, sizeof now);
      for (std::uint64_t moved; (moved = (now ^ in.last) & in.mask) != 0;) {
        const part& port = parts_[w][static_cast<unsigned>(__builtin_ctzll(moved)) / 8];
        const std::uint64_t bits = port.mask << port.shift;
        in.last = (in.last & ~bits) | (now & bits);
        changed(port.number, now >> port.shift & port.mask);
      }
    }
  }

 private:
  /// What a byte belongs to.
  struct part {
    std::size_t number;
    unsigned shift;
    std::uint64_t mask;
  };
  using parts = std::array<part, sizeof(std::uint64_t)>;
  /// Eight bytes of the class, aligned, not all of them ports.
  struct word {
    const char* data = nullptr;
    std::uint64_t last = 0, mask = 0;
  };
  static std::uint64_t low_bits(std::size_t bits) {
    return bits < 64 ? (std::uint64_t{1} << bits) - 1 : ~std::uint64_t{0};
  }

  std::vector<word> words_;
  std::vector<parts> parts_;  // of each word
};

}  // namespace racebeam
