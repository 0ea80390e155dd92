// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/frame_wave.h"

#include "tb/trace/trace_window.h"

namespace racebeam {

FrameWave::FrameWave(WiredBench& bench, const Show& show, const Raster& raster, int first,
                     const std::string& path)
    : bench_(bench),
      raster_(raster),
      trace_(
          chip_signals(bench), raster_, bench.period_ps(), {}, true,
          [&show](int frame) { return show.part(frame); }, vcd_),
      files_(path, "", "racebeam: " + show.name(), vcd_),
      first_(TracePoint{first, FirstLine, 0}.ordinal(raster_)),
      next_(first_) {
  bench_.seek(first);
  bench_.settle();
  bench_.each_clock([this] { trace_.sample(point_at(next_++, raster_)); });
}

void FrameWave::commit() {
  bench_.each_clock({});
  if (next_ == first_) return;
  const auto time = [&](std::int64_t clock) {
    return static_cast<std::uint64_t>(clock * bench_.period_ps());
  };
  files_.commit({time(first_), time(next_), time(1), {}, {}});
}

}  // namespace racebeam
