// Behaviour of block_core (block_core.h), made of those of the units in it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/block/block_lane_core.h"
#include "sc/block/block_normalise_core.h"
#include "sc/block/block_pack_core.h"
#include "sc/block/block_root_core.h"
#include "sc/block/block_shade_core.h"
#include "sc/block/block_spheres_core.h"
#include "sc/block/knobs.h"

namespace racebeam {

class block_core_core {
 public:
  struct inputs {
    bool rst_n;
    bool job_valid;
    int job_x, job_y;
    block_spheres_core::inputs write;  // its index is that of the sphere
    int spheres;
    vec3 eye, light, start;
    int ax, ay;
    int cone_sine, cone_cosine2;
    bool word_ready;
  };

  int state_q = BlockIdle;
  int event_q = BlockNoEvent;  // of the clock before

  bool word_valid() const { return state_q == BlockClear || state_q == BlockWords; }
  int word_address(const block_knobs& k) const;
  std::uint64_t word(const block_knobs& k) const;
  /// From the second clock with these inputs on nothing changes.
  bool idle(const inputs& in) const {
    if (!in.rst_n || in.write.write) return false;
    return state_q == BlockIdle ? !in.job_valid : word_valid() && !in.word_ready;
  }
  void clock(const inputs& in, const block_knobs& k);

  /// Calls visit(name, bits, read) for each register; the RTL has vectors and lanes in one.
  template <class Visit>
  void each_register(Visit&& visit, const block_knobs& k) const {
    visit("state_q", BlockStateBits, [this] { return state_q; });
    visit("event_q", BlockEventBits, [this] { return event_q; });
    visit("step_q", 1, [this] { return step_q; });
    visit("job_x_q", BlockPlaceBits, [this] { return job_x_q; });
    visit("job_y_q", BlockPlaceBits, [this] { return job_y_q; });
    visit("column_q", 4, [this] { return column_q; });
    visit("row_q", 4, [this] { return row_q; });
    visit("plane_q", 2, [this] { return plane_q; });
    visit("corner_q", 2, [this] { return corner_q; });
    visit("index_q", BlockIndexBits, [this] { return index_q; });
    visit("pass_q", 4, [this] { return pass_q; });
    visit("pending_q", k.lanes, [this] { return pending_q; });
    visit("over_q", k.lanes, [this] { return over_q; });
    visit("hit_q", 1, [this] { return hit_q; });
    visit("nearest_q", BlockIndexBits, [this] { return nearest_q; });
    visit("best_q", BlockBits, [this] { return best_q; });
    visit("left_q", BlockBits, [this] { return left_q; });
    visit("at_x_q", BlockBits, [this] { return at_x_q; });
    visit("at_y_q", BlockBits, [this] { return at_y_q; });
  }

 private:
  static constexpr int Corners = 4;
  static constexpr int MostLanes = 8;

  void take_job(const inputs& in);
  void place_job(const inputs& in, const block_knobs& k);
  void corner(const block_normalise_core::outputs& unit, const inputs& in, const block_knobs& k);
  void cull(const inputs& in, const block_knobs& k);
  bool in_cone(const block_sphere& row, const inputs& in) const;
  int near_lane(const block_knobs& k) const;
  void clear(const inputs& in, const block_knobs& k);
  void pixel(const block_normalise_core::outputs& unit, const inputs& in);
  void group(const inputs& in, const block_knobs& k);
  void nearest(const inputs& in, const block_knobs& k);
  void next_group(const inputs& in, const block_knobs& k);
  void begin_ray(int best);
  void shaded(const block_shade_core::inputs& hit, const block_knobs& k);
  void shadow(const block_normalise_core::outputs& unit, const vec3& to_light);
  void next_pass(bool dark, const block_knobs& k);
  void store(const inputs& in, const block_knobs& k);
  void words(const inputs& in, const block_knobs& k);
  void next_pixel(const inputs& in);

  bool meets_light() const { return state_q >= BlockShadow; }
  bool near() const { return state_q == BlockNear || state_q == BlockShadowNear; }
  bool last_row(const block_knobs& k) const;
  const block_sphere& sphere(int index, const block_knobs& k) const {
    return spheres_q[static_cast<std::size_t>(index % k.lanes)].row(index / k.lanes, k);
  }
  block_shade_core::inputs hit_of(const inputs& in, const block_knobs& k) const;
  vec3 normalised(const inputs& in, const block_shade_core::inputs& hit,
                  const block_knobs& k) const;

  int step_q = 0;  // BlockJob, a group of a later pass: the second clock; BlockShadow: the last
  int job_x_q = 0, job_y_q = 0;
  int column_q = 0, row_q = 0;  // in the block
  int plane_q = 0;
  int corner_q = 0;                        // BlockCull: the first of those that are tested
  int left_q = 0, at_x_q = 0, at_y_q = 0;  // on the screen
  std::array<vec3, Corners> corners_q{};
  int index_q = 0;  // BlockCull: a sphere; groups and what follows them: a group
  int pass_q = 0;   // passes that were shaded
  vec3 position_q{}, dir_q{}, colour_q{};
  vec3 lit_q{};  // to the light
  int pending_q = 0;
  int over_q = 0;  // lanes whose d is 8.0 and above
  std::array<int, MostLanes> b_q{}, d_q{};
  bool hit_q = false;
  int nearest_q = 0, best_q = 0;

  std::array<block_spheres_core, MostLanes> spheres_q;
  std::array<block_lane_core, MostLanes> lanes_q;
  block_normalise_core normalise_q;
  block_root_core root_q;
  block_shade_core shade_q;
  block_pack_core pack_q;
};

}  // namespace racebeam
