// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/hit_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/bench/sphere_bench.h"
#include "tb/golden/block_golden.h"
#include "tb/golden/geometry.h"
#include "tb/host/block_program.h"
#include "tb/host/sphere_picture.h"
#include "tb/judge/block_judge.h"
#include "tb/judge/sphere_judge.h"
#include "tb/judge/voxel_judge.h"

namespace racebeam {

namespace {

static_assert(HitMap::Inside == EyeInside && HitMap::Nothing == MeetsNothing);

HitMap empty_map(int width, int height) {
  return {width, height,
          std::vector<int>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                           HitMap::Nothing)};
}

int& object(HitMap& map, int x, int y) {
  return map.objects[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                     static_cast<std::size_t>(x)];
}

template <class Hit>
HitMap filled(int width, int height, const Hit& hit) {
  HitMap map = empty_map(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) object(map, x, y) = hit(x, y);
  return map;
}

/// The walls of a world, as numbers. Rooms of the demo's tunnel have copies beside them whose
/// openings lie behind the camera: whether the chip goes on through them changes no picture, so the
/// wall is that of the last copy.
class Walls {
 public:
  explicit Walls(const GoldenWorld& world) : world_(world) {
    for (const GoldenRoom& room : world.rooms) by_id_.emplace(room.id, &room);
  }

  /// Of a room; or, where it is `behind` an opening, the one around the opening.
  int wall(int id, bool behind, int axis, bool negative) const {
    const auto found = by_id_.find(id);
    if (found != by_id_.end()) {
      const GoldenRoom* room = found->second;
      if (behind && !is_copy(*room, axis, negative)) return number(id, true, axis, negative);
      while (const GoldenRoom* next = last_behind(*room, axis, negative)) {
        if (!is_copy(*next, axis, negative)) return number(next->id, true, axis, negative);
        room = next;
      }
      return number(room->id, false, axis, negative);
    }
    return number(id, behind, axis, negative);
  }
  int wall(const GoldenEnd& end) const {
    const GoldenRoom& room = world_.rooms[static_cast<std::size_t>(end.room)];
    return wall(room.id, false, end.hit.face, end.hit.negative);
  }

 private:
  static int number(int id, bool behind, int axis, bool negative) {
    return (2 * id + behind) * FaceCount + golden_face(axis, negative);
  }
  /// Behind the last opening of a face; nullptr: it has none.
  const GoldenRoom* last_behind(const GoldenRoom& room, int axis, bool negative) const {
    const auto& openings = room.neighbours[static_cast<std::size_t>(golden_face(axis, negative))];
    return openings.empty() ? nullptr : &world_.rooms[static_cast<std::size_t>(openings.back())];
  }
  /// The camera has passed where a ray in this direction would enter the room.
  static bool is_copy(const GoldenRoom& room, int axis, bool negative) {
    return (negative ? -room.position[axis] : room.position[axis]) < room.half_size[axis];
  }

