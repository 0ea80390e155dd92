// block_rays: the blocks of a picture, one at a time: what block_core makes of a job, and in how
// many clocks, whole states at once.
//
// A closed form of block_core_core for the tlm level: the same words, clocks and counters.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sc/block/block_world.h"
#include "sc/block/codes.h"
#include "sc/block/counters.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// A word on its way to the frame store.
struct block_word {
  int clock;  ///< of the job, from 0: the one in which it is offered first, if none waited before
  int address;
  std::uint64_t pixels;  ///< of one plane, the first in the lowest byte
};

/// A block, drawn.
struct block_job {
  int clocks = 0;  ///< outside of IDLE, if the bus takes each word at once
  bool cleared = false;
  std::vector<block_word> words;
  std::vector<int> begins;  ///< of its pixels, row by row, in clocks like those of words
  std::vector<int> hits;    ///< of its pixels: the sphere that is met first; -1: none
};

/// A ray of a pixel, and what it met.
struct block_pass {
  int groups = 0, near = 0;  ///< clocks in GROUP and NEAR
  int sphere = -1;           ///< the nearest; -1: none
  int distance = 0;          ///< 12.20
  int shadow = 0;            ///< clocks of the ray to the light
  bool dark = false;         ///< it is stopped
  vec3 colour{};             ///< of the pixel so far, 12.20
};

/// A pixel, explained.
struct block_pixel {
  bool cleared = false;  ///< with its block: no ray
  int begin = 0;         ///< clock of the job
  int clocks = 0;        ///< from PIXEL to STORE; cleared: none
  std::vector<block_pass> passes;
  std::array<int, 3> rgb{};
};

class block_rays {
 public:
  block_rays(const block_knobs& k, const block_world& world);

  /// Draws the block whose first pixel is (x, y). What it was stays until the next.
  const block_job& job(int x, int y);

  /// What a job does for one of its pixels.
  block_pixel explain(int x, int y);

  /// Adds what was counted since the last call.
  void take(block_counters& to);

 private:
  struct ray {
    vec3 dir, position;
    int best, nearest;
  };
  /// Of all spheres, one array an axis: the loops over them are most of the time.
  struct column {
    std::array<std::int64_t, BlockEntries> x{}, y{}, z{};
    void put(std::size_t n, const vec3& v) {
      x[n] = v[0];
      y[n] = v[1];
      z[n] = v[2];
    }
  };

  vec3 unit(const vec3& v);
  bool corners_keep(const vec3& first);
  bool cone_keeps(const vec3& first);
  void clear(int x, int y, int rows);
  void pixel(const vec3& at);
  void meet(ray& r, bool primary, int own = -1);
  bool nearer(ray& r, int sphere, int b, std::int64_t d);
  bool in_shadow(const vec3& point, int own);
  vec3 shade(ray& r);
  void store(int x, int y);

  int plane_words() const { return knobs_.columns() / 8 * knobs_.rows(); }

  const block_knobs knobs_;
  const block_world world_;
  const int spheres_, groups_;
  column pose_, centre_;
  std::array<int, BlockEntries> rv_{}, radius2_{};
  block_job job_;
  block_pixel* explained_ = nullptr;  // the next pixel
  std::array<std::uint64_t, 3> packed_{};
  block_counters n_;
};

}  // namespace racebeam
