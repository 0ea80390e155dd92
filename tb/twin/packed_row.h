// What the ports of a unit have in a clock, in as few bytes as they need.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "tb/twin/port_traffic.h"

namespace racebeam {

class PackedRow {
 public:
  explicit PackedRow(const std::vector<PortTraffic::Port>& ports) {
    for (const PortTraffic::Port& port : ports) {
      fields_.push_back({bytes_, bytes_of(port.bits)});
      bytes_ += fields_.back().bytes;
    }
  }
  struct Field {
    std::size_t offset, bytes;  ///< 1, 2, 4 or 8 of these
  };
  /// By port.
  const std::vector<Field>& fields() const { return fields_; }
  std::size_t bytes() const { return bytes_; }
  /// Writes bytes() of them. The machine's bytes begin with the lowest.
  void pack(const std::uint64_t* row, char* to) const {
    for (const Field& field : fields_) {
      switch (field.bytes) {
        case 1: std::memcpy(to, row, 1); break;
        case 2: std::memcpy(to, row, 2); break;
        case 4: std::memcpy(to, row, 4); break;
        default: std::memcpy(to, row, 8);
      }
      to += field.bytes;
      ++row;
    }
  }

 private:
  static std::size_t bytes_of(int bits) {
    return bits <= 8 ? 1 : bits <= 16 ? 2 : bits <= 32 ? 4 : 8;
  }
  std::vector<Field> fields_;
  std::size_t bytes_ = 0;
};

}  // namespace racebeam
