// Behaviour of column_memory (column_memory.h) and occupancy_memory (occupancy_memory.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace racebeam {

struct voxel_memory_core {
  std::vector<std::uint32_t> words_q;
  std::vector<std::uint32_t> data_q;  // on their way out; the first is on data_o

  struct inputs {
    bool read, write;
    std::uint32_t address, data;
  };

  voxel_memory_core(std::size_t words, int clocks)
      : words_q(words), data_q(static_cast<std::size_t>(clocks)) {}

  std::uint32_t data() const { return data_q.front(); }
  /// With these inputs nothing changes.
  bool idle(const inputs& in) const {
    return !in.read && !in.write &&
           std::all_of(data_q.begin(), data_q.end(),
                       [this](std::uint32_t d) { return d == data(); });
  }
  void clock(const inputs& in) {
    std::uint32_t next = data_q.back();
    if (in.address < words_q.size()) {
      if (in.write) words_q[in.address] = in.data;
      else if (in.read) next = words_q[in.address];
    } else if (in.read && !in.write) {
      next = 0;
    }
    std::move(data_q.begin() + 1, data_q.end(), data_q.begin());
    data_q.back() = next;
  }
};

}  // namespace racebeam
