// LoadBar: a row of squares at the bottom of a picture, one a core: how much of the last pictures
// it was busy. The host draws it over the finished picture.
//
// Source: article "Command and Control".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "sc/block/counters.h"
#include "sc/block/knobs.h"
#include "tb/base/packed_picture.h"

namespace racebeam {

class LoadBar {
 public:
  static constexpr int Side = 4, Pictures = 16;  ///< pixels of a square; averaged

  explicit LoadBar(const block_knobs& k) : knobs_(k) {}

  void forget() { shares_.clear(); }
  /// A picture is done.
  void add(const block_counters& counters);
  /// 0..255: how bright a core's square is.
  int brightness(int core) const;
  /// Whether a pixel is under it, if it is drawn.
  static bool covers(const block_knobs& k, int x, int y) {
    return k.load_bar && x < Side * k.cores && y >= k.rows() - Side;
  }
  /// Over a picture of 8 bits a channel.
  void draw(PackedPicture& picture) const;

 private:
  const block_knobs knobs_;
  std::deque<std::vector<double>> shares_;  // of the pictures, by core
};

}  // namespace racebeam
