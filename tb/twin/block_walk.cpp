// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/block_walk.h"

#include <iterator>

#include "sc/base/fixed_point.h"
#include "sc/block/codes.h"
#include "tb/twin/block_twins.h"

namespace racebeam {

BlockWalk::BlockWalk(UnitBench& bench, const knob_values& k, unsigned seed)
    : bench_(bench), legal_(block_inputs_of(k)), random_(seed) {}

void BlockWalk::drive(const char* port, std::uint64_t value) {
  UnitBench::Pin& pin = bench_[port];
  pin.drive(legal_.of(pin.name, raw_bits(value, pin.bits)));
}

// Jobs come at once; another world with each, and a sphere's number now and then.
void BlockWalk::next() {
  bench_["rst_ni"].drive(begun_);
  if (!begun_ || !bench_["busy_o"].value()) choose_world();
  begun_ = true;
  drive("job_valid_i", 1);
  drive("word_ready_i", below(8) > 0);
  drive("write_i", below(4) == 0);
  drive("field_i", random_());
  const auto index = random_();  // in this order, whatever compiles it
  drive("index_i", index & (below(2) ? 3 : BlockEntries - 1));
  drive("value_i", number());
  drive("eye_k_i", number());
}

// Within 2.0 of 0, of any size, or where a colour's channel begins to be another.
std::uint64_t BlockWalk::number() {
  constexpr int Unit = 1 << BlockFraction, ChannelBits = 8;
  const std::uint64_t any = random_();
  switch (alike_ ? 2 : below(4)) {
    case 0: return any >> below(BlockBits);
    case 1: return ((any >> ChannelBits) << (BlockFraction - ChannelBits)) - 1 + any % 3;
    default: return static_cast<std::uint64_t>(below(4 * Unit) - 2 * Unit) >> scale_;
  }
}

// The eye is 2.0 before the screen at most, and pixels are small.
void BlockWalk::choose_world() {
  constexpr int Unit = 1 << BlockFraction;
  constexpr int Spheres[] = {0, 1, 2, 4, 9};
  scale_ = below(2) ? below(BlockFraction + 2) : 0;
  alike_ = below(2);
  drive("job_x_i", random_());
  drive("job_y_i", random_());
  drive("spheres_i", static_cast<std::uint64_t>(Spheres[below(std::size(Spheres))]));
  for (const char* port : {"eye_x_i", "eye_y_i", "eye_z_i", "light_x_i", "light_y_i", "light_z_i",
                           "start_x_i", "start_y_i"})
    drive(port, static_cast<std::uint64_t>((below(4 * Unit) - 2 * Unit) >> scale_));
  drive("start_z_i", static_cast<std::uint64_t>(below(2 * Unit)));
  drive("ax_i", static_cast<std::uint64_t>(below(Unit / 256)));
  drive("ay_i", static_cast<std::uint64_t>(below(Unit / 256)));
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
