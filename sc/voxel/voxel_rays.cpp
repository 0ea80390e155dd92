// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_rays.h"

#include <algorithm>
#include <numeric>

namespace racebeam {

namespace {

constexpr int SetupClocks = 18, MoveClocks = 1, DownClocks = 1, ExitClocks = 1;
constexpr int ReadClocks = 2;  // of a column, beside the memory's own

/// One ray on its way.
class Walk {
 public:
  Walk(const voxel_world& world, const voxel_knobs& k, const voxel_ray& ray, voxel_walked& walked)
      : world_(world), levels_(world.levels()), k_(k), ray_(ray), walked_(walked) {
    for (int axis = 0; axis < 3; ++axis) inverse_[axis] = voxel_inverse(ray.direction[axis]);
  }

  voxel_end run(const voxel_limit& limit, const voxel_steps* steps) {
    outer_ = limit.outer;
    inner_ = limit.inner;
    walked_.clocks += SetupClocks;
    if (!enter()) return {};
    for (;;) {
      const voxel_place place = levels_.place(level_, voxel_[0], voxel_[1], voxel_[2]);
      const bool occupied = fetch(place);
      if (occupied && level_ > 0) {
        if (steps) (*steps)({level_, voxel_, place, t_, t_, voxel_step::Down});
        descend();
        continue;
      }
      const int axis = leave();
      if (occupied) {
        if (steps) (*steps)({level_, voxel_, place, t_, t_out_, voxel_step::Sample});
        if (leaf()) {
          if (steps) (*steps)({level_, voxel_, place, hit_t_, t_out_, voxel_step::Hit});
          return {VoxelHit, hit_t_, hit()};
        }
        if (inner_ == 0) return stopped(VoxelInnerLimit);
      } else if (steps) {
        (*steps)({level_, voxel_, place, t_, t_out_, voxel_step::Empty});
      }
      move(axis);
      if (voxel_[2] >= levels_.level(level_).sides[2] && !down(2)) return {};
      if (voxel_[2] < 0 || far_away(axis) || outer_ == 0) return stopped(VoxelOuterLimit);
      --outer_;
    }
  }

 private:
  bool down(int axis) const { return ray_.direction[axis] < 0; }
  std::int64_t border(int axis, int at) const {
    return voxel_border_t(at, ray_.origin[axis], ray_.direction[axis], inverse_[axis]);
  }
  vec3 point(std::int64_t t) const { return voxel_point(ray_.origin, t, ray_.direction); }

  /// Where it hits. A voxel that is a hit is entered at its border, and rounding may leave the
  /// point beside it: its column is the voxel's.
  vec3 hit() const {
    vec3 p = point(hit_t_);
    if (k_.leaf == VoxelLeafMarch) return p;
    for (int axis = 0; axis < 2; ++axis) {
      const int low = voxel_position(voxel_[axis]);
      p[axis] = std::clamp(p[axis], low, low + low_bits(VoxelPositionFraction));
    }
    return p;
  }

  /// False: it passes above the world.
  bool enter() {
    level_ = levels_.count() - 1;
    const int top = levels_.size()[2];
    const bool above = ray_.origin[2] >= voxel_position(top);
    if (above && !down(2)) return false;
    t_ = above ? border(2, top) : 0;
    const vec3 at = point(t_);
    for (int axis = 0; axis < 3; ++axis)
      voxel_[axis] = at[axis] >> (VoxelPositionFraction + levels_.voxel_bits()[axis] + level_);
    if (above) voxel_[2] = std::min(voxel_[2], levels_.level(level_).sides[2] - 1);
    return true;
  }

  bool fetch(const voxel_place& place) {
    const auto level = static_cast<std::size_t>(level_);
    ++walked_.fetches_by_level[level];
    const bool known = known_;  // among the children that were read
    known_ = k_.group_fetch && level_ > 0 && !known;
    walked_.clocks += static_cast<unsigned>(known ? 1 : 1 + k_.memory_clocks);
    if (!known) ++walked_.words_by_level[level];
    return place.inside && (world_.occupancy()[place.word] >> place.bit & 1);
  }

