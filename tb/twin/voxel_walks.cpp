// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/voxel_walks.h"

#include "sc/base/fixed_point.h"
#include "sc/voxel/knobs.h"

namespace racebeam {

BuildWalk::BuildWalk(UnitBench& bench, const knob_values& k, unsigned seed)
    : bench_(bench),
      size_x_(voxel_knobs(k).size_x),
      size_y_(voxel_knobs(k).size_y),
      random_(seed) {}

// Few columns have anything: what is set costs a read and a write. Behind the world some builds end
// in a reset.
void BuildWalk::next() {
  constexpr int Seldom = 2048;
  for (UnitBench::Pin* pin : bench_.pins())
    if (pin->input) pin->drive(raw_bits(random_(), pin->bits));
  if (below(8) > 0) bench_["column_data_i"].drive(0);
  if (below(2) > 0) bench_["occupancy_data_i"].drive(0);
  choose_rectangle();
  bench_["rst_ni"].drive(clock_ > 0 && !(clock_ > World && below(Seldom) == 0));
  bench_["start_i"].drive(clock_ < 2 || below(16) == 0);
  ++clock_;
}

// All of the world, or up to 4 x 4 columns of it; some are empty or go beyond it.
void BuildWalk::choose_rectangle() {
  constexpr int Side = 5;
  const bool all = clock_ < 2;
  const int x = all ? 0 : below(size_x_), y = all ? 0 : below(size_y_);
  bench_["rect_x_low_i"].drive(x);
  bench_["rect_y_low_i"].drive(y);
  bench_["rect_x_high_i"].drive(all ? size_x_ : x + below(Side));
  bench_["rect_y_high_i"].drive(all ? size_y_ : y + below(Side));
}

// Rays end at once, and the buffer is seldom full.
void PictureWalk::next() {
  constexpr int Seldom = 32;
  bench_["rst_ni"].drive(begun_);
  begun_ = true;
  bench_["kind_i"].drive(raw_bits(random_(), bench_["kind_i"].bits));
  bench_["colour_i"].drive(raw_bits(random_(), bench_["colour_i"].bits));
  for (const char* on : {"start_i", "ray_done_i", "done_i", "put_ready_i"})
    bench_[on].drive(!one_in(Seldom));
}

}  // namespace racebeam
