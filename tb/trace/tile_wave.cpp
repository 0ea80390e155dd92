// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/tile_wave.h"

#include "tb/trace/trace_window.h"

namespace racebeam {

TileWave::TileWave(TtRun& run, const std::string& name, int first, const std::string& path)
    : run_(run),
      trace_(run_.signals(false), run_.raster(), run_.period_ps(), {}, true, {}, vcd_),
      files_(path, "", "racebeam: " + name, vcd_),
      first_(static_cast<std::int64_t>(first) * run_.raster().frame_clocks()),
      next_(first_) {
  run_.each_clock([this](std::int64_t clock) {
    if (clock < first_) return;
    trace_.sample(point_at(clock, run_.raster()));
    next_ = clock + 1;
  });
}

void TileWave::commit() {
  run_.each_clock({});
  if (next_ == first_) return;
  const auto time = [&](std::int64_t clock) {
    return static_cast<std::uint64_t>(clock * run_.period_ps());
  };
  files_.commit({time(first_), time(next_), time(1), {}});
}

}  // namespace racebeam
