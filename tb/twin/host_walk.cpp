// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/host_walk.h"

#include "sc/base/fixed_point.h"

namespace racebeam {

// What a CPU sends when nobody listens, and takes back, is no word; and nobody listens when the
// last clock of patience would come. The scene changes with pictures. What it sends first is an
// entry beyond the last one. After the last picture the link is reset, and waits anew.
void HostWalk::next() {
  constexpr std::uint64_t LastReset = Clocks - 100;
  bench_["rst_ni"].drive(clock_ > 0 && clock_ != FirstReset && clock_ != LastReset);
  const bool waits = !one_in(8) && listened_ != HostPatience - 1;
  listened_ += clock_ > FirstReset && (waits || listened_ == HostPatience - 1);
  bench_["host_i"].drive(waits);
  const bool comes = clock_ < FirstReset || clock_ > Silence;
  bench_["valid_i"].drive((!waits || comes) && one_in(4));
  if (bench_["loaded_o"].value()) bench_["scene_i"].drive(one_in(2));
  for (UnitBench::Pin* pin : bench_.pins())
    if (pin->input && pin->bits > 1) pin->drive(raw_bits(random_(), pin->bits));
  if (clock_ > Silence && clock_ < Silence + 16) bench_["sphere_i"].drive(0xef);
  ++clock_;
}

}  // namespace racebeam
