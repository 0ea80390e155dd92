// The chip's cores in one loop, without SystemC: four times as fast as the wired chip, and the
// reference for its wiring.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/beam/chip_core.h"
#include "sc/beam/frame_stats.h"
#include "tb/monitor/raster.h"

namespace racebeam {

class CoreBench {
 public:
  /// From reset just before frame `first` of the demo, or of a program that fits the knobs and
  /// outlives the bench.
  explicit CoreBench(const knobs& k, int first = 0, const scene_program* program = nullptr);

  struct Frame {
    std::vector<std::uint8_t> colours;  ///< 640 x 480, as a monitor samples them
    std::uint32_t pins_crc;             ///< of uo in all clocks
    frame_stats stats;
  };
  /// The next frame with all that is known of it.
  Frame render();
  /// The colours alone, of the next frame up to its last visible line; nothing may follow.
  std::vector<std::uint8_t> picture();
  /// Runs the next frame, unseen.
  void skip();

 private:
  template <class See>
  void run(int lines, chip_view* view, const See& see);

  const knobs knobs_;
  const Raster raster_;
  chip_core chip_;
};

}  // namespace racebeam
