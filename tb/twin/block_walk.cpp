// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/block_walk.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>

#include "sc/base/fixed_point.h"
#include "sc/block/codes.h"
#include "sc/block/numbers.h"
#include "tb/twin/block_twins.h"

namespace racebeam {

BlockWalk::BlockWalk(UnitBench& bench, const knob_values& k, unsigned seed)
    : bench_(bench), knobs_(k), legal_(block_inputs_of(k)), random_(seed) {}

int BlockWalk::drive(const char* port, std::uint64_t value) {
  UnitBench::Pin& pin = bench_[port];
  const std::uint64_t legal = legal_.of(pin.name, raw_bits(value, pin.bits));
  pin.drive(legal);
  return static_cast<int>(legal);
}

void BlockWalk::drive(const Write& write) {
  drive("field_i", static_cast<std::uint64_t>(write.field));
  drive("index_i", static_cast<std::uint64_t>(write.index));
  drive("value_i", write.value);
  drive("eye_k_i", write.eye_k);
}

// Jobs come at once; another world with each, and a sphere's number now and then.
void BlockWalk::next() {
  bench_["rst_ni"].drive(begun_);
  const bool idle = !begun_ || !bench_["busy_o"].value();
  if (idle && !waits_) choose_world();
  waits_ = idle;
  begun_ = true;
  drive("job_valid_i", writes_.empty());
  drive("word_ready_i", below(8) > 0);
  if (!writes_.empty()) {
    drive("write_i", 1);
    drive(writes_.front());
    return writes_.pop_front();
  }
  drive("write_i", misses_ == 0 && below(4) == 0);
  const auto field = random_(), index = random_();  // in this order, whatever compiles it
  const std::uint64_t value = number(), eye_k = number();
  drive({static_cast<int>(field & low_bits(BlockFieldBits)),
         static_cast<int>(index & (below(2) ? 3 : BlockEntries - 1)), value, eye_k});
}

// Within 2.0 of 0, of any size, or where a colour's channel begins to be another.
std::uint64_t BlockWalk::number() {
  constexpr int ChannelBits = 8;
  const std::uint64_t any = random_();
  switch (alike_ ? 2 : below(4)) {
    case 0: return any >> below(BlockBits);
    case 1: return ((any >> ChannelBits) << (BlockFraction - ChannelBits)) - 1 + any % 3;
    default: return static_cast<std::uint64_t>(around(2)) >> scale_;
  }
}

void BlockWalk::choose_world() {
  if (misses_ == 0 && std::exchange(drawn_, false)) begin_misses();
  drawn_ = misses_ == 0;
  choose_block();
  if (misses_ > 0) choose_misses();
}

// The eye is 2.0 before the screen at most, and pixels are small.
void BlockWalk::choose_block() {
  constexpr int Spheres[] = {0, 1, 2, 4, 9};
  scale_ = below(2) ? below(BlockFraction + 2) : 0;
  alike_ = below(2);
  job_x_ = drive("job_x_i", random_());
  job_y_ = drive("job_y_i", random_());
  drive("spheres_i", static_cast<std::uint64_t>(Spheres[below(std::size(Spheres))]));
  for (const char* port : {"eye_x_i", "eye_y_i", "eye_z_i", "light_x_i", "light_y_i", "light_z_i"})
    drive(port, static_cast<std::uint64_t>(around(2) >> scale_));
  start_ = {around(2) >> scale_, around(2) >> scale_, below(2 * Unit) >> (misses_ ? scale_ : 0)};
  for (int n = 0; n < 3; ++n)
    drive(std::array{"start_x_i", "start_y_i", "start_z_i"}[n],
          static_cast<std::uint64_t>(start_[n]));
  ax_ = below(Unit / 256);
  ay_ = below(Unit / 256);
  if (misses_ > 0 && below(2)) ax_ = ay_ = 0;  // all four corners are one
  drive("ax_i", static_cast<std::uint64_t>(ax_));
  drive("ay_i", static_cast<std::uint64_t>(ay_));
}

void BlockWalk::begin_misses() {
  constexpr int Blocks = 32, Spheres[] = {4, 16, BlockEntries, BlockEntries};
  misses_ = Blocks;
  poses_.resize(static_cast<std::size_t>(Spheres[below(std::size(Spheres))]));
  for (std::size_t n = 0; n < poses_.size(); ++n) {
    const int scale = below(2) ? below(BlockFraction + 2) : 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int eye_k = around(2), pose = around(4) >> scale;
      poses_[n][axis] = pose;
      writes_.push_back({BlockCentreX + axis, static_cast<int>(n),
                         static_cast<std::uint64_t>(eye_k - pose),
                         static_cast<std::uint64_t>(eye_k)});
    }
  }
}

// At the corner that is nearest to it a sphere's discriminant is 0 or -1; of a few blocks one
// sphere's is 1 there, or 8.0 and more, the root of which begins anew.
void BlockWalk::choose_misses() {
  --misses_;
  drive("spheres_i", poses_.size());
  const int x = wrap32(start_[0] + std::int64_t{job_x_} * ax_), right = wrap32(x + 15 * ax_);
  const int y = wrap32(start_[1] - std::int64_t{job_y_} * ay_), low = wrap32(y - 15 * ay_);
  std::array<vec3, 4> corners{
      {{x, y, start_[2]}, {x, low, start_[2]}, {right, low, start_[2]}, {right, y, start_[2]}}};
  for (vec3& corner : corners) corner = inormalize(corner, knobs_.newton_steps);
  const int meets = below(32) ? -1 : below(static_cast<int>(poses_.size()));
  for (int n = 0; n < static_cast<int>(poses_.size()); ++n) {
    int square = std::numeric_limits<int>::min();
    for (const vec3& corner : corners) {
      const int b = idot(poses_[static_cast<std::size_t>(n)], corner);
      square = std::max(square, imul(b, b));
    }
    const int d = n == meets ? below(4) << BlockRootBits | below(2) : -(below(4) == 0);
    writes_.push_back({BlockRv, n, static_cast<std::uint64_t>(block_difference(d, square)), 0});
  }
}

DealWalk::DealWalk(UnitBench& bench, const knob_values& k, unsigned seed)
    : bench_(bench), legal_(block_inputs_of(k)), random_(seed) {}

// A core is free in one clock of four.
void DealWalk::next() {
  bench_["rst_ni"].drive(begun_);
  begun_ = true;
  bench_["start_i"].drive(random_() % 4 == 0);
  bench_["job_ready_i"].drive(random_() & random_());
  bench_["busy_i"].drive(random_() & random_() & random_());
  for (const char* port : {"width_i", "height_i"}) bench_[port].drive(legal_.of(port, 0));
}

}  // namespace racebeam