  void descend() {
    ++walked_.descents;
    walked_.clocks += DownClocks;
    --level_;
    for (int axis = 0; axis < 3; ++axis) {
      const int middle = (2 * voxel_[axis] + 1) * levels_.side(level_, axis);
      bool far = ray_.origin[axis] >= voxel_position(middle);
      if (!voxel_parallel(ray_.direction[axis])) {
        const std::int64_t at = border(axis, middle);
        far = down(axis) ? at > t_ : at <= t_;
      }
      voxel_[axis] = 2 * voxel_[axis] + far;
    }
  }

  /// The axis of the border by which the voxel is left.
  int leave() {
    walked_.clocks += ExitClocks;
    int first = 0;
    std::int64_t nearest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int far = (voxel_[axis] + !down(axis)) * levels_.side(level_, axis);
      const std::int64_t t = border(axis, far);
      if (axis > 0 && t >= nearest) continue;
      nearest = t;
      first = axis;
    }
    t_out_ = std::max(nearest, t_);
    return first;
  }

  /// Whether something is hit in an occupied smallest voxel.
  bool leaf() {
    if (k_.leaf == VoxelLeafVoxel) {
      hit_t_ = t_;
      return t_out_ > t_;
    }
    const std::uint32_t step = voxel_step_of(ray_.direction, inverse_, k_.leaf_steps);
    for (std::int64_t q = t_ + step / 2; q < t_out_; q += step) {
      ++walked_.samples;
      ++walked_.column_reads;
      walked_.clocks += static_cast<unsigned>(ReadClocks + k_.memory_clocks);
      const vec3 p = point(q);
      const voxel_column c =
          world_.column(p[0] >> VoxelPositionFraction, p[1] >> VoxelPositionFraction);
      hit_t_ = q;
      if (voxel_solid(c.low, c.middle, c.high, p[2])) return true;
      if (--inner_ == 0) return false;
    }
    return false;
  }

  void move(int axis) {
    ++walked_.moves;
    walked_.clocks += MoveClocks;
    known_ = false;
    t_ = t_out_;
    const int side = !down(axis);
    while (level_ + 1 < levels_.count() && (voxel_[axis] & 1) == side) {
      for (int& each : voxel_) each >>= 1;
      ++level_;
      ++walked_.raises;
      if (k_.raise == VoxelRaiseOne) break;
    }
    voxel_[axis] += side ? 1 : -1;
  }

  /// Beyond what the numbers hold, along the axis that it moved on.
  bool far_away(int axis) const {
    const int at = voxel_[axis] * levels_.side(level_, axis);
    return at < -VoxelFarAway || at >= VoxelFarAway;
  }

  voxel_end stopped(voxel_kind why) {
    if (!down(2)) return {};
    walked_.clocks += static_cast<unsigned>(ReadClocks + k_.memory_clocks);
    ++walked_.column_reads;
    return {why, t_, point(t_)};
  }

  const voxel_world& world_;
  const voxel_levels& levels_;
  const voxel_knobs& k_;
  const voxel_ray& ray_;
  voxel_walked& walked_;
  std::array<std::uint32_t, 3> inverse_{};
  int level_ = 0, outer_ = 0, inner_ = 0;
  vec3 voxel_{};
  std::int64_t t_ = 0, t_out_ = 0, hit_t_ = 0;
  bool known_ = false;  // the bits of the children of the voxel that was looked at last
};

}  // namespace

std::uint64_t voxel_walked::fetches() const {
  return std::accumulate(fetches_by_level.begin(), fetches_by_level.end(), std::uint64_t{0});
}
std::uint64_t voxel_walked::words() const {
  return std::accumulate(words_by_level.begin(), words_by_level.end(), std::uint64_t{0});
}

voxel_end voxel_walk(const voxel_world& world, const voxel_knobs& k, const voxel_ray& ray,
                     const voxel_limit& limit, voxel_walked& walked, const voxel_steps* steps) {
  return Walk(world, k, ray, walked).run(limit, steps);
}

}  // namespace racebeam
