// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_core_core.h"

#include <algorithm>

namespace racebeam {

namespace {

constexpr int Far = wrap32(std::int64_t{BlockFar} << BlockFraction);

/// Bits 28..12 of a colour, at most 255.
int channel(int colour) { return std::min(colour >> 12 & 0x1ffff, 255); }

}  // namespace

bool block_core_core::last_row(const block_knobs& k) const {
  const int rows = job_y_q + BlockSide > k.rows() ? k.rows() % BlockSide : BlockSide;
  return row_q == ((rows - 1) & 15);
}

int block_core_core::word_address(const block_knobs& k) const {
  const int row_words = k.columns() / 8;
  const int y = (job_y_q + row_q) & low_bits(BlockPlaceBits);
  const int address =
      plane_q * row_words * k.rows() + y * row_words + job_x_q / 8 + (column_q >> 3);
  return address & low_bits(BlockAddressBits);
}

std::uint64_t block_core_core::word(const block_knobs& k) const {
  const int plane = std::min(plane_q, 2);
  if (state_q == BlockClear)
    return 0x0101010101010101u * static_cast<unsigned>(k.background >> 8 * (2 - plane) & 0xff);
  return plane == 0 ? pack_q.red_q : plane == 1 ? pack_q.green_q : pack_q.blue_q;
}

block_shade_core::inputs block_core_core::hit_of(const inputs& in, const block_knobs& k) const {
  const block_sphere& near = sphere(nearest_q, k);
  return {in.rst_n, state_q == BlockShade, position_q, dir_q, best_q, near.centre,
          in.light, near.colour,           {},         false};
}

/// What block_normalise gets.
vec3 block_core_core::normalised(const inputs& in, const block_shade_core::inputs& hit,
                                 const block_knobs& k) const {
  if (state_q == BlockShade) return shade_q.vector(hit);
  if (state_q == BlockShadow) return block_difference(in.light, position_q);
  if (state_q != BlockCorner) return {at_x_q, at_y_q, in.start[2]};
  if (k.cull == BlockCullCone)  // the middle
    return {block_sum(at_x_q, wrap32(std::int64_t{BlockSide - 1} * in.ax) >> 1),
            block_difference(at_y_q, wrap32(std::int64_t{BlockSide - 1} * in.ay) >> 1),
            in.start[2]};
  const bool right = corner_q == 2 || corner_q == 3, low = corner_q == 1 || corner_q == 2;
  constexpr int Steps = BlockSide - 1;
  return {right ? wrap32(at_x_q + std::int64_t{Steps} * in.ax) : at_x_q,
          low ? wrap32(at_y_q - std::int64_t{Steps} * in.ay) : at_y_q, in.start[2]};
}

void block_core_core::clock(const inputs& in, const block_knobs& k) {
  block_shade_core::inputs hit = hit_of(in, k);
  const vec3 v = normalised(in, hit, k);
  const block_normalise_core::outputs unit = normalise_q.comb(v, k);
  hit.unit = unit.unit;
  hit.unit_done = unit.done;
  const block_root_core::inputs root{in.rst_n, near(), d_q[static_cast<std::size_t>(near_lane(k))]};
  const bool normalises = state_q == BlockCorner || state_q == BlockPixel ||
                          (state_q == BlockShadow && step_q == 0) || shade_q.normalise();

  event_q = normalise_q.small() ? BlockSmallVector : BlockNoEvent;
  switch (state_q) {
    case BlockIdle: take_job(in); break;
    case BlockJob: place_job(in, k); break;
    case BlockCorner: corner(unit, in, k); break;
    case BlockCull: cull(in, k); break;
    case BlockClear: clear(in, k); break;
    case BlockPixel: pixel(unit, in); break;
    case BlockGroup:
    case BlockShadowGroup: group(in, k); break;
    case BlockNear:
    case BlockShadowNear: nearest(in, k); break;
    case BlockDecide: state_q = hit_q ? BlockShade : BlockStore; break;
    case BlockShade: shaded(hit, k); break;
    case BlockShadow: shadow(unit, v); break;
    case BlockStore: store(in, k); break;
    default: words(in, k);
  }
  root_q.clock(root, k);
  shade_q.clock(hit, k);
  normalise_q.clock({in.rst_n, normalises, v}, k);
  if (in.write.write) {
    block_spheres_core::inputs write = in.write;
    write.index /= k.lanes;
    spheres_q[static_cast<std::size_t>(in.write.index % k.lanes)].clock(write, k);
  }
  if (!in.rst_n) {
    state_q = BlockIdle;
    event_q = BlockNoEvent;
    pack_q.clock({false, false, 0, 0, 0});
  }
}

void block_core_core::take_job(const inputs& in) {
  job_x_q = in.job_x;
  job_y_q = in.job_y;
  step_q = column_q = row_q = plane_q = corner_q = index_q = 0;
  if (in.job_valid) state_q = BlockJob;
}

void block_core_core::place_job(const inputs& in, const block_knobs& k) {
  if (step_q == 0) {
    at_x_q = left_q = wrap32(in.start[0] + std::int64_t{job_x_q} * in.ax);
    step_q = 1;
    return;
  }
  at_y_q = wrap32(in.start[1] - std::int64_t{job_y_q} * in.ay);
  step_q = 0;
  state_q = k.cull == BlockCullOff ? BlockPixel : BlockCorner;
}

void block_core_core::corner(const block_normalise_core::outputs& unit, const inputs& in,
                             const block_knobs& k) {
  if (!unit.done) return;
  corners_q[static_cast<std::size_t>(corner_q)] = unit.unit;
  corner_q = k.cull == BlockCullCone ? 0 : (corner_q + 1) % Corners;
  if (corner_q == 0) state_q = in.spheres ? BlockCull : BlockClear;
}

void block_core_core::cull(const inputs& in, const block_knobs& k) {
  const block_sphere& row = sphere(index_q, k);
  const bool cone = k.cull == BlockCullCone;
  const int tested = cone ? Corners : std::min(k.lanes, Corners);
  for (int n = 0; n < tested && !cone && event_q == BlockNoEvent; ++n) {
    const int at = (corner_q + n) % Corners;
    const vec3& dir = corners_q[static_cast<std::size_t>(at)];
    if (block_lane_core().comb({false, row.pose, dir, row.rv}).d > 0) event_q = BlockKept0 + at;
  }
  if (event_q != BlockNoEvent || (cone && in_cone(row, in))) {
    index_q = corner_q = 0;
    state_q = BlockPixel;
    return;
  }
  corner_q = (corner_q + tested) % Corners;
  if (corner_q != 0) return;
  if (index_q + 1 < in.spheres) {
    index_q = (index_q + 1) & (BlockEntries - 1);
    return;
  }
  index_q = 0;
  state_q = BlockClear;
}

bool block_core_core::in_cone(const block_sphere& row, const inputs& in) const {
  const block_lane_core::outputs lane =
      block_lane_core().comb({false, row.pose, corners_q[0], row.rv});
  const int ahead = block_difference(0, lane.b);
  const int reach = block_sum(block_sum(row.radius, BlockConeSlack), imul(ahead, in.cone_sine));
  const int beside2 = wrap32(row.radius2 - lane.d);
  return reach >= 0 && imul(beside2, in.cone_cosine2) <= imul(reach, reach);
}

void block_core_core::clear(const inputs& in, const block_knobs& k) {
  if (!in.word_ready) return;
  column_q ^= 8;
  if (column_q & 8) return;
  plane_q = plane_q == 2 ? 0 : plane_q + 1;
  if (plane_q != 0) return;
  if (last_row(k)) state_q = BlockIdle;
  row_q = (row_q + 1) & 15;
}

void block_core_core::pixel(const block_normalise_core::outputs& unit, const inputs& in) {
  if (!unit.done) return;
  dir_q = unit.unit;
  position_q = in.eye;
  colour_q = {};
  pass_q = 0;
  begin_ray(Far);
  state_q = in.spheres ? BlockGroup : BlockDecide;
}

void block_core_core::begin_ray(int best) {
  index_q = 0;
  step_q = 0;
  hit_q = false;
  best_q = best;
}

void block_core_core::group(const inputs& in, const block_knobs& k) {
  const bool first = pass_q == 0, second = step_q != 0;
  const int own = meets_light() ? nearest_q : -1;
  int pending = 0;
  over_q = 0;
  for (int n = 0; n < k.lanes; ++n) {
    const auto lane = static_cast<std::size_t>(n);
    const block_sphere& row = spheres_q[lane].row(index_q, k);
    const block_lane_core::inputs ray{second,
                                      first ? row.pose : block_difference(position_q, row.centre),
                                      meets_light() ? lit_q : dir_q, first ? row.rv : row.radius2};
    const block_lane_core::outputs o = lanes_q[lane].comb(ray);
    lanes_q[lane].clock(ray);
    b_q[lane] = o.b;
    d_q[lane] = static_cast<int>(o.d & low_bits(BlockRootBits));
    over_q |= (o.d >> BlockRootBits != 0) << n;
    const int at = index_q * k.lanes + n;
    if (o.d > 0 && at < in.spheres && at != own) pending |= 1 << n;
  }
  if (!first && !second) {
    step_q = 1;
    return;
  }
  step_q = 0;
  pending_q = pending;
  if (pending) state_q = meets_light() ? BlockShadowNear : BlockNear;
  else next_group(in, k);
}

/// The lowest that waits.
int block_core_core::near_lane(const block_knobs& k) const {
  int lane = 0;
  while (lane < k.lanes - 1 && !bit_of(pending_q, lane)) ++lane;
  return lane;
}

void block_core_core::nearest(const inputs& in, const block_knobs& k) {
  if (!root_q.done(k)) return;
  const int lane = near_lane(k);
  const auto n = static_cast<std::size_t>(lane);
  const int t = wrap32(-std::int64_t{b_q[n]} - root_q.root(d_q[n], k));
  const bool nearer = t > 0 && t < best_q;
  if (nearer) {
    best_q = t;
    hit_q = true;
    nearest_q = (index_q * k.lanes + lane) & (BlockEntries - 1);
  }
  if (bit_of(over_q, lane)) event_q = BlockRootOver;
  pending_q &= pending_q - 1;
  if (nearer && meets_light()) next_pass(true, k);
  else if (pending_q == 0) next_group(in, k);
}

void block_core_core::next_group(const inputs& in, const block_knobs& k) {
  if ((index_q + 1) * k.lanes >= in.spheres) {
    if (meets_light()) next_pass(false, k);
    else state_q = BlockDecide;
    return;
  }
  index_q = (index_q + 1) & (BlockEntries - 1);
  state_q = meets_light() ? BlockShadowGroup : BlockGroup;
}

void block_core_core::shaded(const block_shade_core::inputs& hit, const block_knobs& k) {
  if (!shade_q.done()) return;
  position_q = shade_q.point_q;
  dir_q = shade_q.direction(hit);
  pass_q = (pass_q + 1) & 15;
  if (k.shadow_rays) state_q = BlockShadow;
  else next_pass(false, k);
}

void block_core_core::shadow(const block_normalise_core::outputs& unit, const vec3& to_light) {
  if (step_q != 0) {
    begin_ray(idot(to_light, lit_q));
    state_q = BlockShadowGroup;
  } else if (unit.done) {
    lit_q = unit.unit;
    step_q = 1;
  }
}

/// The ray's light counts, unless it is `dark`.
void block_core_core::next_pass(bool dark, const block_knobs& k) {
  if (!dark) colour_q = block_sum(colour_q, shade_q.colour_q);
  begin_ray(Far);
  state_q = pass_q == k.max_passes ? BlockStore : BlockGroup;
}

void block_core_core::store(const inputs& in, const block_knobs& k) {
  const auto colour = [&](int n) {
    return pass_q == 0 ? k.background >> 8 * (2 - n) & 0xff
                       : channel(colour_q[static_cast<std::size_t>(n)]);
  };
  const bool full = pack_q.full(true);
  pack_q.clock({true, true, colour(0), colour(1), colour(2)});
  if (full) {
    plane_q = 0;
    state_q = BlockWords;
  } else {
    next_pixel(in);
  }
}

void block_core_core::words(const inputs& in, const block_knobs& k) {
  if (!in.word_ready) return;
  if (plane_q < 2) {
    ++plane_q;
    return;
  }
  plane_q = 0;
  const bool last = column_q == 15 && last_row(k);
  next_pixel(in);
  if (last) state_q = BlockIdle;
}

void block_core_core::next_pixel(const inputs& in) {
  state_q = BlockPixel;
  column_q = (column_q + 1) & 15;
  if (column_q != 0) {
    at_x_q = block_sum(at_x_q, in.ax);
    return;
  }
  row_q = (row_q + 1) & 15;
  at_x_q = left_q;
  at_y_q = block_difference(at_y_q, in.ay);
}

}  // namespace racebeam
