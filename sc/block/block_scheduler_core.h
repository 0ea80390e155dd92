// Behaviour of block_scheduler (block_scheduler.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

struct block_scheduler_core {
  bool deals_q = false;
  int job_x_q = 0, job_y_q = 0;

  struct inputs {
    bool rst_n, start;
    int width, height;
    std::uint64_t ready;
  };

  std::uint64_t valid(std::uint64_t ready, const block_knobs& k) const {
    const std::uint64_t there = raw_bits(ready, k.cores);
    return deals_q ? there & (~there + 1) : 0;
  }
  bool done(std::uint64_t busy, const block_knobs& k) const {
    return !deals_q && raw_bits(busy, k.cores) == 0;
  }
  /// From the second clock with these inputs on nothing changes.
  bool idle(const inputs& in, const block_knobs& k) const {
    return in.rst_n && (deals_q ? !valid(in.ready, k) : !in.start);
  }
  void clock(const inputs& in, const block_knobs& k) {
    if (!in.rst_n) {
      *this = {};
    } else if (!deals_q) {
      deals_q = in.start;
      job_x_q = job_y_q = 0;
    } else if (valid(in.ready, k)) {
      const bool last_column = job_x_q + BlockSide >= in.width;
      if (last_column && job_y_q + BlockSide >= in.height) deals_q = false;
      if (last_column) job_y_q = (job_y_q + BlockSide) & low_bits(BlockPlaceBits);
      job_x_q = last_column ? 0 : (job_x_q + BlockSide) & low_bits(BlockPlaceBits);
    }
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("deals_q", 1, [this] { return deals_q; });
    visit("job_x_q", BlockPlaceBits, [this] { return job_x_q; });
    visit("job_y_q", BlockPlaceBits, [this] { return job_y_q; });
  }
};

}  // namespace racebeam
