// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_rays.h"

#include <algorithm>

#include "sc/block/numbers.h"

namespace racebeam {

namespace {

constexpr int One = 1 << BlockFraction;
constexpr int Far = BlockFar << BlockFraction;
constexpr int JobClocks = 2;

/// As it is stored: eight bits.
int channel(int value) { return std::min(value >> 12 & 0x1ffff, 255); }

/// Bits 51..20 of the sum of products of the axes.
int dot(std::int64_t ax, std::int64_t ay, std::int64_t az, const vec3& b) {
  return wrap32((ax * b[0] + ay * b[1] + az * b[2]) >> BlockFraction);
}

}  // namespace

block_rays::block_rays(const block_knobs& k, const block_world& world)
    : knobs_(k),
      world_(world),
      spheres_(static_cast<int>(world.rows.size())),
      groups_((spheres_ + k.lanes - 1) / k.lanes) {
  for (std::size_t n = 0; n < world_.rows.size(); ++n) {
    const block_row& row = world_.rows[n];
    pose_.put(n, row.pose);
    centre_.put(n, row.centre);
    rv_[n] = row.rv;
    radius2_[n] = row.radius2;
  }
  job_.words.reserve(3 * BlockSide * BlockSide / 8);
}

vec3 block_rays::unit(const vec3& v) {
  const int length2 = inorm2(v);
  n_.small_vectors += length2 < BlockSmallLength2;
  return imul(v, inverse_root(length2, knobs_.newton_steps));
}

const block_job& block_rays::job(int x, int y) {
  const vec3 first = {wrap32(world_.start[0] + std::int64_t{x} * world_.ax),
                      wrap32(world_.start[1] - std::int64_t{y} * world_.ay), world_.start[2]};
  const int rows = std::min(BlockSide, knobs_.rows() - y);
  job_.clocks = JobClocks;
  job_.words.clear();
  job_.begins.clear();
  job_.hits.clear();
  job_.cleared = knobs_.cull == BlockCullCorners ? !corners_keep(first)
                 : knobs_.cull == BlockCullCone  ? !cone_keeps(first)
                                                 : false;
  if (job_.cleared) {
    job_.begins.assign(static_cast<std::size_t>(BlockSide * rows), 0);
    job_.hits.assign(job_.begins.size(), -1);
    clear(x, y, rows);
  } else {
    vec3 at = first;
    for (int row = 0; row < rows; ++row) {
      at[0] = first[0];
      for (int column = 0; column < BlockSide; ++column) {
        job_.begins.push_back(job_.clocks);
        pixel(at);
        if (column % 8 == 7) store(x + column - 7, y + row);
        at[0] = block_sum(at[0], world_.ax);
      }
      at[1] = block_difference(at[1], world_.ay);
    }
  }
  ++n_.blocks;
  n_.cleared += job_.cleared;
  n_.words += job_.words.size();
  n_.busy_clocks += static_cast<unsigned>(job_.clocks);
  return job_;
}

bool block_rays::corners_keep(const vec3& first) {
  const int right = (BlockSide - 1) * world_.ax, down = (BlockSide - 1) * world_.ay;
  vec3 corners[BlockCorners];  // upper left, bottom left, bottom right, upper right
  for (int n = 0; n < BlockCorners; ++n)
    corners[n] = unit({block_sum(first[0], n >= 2 ? right : 0),
                       block_difference(first[1], n == 1 || n == 2 ? down : 0), first[2]});
  job_.clocks += BlockCorners * knobs_.normalise_clocks();
  const int lanes = std::min(knobs_.lanes, BlockCorners);
  for (const block_row& row : world_.rows)
    for (int n = 0; n < BlockCorners; ++n) {
      job_.clocks += n % lanes == 0;
      const int b = idot(row.pose, corners[n]);
      if (std::int64_t{imul(b, b)} + row.rv <= 0) continue;
      ++n_.kept_by_corner[static_cast<std::size_t>(n)];
      return true;
    }
  return false;
}

bool block_rays::cone_keeps(const vec3& first) {
  const vec3 middle =
      unit({block_sum(first[0], (BlockSide - 1) * world_.ax >> 1),
            block_difference(first[1], (BlockSide - 1) * world_.ay >> 1), first[2]});
  job_.clocks += knobs_.normalise_clocks();
  for (const block_row& row : world_.rows) {
    ++job_.clocks;
    const int b = block_difference(0, idot(row.pose, middle));
    const int reach = block_sum(block_sum(row.radius, BlockConeSlack), imul(b, world_.cone_sine));
    const int beside2 = block_difference(inorm2(row.pose), imul(b, b));
    if (reach >= 0 && imul(beside2, world_.cone_cosine2) <= imul(reach, reach)) return true;
  }
  return false;
}

void block_rays::clear(int x, int y, int rows) {
  for (int row = 0; row < rows; ++row)
    for (int plane = 0; plane < 3; ++plane) {
      const int level = knobs_.background >> (16 - 8 * plane) & 255;
      packed_[static_cast<std::size_t>(plane)] = static_cast<unsigned>(level) * 0x0101010101010101u;
      for (int half = 0; half < 2; ++half)
        job_.words.push_back(
            {job_.clocks++,
             plane * plane_words() + (y + row) * (knobs_.columns() / 8) + x / 8 + half,
             packed_[static_cast<std::size_t>(plane)]});
    }
}

void block_rays::store(int x, int y) {
  for (int plane = 0; plane < 3; ++plane)
    job_.words.push_back({job_.clocks++, plane * plane_words() + y * (knobs_.columns() / 8) + x / 8,
                          packed_[static_cast<std::size_t>(plane)]});
}

void block_rays::pixel(const vec3& at) {
  ray r{unit(at), world_.eye, Far, -1};
  job_.clocks += knobs_.normalise_clocks();
  vec3 colour{};
  bool hit = false;
  for (int pass = 0; pass < knobs_.max_passes; ++pass) {
    r.best = Far;
    r.nearest = -1;
    const int begin = job_.clocks, groups = pass == 0 ? groups_ : 2 * groups_;
    meet(r, pass == 0);
    if (pass == 0) job_.hits.push_back(r.nearest);
    if (explained_)
      explained_->passes.push_back({groups, job_.clocks - begin - groups, r.nearest, r.best, {}});
    ++job_.clocks;  // DECIDE
    if (r.nearest < 0) break;
    hit = true;
    const vec3 light = shade(r);
    job_.clocks += knobs_.shade_clocks();
    ++n_.shades[static_cast<std::size_t>(pass)];
    const int shaded = job_.clocks;
    const bool dark = knobs_.shadow_rays && in_shadow(r.position, r.nearest);
    if (!dark) colour = block_sum(colour, light);
    if (!explained_) continue;
    block_pass& told = explained_->passes.back();
    told.colour = colour;
    told.shadow = job_.clocks - shaded;
    told.dark = dark;
  }
  ++job_.clocks;  // STORE
  for (int plane = 0; plane < 3; ++plane) {
    const auto k = static_cast<std::size_t>(plane);
    const int level = hit ? channel(colour[k]) : knobs_.background >> (16 - 8 * plane) & 255;
    packed_[k] = packed_[k] >> 8 | std::uint64_t{static_cast<unsigned>(level)} << 56;
  }
}

block_pixel block_rays::explain(int x, int y) {
  const block_counters counted = n_;
  const int column = x % BlockSide, row = y % BlockSide;
  const block_job& all = job(x - column, y - row);
  block_pixel p;
  p.cleared = all.cleared;
  p.begin = all.begins[static_cast<std::size_t>(row * BlockSide + column)];
  if (!p.cleared) {
    job_.clocks = 0;
    explained_ = &p;
    pixel({wrap32(world_.start[0] + std::int64_t{x} * world_.ax),
           wrap32(world_.start[1] - std::int64_t{y} * world_.ay), world_.start[2]});
    explained_ = nullptr;
    p.clocks = job_.clocks;
  }
  for (std::size_t k = 0; k < 3; ++k) p.rgb[k] = static_cast<int>(packed_[k] >> 56);
  n_ = counted;
  return p;
}

/// All groups; of a ray to the light, up to the first sphere nearer than r.best, but for its `own`.
void block_rays::meet(ray& r, bool primary, int own) {
  const vec3 dir = r.dir;
  for (int first = 0; first < spheres_; first += knobs_.lanes) {
    const int last = std::min(first + knobs_.lanes, spheres_);
    std::array<int, 8> b;
    std::array<std::int64_t, 8> d;
    bool any = false;
    ++n_.groups;
    job_.clocks += primary ? 1 : 2;
    for (int n = first; n < last; ++n) {
      const auto s = static_cast<std::size_t>(n), lane = static_cast<std::size_t>(n - first);
      if (primary) {
        b[lane] = dot(pose_.x[s], pose_.y[s], pose_.z[s], dir);
        d[lane] = std::int64_t{imul(b[lane], b[lane])} + rv_[s];
      } else {
        const vec3 v = {block_difference(r.position[0], static_cast<int>(centre_.x[s])),
                        block_difference(r.position[1], static_cast<int>(centre_.y[s])),
                        block_difference(r.position[2], static_cast<int>(centre_.z[s]))};
        b[lane] = dot(v[0], v[1], v[2], dir);
        d[lane] = std::int64_t{imul(b[lane], b[lane])} - inorm2(v) + radius2_[s];
      }
      if (n == own) d[lane] = 0;
      any |= d[lane] > 0;
    }
    if (!any) {
      ++n_.groups_skipped;
      continue;
    }
    for (int n = first; n < last; ++n) {
      const auto lane = static_cast<std::size_t>(n - first);
      if (d[lane] > 0 && nearer(r, n, b[lane], d[lane]) && own >= 0) return;
    }
  }
}

bool block_rays::in_shadow(const vec3& point, int own) {
  const vec3 way = block_difference(world_.light, point);
  ray r{unit(way), point, 0, -1};
  r.best = idot(way, r.dir);
  job_.clocks += knobs_.normalise_clocks() + 1;
  meet(r, false, own);
  return r.nearest >= 0;
}

bool block_rays::nearer(ray& r, int sphere, int b, std::int64_t d) {
  job_.clocks += knobs_.root_clocks();
  ++n_.roots;
  n_.root_out_of_range += d >> BlockRootBits != 0;
  const int t = wrap32(-std::int64_t{b} -
                       root_of(static_cast<int>(d) & low_bits(BlockRootBits), knobs_.root));
  if (t <= 0 || t >= r.best) return false;
  r.best = t;
  r.nearest = sphere;
  return true;
}

vec3 block_rays::shade(ray& r) {
  const block_row& row = world_.rows[static_cast<std::size_t>(r.nearest)];
  const vec3 point = block_sum(r.position, imul(r.dir, r.best));
  const vec3 normal = unit(block_difference(point, row.centre));
  const vec3 lit = unit(block_difference(world_.light, point));
  const int diffuse = not_below_0(idot(normal, lit));
  const auto turned = [&](const vec3& from, int along) {
    return block_difference(from, imul(normal, block_sum(along, along)));
  };
  int shine = not_below_0(idot(r.dir, turned(lit, diffuse)));
  for (int n = 0; n < knobs_.specular_squarings; ++n) shine = imul(shine, shine);
  r.dir = turned(r.dir, idot(r.dir, normal));
  r.position = point;
  return block_sum(imul(row.colour, diffuse), {shine, shine, shine});
}

void block_rays::take(block_counters& to) {
  const auto add = [](auto& sum, const auto& part) {
    for (std::size_t n = 0; n < part.size(); ++n) sum[n] += part[n];
  };
  to.busy_clocks += n_.busy_clocks;
  to.blocks += n_.blocks;
  to.cleared += n_.cleared;
  add(to.kept_by_corner, n_.kept_by_corner);
  to.groups += n_.groups;
  to.groups_skipped += n_.groups_skipped;
  to.roots += n_.roots;
  add(to.shades, n_.shades);
  to.small_vectors += n_.small_vectors;
  to.root_out_of_range += n_.root_out_of_range;
  to.words += n_.words;
  n_ = {};
}

}  // namespace racebeam
