// HitMap: what the first ray of each pixel meets first, as a number, by a chip or by the golden
// tracer that knows nothing of its arithmetic. In a row for each engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tb/bench/chip_bench.h"
#include "tb/show/show.h"

namespace racebeam {

struct HitMap {
  static constexpr int Inside = -2;   ///< the eye is in a sphere: no ray
  static constexpr int Nothing = -1;  ///< nothing is met; or the chip came to no wall in time

  int width = 0, height = 0;
  std::vector<int> objects;  ///< row by row

  int at(int x, int y) const {
    return objects[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  }
  /// Another object is seen in one of the eight pixels around a pixel, or in it from next to it.
  bool edge(int x, int y) const;
};

/// Pixels of a chip's map beside the golden one.
struct HitErrors {
  std::uint64_t pixels = 0;
  std::uint64_t wrong = 0;  ///< the object is another one
  std::uint64_t inner = 0;  ///< pixels more than one pixel away from an edge in the golden map
  std::uint64_t inner_wrong = 0;  ///< of those

  HitErrors& operator+=(const HitErrors& more);
};

/// Of maps of one size; else std::invalid_argument.
HitErrors hit_errors(const HitMap& chip, const HitMap& golden);

/// A picture becomes the map in colours of 8 bits a channel, an object in the same one everywhere;
/// nothing is black.
void show_hits(VgaFrame& picture, const HitMap& map);

struct HitKind {
  const racebeam::engine& engine;
  const char* objects;  ///< what the numbers are
  /// Of a frame that was rendered; with its intervals if the engine has them.
  HitMap (*chip)(const Show& show, const knob_values& k, const ChipBench::Frame& frame);
  HitMap (*golden)(const Show& show, const knob_values& k, int picture);
};

const std::vector<HitKind>& hit_kinds();

/// The row of an engine. Throws std::out_of_range.
const HitKind& hits_of(const engine& built);

}  // namespace racebeam
