// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/subdivider_walk.h"

#include <algorithm>

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"

namespace racebeam {

void SubdividerWalk::next() {
  constexpr int Line = 500, Filling = 300, Emptying = 60;  // clocks
  const bool resets = !begun_ || one_in(Line);
  begun_ = true;
  bench_["tracer_reset_i"].drive(resets);
  bench_["idx_load_i"].drive(resets && !one_in(4));
  bench_["consume_i"].drive(one_in(2));
  bench_["lock_i"].drive(one_in(Line));
  if (resets) begin_line();
  if (resets || left_-- == 0) {
    pops_ = !resets && !pops_;
    left_ = below(pops_ ? Emptying : Filling);
  }
  answer();
}

// The beam is where the interval ends, which is long, or short enough for a beam that starves.
void SubdividerWalk::begin_line() {
  const int end = one_in(4) ? 1 + below(32) : LastPixel / 2 + below(LastPixel / 4);
  bench_["i2_init_i"].drive(end);
  bench_["idx_start_i"].drive(end);
}

void SubdividerWalk::answer() {
  enum { Left, Right, Bisect, Return };
  const std::uint64_t state = bench_["state_o"].value();
  const int i2 = static_cast<int>(bench_["i2_o"].value());
  const bool noise = one_in(32);
  bench_["mask_i"].drive(noise ? raw_bits(random_(), bench_["mask_i"].bits) : 1);
  bench_["dec_i"].drive(noise ? raw_bits(random_(), bench_["dec_i"].bits)
                              : state == Right && !one_in(8));
  bench_["wall_i"].drive(pops_ || one_in(128));
  bench_["second_i"].drive(one_in(8));
  bench_["ack_i"].drive(!one_in(4));
  bench_["starving_i"].drive(one_in(4));
  bench_["top_i2_i"].drive(std::min(i2 + 2 + below(64), LastPixel));
}

}  // namespace racebeam
