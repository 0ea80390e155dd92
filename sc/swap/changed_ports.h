// changed_ports: which ports of verilated RTL have another value than before.
//
// Who drives or shows many outputs asks after each evaluation, and few have changed. A verilated
// class has its ports side by side: eight bytes are looked at together where ports fill them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
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
    for (std::size_t n = 0; n < ports.size(); ++n) ports_.push_back({ports[n], n, 0});
    std::sort(ports_.begin(), ports_.end(),
              [](const seen_port& a, const seen_port& b) { return a.port->data < b.port->data; });
    for (std::size_t begin = 0, end = 0; begin < ports_.size(); begin = end) {
      int bytes = 0;
      for (; end < ports_.size() && word_of(ports_[end]) == word_of(ports_[begin]); ++end)
        bytes += ports_[end].port->bytes;
      const bool filled = bytes == sizeof(std::uint64_t);
      words_.push_back({filled ? ports_[begin].port->data : nullptr, 0, begin, end});
    }
  }

  /// Calls changed(n, value) for each port whose value is not that of the last time; at first: 0.
  template <class Changed>
  void visit(const Changed& changed) {
    for (word& now : words_) {
      if (now.data) {
        std::uint64_t value = 0;
        std::memcpy(&value, now.data, sizeof value);
        if (value == now.last) continue;
        now.last = value;
      }
      for (std::size_t n = now.begin; n < now.end; ++n) {
        seen_port& one = ports_[n];
        const std::uint64_t value = port_value(*one.port);
        if (value == one.last) continue;
        one.last = value;
        changed(one.number, value);
      }
    }
  }

 private:
  struct seen_port {
    const rtl_port* port;
    std::size_t number;
    std::uint64_t last;
  };
  /// Eight bytes, aligned, and the ports in them. data: nullptr if they do not fill it.
  struct word {
    const void* data;
    std::uint64_t last;
    std::size_t begin, end;
  };
  static std::uintptr_t word_of(const seen_port& one) {
    return reinterpret_cast<std::uintptr_t>(one.port->data) / sizeof(std::uint64_t);
  }

  std::vector<seen_port> ports_;
  std::vector<word> words_;
};

}  // namespace racebeam
