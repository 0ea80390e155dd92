// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_walker_core.h"

#include <algorithm>

namespace racebeam {

namespace {

/// Of the eight voxels whose byte has the bit.
int children(const voxel_walker_core::inputs& in) { return in.data >> (in.bit & ~7) & 255; }

}  // namespace

std::uint32_t voxel_walker_core::border_t(int axis, int at, const inputs& in) const {
  return static_cast<std::uint32_t>(voxel_border_t(at, origin_q[axis], direction_q[axis],
                                                   in.inverse[static_cast<std::size_t>(axis)]));
}

std::uint32_t voxel_walker_core::entry(const inputs& in) const {
  const int top = levels.size()[2];
  return origin_q[2] >= voxel_position(top) ? border_t(2, top, in) : 0;
}

voxel_walker_core::border voxel_walker_core::leave(const inputs& in) const {
  border first{0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t t =
        border_t(axis, (voxel_q[axis] + !down(axis)) * levels.side(level_q, axis), in);
    if (axis == 0 || t < first.t) first = {t, axis};
  }
  return {std::max(first.t, t_q), first.axis};
}

voxel_walker_core::moved voxel_walker_core::move(const voxel_knobs& k) const {
  moved to{level_q, voxel_q, false, false};
  const int side = !down(axis_q);
  while (to.level + 1 < levels.count() && (to.voxel[axis_q] & 1) == side) {
    for (int& each : to.voxel) each >>= 1;
    ++to.level;
    if (k.raise == VoxelRaiseOne) break;
  }
  to.voxel[axis_q] += side ? 1 : -1;
  const int at = to.voxel[axis_q] * levels.side(to.level, axis_q);
  to.sky = to.voxel[2] >= levels.level(to.level).sides[2] && !down(2);
  to.lost = to.voxel[2] < 0 || at < -VoxelFarAway || at >= VoxelFarAway;
  to.voxel[axis_q] = wrap_signed(to.voxel[axis_q], VoxelCoordinateBits);
  return to;
}

bool voxel_walker_core::occupied(const inputs& in, const voxel_knobs& k) const {
  if (known_q)
    return children_q >> ((voxel_q[0] & 1) | (voxel_q[1] & 1) << 1 | (voxel_q[2] & 1) << 2) & 1;
  return in.inside && (asks_children(k) ? children(in) : in.data >> in.bit & 1);
}

voxel_walker_core::outputs voxel_walker_core::comb(const inputs& in, const voxel_knobs& k) const {
  outputs o{};
  const bool enters = state_q == VoxelSetup && step_q == SetupClocks - 1;
  const bool above = origin_q[2] >= voxel_position(levels.size()[2]);
  o.setup = state_q == VoxelSetup && step_q == 1;
  o.voxel = voxel_q;
  o.level = level_q;
  if (asks_children(k)) {
    for (int& each : o.voxel) each = wrap_signed(2 * each, VoxelCoordinateBits);
    --o.level;
  }
  o.read = state_q == VoxelFetch && step_q == 0 && !known_q;
  o.t = enters ? entry(in) : t_q;
  const bool exits = state_q == VoxelExit && occupied_q;
  o.t_out = state_q == VoxelExit ? leave(in).t : t_out_q;
  o.leaf = exits && k.leaf == VoxelLeafMarch;
  o.at = enters || state_q == VoxelExit || state_q == VoxelLimit;
  o.column = state_q == VoxelLimit && step_q == 0;
  o.inner = state_q == VoxelLeaf && in.sample && !in.hit;
  o.hit = in.position;
  if (enters) {
    o.ray_done = above && !down(2);
  } else if (exits && k.leaf == VoxelLeafVoxel) {
    o.ray_done = o.t_out > t_q;
    o.kind = VoxelHit;
    for (int axis = 0; axis < 2; ++axis) {
      const int low = voxel_position(voxel_q[axis]);
      o.hit[axis] =
          wrap_signed(std::clamp(in.position[axis], low, low + low_bits(VoxelPositionFraction)),
                      VoxelPositionBits);
    }
  } else if (state_q == VoxelLeaf) {
    o.ray_done = in.hit || (o.inner && in.reached && !down(2));
    o.kind = in.hit ? VoxelHit : VoxelSky;
  } else if (state_q == VoxelMove) {
    const moved to = move(k);
    o.outer = !to.sky && !to.lost;
    o.ray_done = to.sky || ((to.lost || in.reached) && !down(2));
  } else if (state_q == VoxelLimit) {
    o.ray_done = step_q == 1 + k.memory_clocks;
    o.kind = inner_q ? VoxelInnerLimit : VoxelOuterLimit;
  }
  if (!o.ray_done) o.kind = VoxelSky;
  return o;
}

void voxel_walker_core::take_ray(const inputs& in) {
  if (!shadow_q) {
    origin_q = in.origin;
    direction_q = in.direction;
    return;
  }
  // 1.5 units towards the light.
  for (std::size_t axis = 0; axis < 3; ++axis)
    origin_q[axis] = wrap_signed(hit_q[axis] + (3 * in.light[axis] >> 9), VoxelPositionBits);
  direction_q = in.light;
}

void voxel_walker_core::enter(const inputs& in, const outputs& o, const voxel_knobs& k) {
  const bool above = origin_q[2] >= voxel_position(levels.size()[2]);
  t_q = o.t;
  level_q = levels.count() - 1;
  for (int axis = 0; axis < 3; ++axis)
    voxel_q[axis] =
        in.position[axis] >> (VoxelPositionFraction + levels.voxel_bits()[axis] + level_q);
  if (above) voxel_q[2] = std::min(voxel_q[2], levels.level(level_q).sides[2] - 1);
  leaf_step_q = voxel_step_of(direction_q, in.inverse, k.leaf_steps);
  known_q = false;
}

void voxel_walker_core::descend(const inputs& in) {
  --level_q;
  for (int axis = 0; axis < 3; ++axis) {
    const int middle = (2 * voxel_q[axis] + 1) * levels.side(level_q, axis);
    bool far = origin_q[axis] >= voxel_position(middle);
    if (!voxel_parallel(direction_q[axis])) {
      const std::uint32_t at = border_t(axis, middle, in);
      far = down(axis) ? at > t_q : at <= t_q;
    }
    voxel_q[axis] = wrap_signed(2 * voxel_q[axis] + far, VoxelCoordinateBits);
  }
}

void voxel_walker_core::clock(const inputs& in, const voxel_knobs& k) {
  const outputs o = comb(in, k);
  const int state = state_q;
  const int step = step_q;
  step_q = 0;
  switch (state) {
    case VoxelSetup:
      step_q = step + 1;
      if (step == 0) take_ray(in);
      if (step < SetupClocks - 1) break;
      enter(in, o, k);
      step_q = 0;
      state_q = VoxelFetch;
      break;
    case VoxelFetch: {
      if (!known_q && step < k.memory_clocks) {
        step_q = step + 1;
        break;
      }
      occupied_q = occupied(in, k);
      const bool asked = asks_children(k);
      if (asked) children_q = children(in);
      known_q = asked;
      state_q = occupied_q && level_q > 0 ? VoxelDown : VoxelExit;
      break;
    }
    case VoxelDown:
      descend(in);
      state_q = VoxelFetch;
      break;
    case VoxelExit: {
      const border out = leave(in);
      t_out_q = out.t;
      axis_q = out.axis;
      known_q = false;
      state_q = o.leaf && in.some ? VoxelLeaf : VoxelMove;
      break;
    }
    case VoxelLeaf:
      inner_q = true;
      if (o.inner && in.reached) state_q = VoxelLimit;
      else if (in.done) state_q = VoxelMove;
      break;
    case VoxelMove: {
      const moved to = move(k);
      t_q = t_out_q;
      level_q = to.level;
      voxel_q = to.voxel;
      inner_q = false;
      state_q = to.lost || (o.outer && in.reached) ? VoxelLimit : VoxelFetch;
      break;
    }
    case VoxelLimit: step_q = step + 1; break;
    default: break;
  }
  if (o.ray_done) {
    if (!shadow_q) hit_q = o.hit;
    state_q = VoxelIdle;
    step_q = 0;
  }
  if (state_q == VoxelIdle && in.start) {
    state_q = VoxelSetup;
    shadow_q = in.shadow;
  }
  if (!in.rst_n) {
    state_q = VoxelIdle;
    step_q = 0;
  }
}

}  // namespace racebeam
