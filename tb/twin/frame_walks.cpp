// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/frame_walks.h"

#include "sc/beam/knob_parameters.h"
#include "tb/twin/beam_twins.h"

namespace racebeam {

FramesWalk::FramesWalk(UnitBench& bench, const knob_values& k, unsigned seed)
    : bench_(bench), legal_(beam_inputs(k)), random_(seed) {}

void FramesWalk::next() {
  bench_["rst_ni"].drive(clock_ > 0);
  bench_["frame_end_i"].drive(clock_ % FrameClocks == FrameClocks - 1);
  for (const char* port : {"run_i", "src_i", "dr2_y_i", "y_i"}) {
    UnitBench::Pin& pin = bench_[port];
    pin.drive(legal_.of(pin.name, raw_bits(random_(), pin.bits)));
  }
  ++clock_;
}

// The speed of most frames on the screen, the highest, or any; the two lines of the sync are too
// few for that.
void FrameWalk::next() {
  constexpr int LongestSpeed = 6000, Speeds = 8;
  bench_["rst_ni"].drive(clock_ != 0 && clock_ != SecondReset);
  ++clock_;
  const std::uint64_t line = bench_["y_o"].value();
  if (line == LastLine - 1) return bench_["speed_i"].drive(0);
  if (line == LastLine) return bench_["speed_i"].drive(Speeds - 1);
  if (left_-- > 0) return;
  left_ = below(LongestSpeed);
  switch (below(3)) {
    case 0: bench_["speed_i"].drive(0); break;
    case 1: bench_["speed_i"].drive(Speeds - 1); break;
    default: bench_["speed_i"].drive(static_cast<std::uint64_t>(below(Speeds))); break;
  }
}

}  // namespace racebeam