  const GoldenWorld& world_;
  std::map<int, const GoldenRoom*> by_id_;
};

/// Pixel p of a line is shown in column p + 1; column 0 is the FIFO's own.
HitMap beam_hits(const Show& show, const knob_values& k, const ChipBench::Frame& frame) {
  HitMap map = empty_map(VisibleColumns, VisibleRows);
  const GoldenCamera camera = show.golden_camera(frame.number, k);
  const GoldenWorld world = show.golden_world(frame.number, k);
  const Walls walls(world);
  GoldenRays rays{};
  int line = FirstVisibleLine - 1;
  for (const IntervalEvent& event : frame.intervals) {
    if (!event.known() || !event.wall) continue;
    if (event.y != line) rays = camera.rays(line = event.y);
    for (int pixel = event.from; pixel <= std::min(event.to, VisibleColumns - 2); ++pixel)
      object(map, pixel + 1, event.y - FirstVisibleLine) = walls.wall(
          event.room, event.behind, event.face,
          rays[static_cast<std::size_t>(pixel)][static_cast<std::size_t>(event.face)] < 0);
  }
  return map;
}

HitMap beam_golden_hits(const Show& show, const knob_values& k, int frame) {
  const GoldenWorld world = show.golden_world(frame, k);
  const GoldenCamera camera = show.golden_camera(frame, k);
  const Walls walls(world);
  HitMap map = empty_map(VisibleColumns, VisibleRows);
  for (int row = 0; row < VisibleRows; ++row) {
    const int y = row + FirstVisibleLine;
    const GoldenIdeal ideal = camera.ideal(y);
    for (int column = 1; column < VisibleColumns; ++column) {
      const GoldenEnd end = geometry_end(world, ideal.ray(column - 1), world.offset_z(y));
      object(map, column, row) = walls.wall(end);
    }
  }
  return map;
}

HitMap sphere_hits(const Show& show, const knob_values& values, const ChipBench::Frame& frame) {
  const auto core =
      core_before(sphere_program_of(show.tables()), sphere_knobs(values).resolved(), frame.number);
  return filled(frame.picture.width, frame.picture.height,
                [&](int x, int y) { return core->first_hit(x, y); });
}

HitMap sphere_golden_hits(const Show& show, const knob_values& values, int picture) {
  const SphereGoldenScene scene =
      golden_scene(sphere_program_of(show.tables()), sphere_knobs(values).resolved(), picture);
  const SphereGolden golden(scene);
  return filled(scene.columns, scene.rows, [&](int x, int y) { return golden.first_hit(x, y); });
}

HitMap block_hits(const Show& show, const knob_values& values, const ChipBench::Frame& frame) {
  const block_knobs k = values;
  return {k.columns(), k.rows(),
          block_first_hits(tables_of(block_program_of(show.tables()), k, frame.number), k)};
}

HitMap block_golden_hits(const Show& show, const knob_values& values, int picture) {
  const block_knobs k = values;
  const BlockGolden golden(k, tables_of(block_program_of(show.tables()), k, picture));
  return filled(k.columns(), k.rows(), [&](int x, int y) { return golden.first_hit(x, y); });
}

template <class Hits>
HitMap voxel_map(const Show& show, const knob_values& values, int picture, const Hits& hits) {
  const voxel_knobs k = values;
  VoxelShow host(voxel_program_of(show.tables()), k);
  host.go_to(picture);
  host.next();
  return {k.picture_width, k.picture_height, hits(host, k)};
}

HitMap voxel_hits(const Show& show, const knob_values& k, const ChipBench::Frame& frame) {
  return voxel_map(show, k, frame.number, voxel_first_hits);
}

HitMap voxel_golden(const Show& show, const knob_values& k, int picture) {
  return voxel_map(show, k, picture, voxel_golden_hits);
}

/// Bright colours far from each other.
std::uint32_t colour_of(int object) {
  constexpr std::uint32_t Grey = 0x404040;
  constexpr double Golden = 0.6180339887498949;
  if (object == HitMap::Nothing) return 0;
  if (object == HitMap::Inside) return Grey;
  const double hue = 6 * std::fmod(object * Golden, 1.0), light = object % 2 ? 255 : 190;
  std::uint32_t colour = 0;
  for (const double away : {0.0, 4.0, 2.0}) {  // red, green, blue
    const double at = std::fmod(hue + away, 6.0);
    const double share = std::clamp(std::abs(at - 3) - 1, 0.0, 1.0);
    colour = colour << 8 | static_cast<std::uint32_t>(std::lround(light * (0.15 + 0.85 * share)));
  }
  return colour;
}

}  // namespace

bool HitMap::edge(int x, int y) const {
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, height - 1); ++row)
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, width - 1); ++column)
      if (at(column, row) != at(x, y)) return true;
  return false;
}

HitErrors& HitErrors::operator+=(const HitErrors& more) {
  pixels += more.pixels;
  wrong += more.wrong;
  inner += more.inner;
  inner_wrong += more.inner_wrong;
  return *this;
}

HitErrors hit_errors(const HitMap& chip, const HitMap& golden) {
  if (chip.width != golden.width || chip.height != golden.height)
    throw std::invalid_argument("maps of different sizes");
  HitErrors errors;
  for (int y = 0; y < golden.height; ++y)
    for (int x = 0; x < golden.width; ++x) {
      const bool wrong = chip.at(x, y) != golden.at(x, y), inner = !golden.edge(x, y);
      ++errors.pixels;
      errors.wrong += wrong;
      errors.inner += inner;
      errors.inner_wrong += wrong && inner;
    }
  return errors;
}

void show_hits(VgaFrame& picture, const HitMap& map) {
  static_cast<PackedPicture&>(picture) = {map.width, map.height, 8, {}};
  for (const int object : map.objects) picture.push(colour_of(object));
}

const std::vector<HitKind>& hit_kinds() {
  static const std::vector<HitKind> table = {
      {beam_engine(), "wall of a room, or around its opening to one", beam_hits, beam_golden_hits},
      {sphere_engine(), "sphere, or plane", sphere_hits, sphere_golden_hits},
      {block_engine(), "sphere", block_hits, block_golden_hits},
      {voxel_engine(), "column's ground or roof, or what it belongs to", voxel_hits, voxel_golden}};
  return table;
}

const HitKind& hits_of(const engine& built) {
  for (const HitKind& kind : hit_kinds())
    if (&kind.engine == &built) return kind;
  throw std::out_of_range(std::string("no hit map for ") + built.name);
}

}  // namespace racebeam
