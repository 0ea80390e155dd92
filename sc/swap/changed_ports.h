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
      const std::size_t offset = reinterpret_cast<std::uintptr_t>(data) % Bytes;
      auto& [in, made_of] = words[data - offset];
      in.data = data - offset;
      const auto bytes = static_cast<std::size_t>(ports[n]->bytes);
      for (std::size_t at = offset; at < offset + bytes; ++at)
        made_of[at] = {static_cast<std::uint16_t>(n), static_cast<std::uint8_t>(8 * offset),
                       static_cast<std::uint8_t>(8 * (Bytes - bytes))};
      in.mask |= low_bits(8 * (Bytes - bytes)) << 8 * offset;
    }
    for (const auto& [begin, in] : words) {
      words_.push_back(in.first);
      parts_.push_back(in.second);
    }
  }

  /// Calls changed(n, value) for each port whose value is not that of the last time; at first: 0.
  /// Whether there was one.
  template <class Changed>
  bool visit(const Changed& changed) {
    bool any = false;
    for (std::size_t w = 0; w < words_.size(); ++w) {
      word& in = words_[w];
      std::uint64_t now = 0;  // the machine's bytes begin with the lowest
      std::memcpy(&now, in.data, sizeof now);
      std::uint64_t moved = (now ^ in.last) & in.mask;
      if (moved == 0) continue;
      any = true;
      in.last = now;
      while (moved != 0) {
        const part port = parts_[w][static_cast<unsigned>(__builtin_ctzll(moved)) / 8];
        const std::uint64_t bits = low_bits(port.unused);
        moved &= ~(bits << port.shift);
        changed(port.number, now >> port.shift & bits);
      }
    }
    return any;
  }

 private:
  static constexpr std::size_t Bytes = sizeof(std::uint64_t);
  /// What a byte belongs to: which port, the bits below it, and those that it does not fill.
  struct part {
    std::uint16_t number;
    std::uint8_t shift, unused;
  };
  using parts = std::array<part, Bytes>;
  /// Eight bytes of the class, aligned, not all of them ports. Many share a line of the cache: what
  /// they are made of is asked of those that have changed only.
  struct word {
    const char* data = nullptr;
    std::uint64_t last = 0, mask = 0;
  };
  static std::uint64_t low_bits(std::size_t unused) { return ~std::uint64_t{0} >> unused; }

  std::vector<word> words_;
  std::vector<parts> parts_;  // of each word
};

}  // namespace racebeam
