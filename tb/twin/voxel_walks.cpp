// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/voxel_walks.h"

#include "sc/base/fixed_point.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"

namespace racebeam {

namespace {

constexpr int LongestInverse = VoxelInverseBits - VoxelInverseFraction - 1;  // 2 to that

}  // namespace

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

void RayWalk::next() {
  bench_["rst_ni"].drive(begun_ && !one_in(4096));
  if (left_-- <= 0 || !begun_) begin_ray();
  begun_ = true;
  const std::string axes = "xyz";
  if (one_in(16)) drive(std::string("inverse_") + axes[below(3)] + "_i", inverse());
  if (one_in(2))
    for (const char axis : axes) drive(std::string("position_") + axis + "_i", coordinate());
  if (one_in(2)) drive("data_i", below(4) < filled_ ? -1 : one_in(2) ? 0 : random_());
  drive("bit_i", random_());
  drive("inside_i", !one_in(16));
  for (const char* flag : {"start_i", "some_i", "sample_i"}) drive(flag, one_in(2));
  for (const char* flag : {"shadow_i", "hit_i", "done_i"}) drive(flag, one_in(4));
  drive("reached_i", one_in(limited_));
}

void RayWalk::begin_ray() {
  left_ = 20 + below(one_in(2) ? 40 : 400);
  filled_ = below(5);
  limited_ = 1 << 2 * below(6);
  const bool alike = one_in(2);
  const std::int64_t all = inverse(), whole = std::int64_t{1} << VoxelInverseFraction;
  const std::int64_t steep = one_in(4) ? whole << LongestInverse : whole;
  for (const std::string axis : {"x", "y", "z"}) {
    drive("origin_" + axis + "_i", coordinate());
    drive("direction_" + axis + "_i", direction());
    drive("light_" + axis + "_i", direction());
    drive("inverse_" + axis + "_i", one_in(2) ? steep : alike ? all : inverse());
  }
}

void RayWalk::drive(const std::string& port, std::int64_t value) {
  UnitBench::Pin& pin = bench_[port];
  pin.drive(raw_bits(static_cast<std::uint64_t>(value), pin.bits));
}

// In the world, at its border or beyond it, at the ends of numbers, or anywhere; at a border of a
// unit, beside it, or not.
std::int64_t RayWalk::coordinate() {
  if (one_in(12)) return random_();
  const std::int64_t end = std::int64_t{1} << (VoxelPositionBits - VoxelPositionFraction - 1);
  const std::int64_t places[] = {
      below(64), below(64), below(8), 32, 31, -1 - below(64), std::int64_t{1} << below(15),
      -end,      end - 1};
  const std::int64_t beside[] = {0, 0, 1, -1, below(1 << VoxelPositionFraction)};
  return places[below(9)] * (1 << VoxelPositionFraction) + beside[below(5)];
}

// Parallel to an axis, or almost, or but for one bit; or long enough for an inverse.
std::int64_t RayWalk::direction() {
  const std::int64_t sizes[] = {0,
                                VoxelParallel - 1,
                                VoxelParallel,
                                below(2 * VoxelParallel),
                                (1 << below(VoxelDirectionBits)) + below(2 * VoxelParallel),
                                std::int64_t{1} << VoxelDirectionFraction,
                                static_cast<std::int64_t>(random_() >> below(32))};
  const std::int64_t size = sizes[below(7)];
  return one_in(2) ? size : -size;
}

std::int64_t RayWalk::inverse() {
  const std::int64_t whole = std::int64_t{1} << VoxelInverseFraction;
  const std::int64_t sizes[] = {whole,
                                whole + 1,
                                whole - 1,
                                whole << below(LongestInverse + 1),
                                whole / 2,
                                0,
                                static_cast<std::int64_t>(random_() >> below(32))};
  return sizes[below(7)];
}

}  // namespace racebeam
