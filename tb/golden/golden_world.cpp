// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/golden_world.h"

#include <map>
#include <utility>

#include "sc/beam/chip_core.h"
#include "sc/beam/scene.h"
#include "sc/beam/sequencer.h"

namespace racebeam {

namespace {

constexpr int RayOfPattern = 64;  // a y component whose bits 7:6 are not 0

// The chip's palettes (contract 15.2).
constexpr std::uint8_t colour(int r, int g, int b) { return 16 * r + 4 * g + b; }
constexpr Palette Palettes[3] = {
    {colour(0, 0, 0), colour(0, 0, 1), colour(0, 1, 2), colour(2, 2, 3)},
    {colour(0, 0, 2), colour(0, 1, 2), colour(1, 2, 2), colour(1, 3, 2)},
    {colour(1, 0, 1), colour(2, 1, 1), colour(3, 2, 1), colour(3, 3, 2)},
};

/// The rooms of the demo by their id.
struct DemoPlaces {
  int flags;

  vec3 half_size(int id) const { return scene_core::geometry(flags, id).half_size; }
  vec3 way(int from, int to) const {
    const vec3 a = scene_core::geometry(flags, from).position;
    const vec3 b = scene_core::geometry(flags, to).position;
    vec3 way;
    for (int axis = 0; axis < 3; ++axis) way[axis] = wrap_signed(b[axis] - a[axis], CornerBits);
    return way;
  }
  std::vector<int> neighbours(int id, int axis, bool negative) const {
    const int next = scene_core::neighbour(flags, id, axis, negative);
    return next == SolidRoom ? std::vector<int>{} : std::vector<int>{next};
  }
};

/// The rooms of a scene file by their number.
struct ScenePlaces {
  const SceneFile& scene;
  int corner_bits;

  vec3 half_size(int id) const { return scene.rooms[id].half_size; }
  /// Where portals lead to rooms that do not touch, they do modulo the corner's range.
  vec3 way(int from, int to) const {
    vec3 way;
    for (int axis = 0; axis < 3; ++axis) {
      way[axis] = scene.rooms[to].centre[axis] - scene.rooms[from].centre[axis];
      if (scene.overlap) way[axis] = wrap_signed(way[axis], corner_bits);
    }
    return way;
  }
  const std::vector<int>& neighbours(int id, int axis, bool negative) const {
    return scene.rooms[id].portals[golden_face(axis, negative)];
  }
};

/// Rooms found breadth first, each with the place where it was met.
template <class Places>
class Explorer {
 public:
  Explorer(const Places& places, int room_depth) : places_(places), room_depth_(room_depth) {}

  std::vector<GoldenRoom> explore(int id, const vec3& position) {
    index_of({id, 0, position});
    std::vector<GoldenRoom> rooms;
    while (rooms.size() < found_.size()) {
      const Found here = found_[rooms.size()];
      GoldenRoom room{places_.half_size(here.id), here.position, {}, here.id};
      for (int axis = 0; axis < 3 && here.depth < room_depth_; ++axis)
        for (const bool negative : {false, true})
          for (const int next : places_.neighbours(here.id, axis, negative))
            room.neighbours[golden_face(axis, negative)].push_back(index_of(beyond(here, next)));
      rooms.push_back(std::move(room));
    }
    return rooms;
  }

 private:
  /// A room that was found, and from how far.
  struct Found {
    int id, depth;
    vec3 position;
  };

  Found beyond(const Found& here, int id) const {
    Found there{id, here.depth + 1, places_.way(here.id, id)};
    for (int axis = 0; axis < 3; ++axis) there.position[axis] += here.position[axis];
    return there;
  }

  int index_of(const Found& room) {
    const auto [at, added] =
        index_.emplace(std::pair(room.id, room.position), static_cast<int>(found_.size()));
    if (added) found_.push_back(room);
    return at->second;
  }

  const Places places_;
  const int room_depth_;
  std::vector<Found> found_;
  std::map<std::pair<int, vec3>, int> index_;
};

}  // namespace

GoldenWorld::GoldenWorld(const knobs& k)
    : room_depth(k.room_depth_limit()),
      corner_bits(k.corner_bits),
      bisection(k.bisection),
      dithering(k.dithering) {}

GoldenWorld::GoldenWorld(int frame, const knobs& k) : GoldenWorld(k) {
  sequencer_core sequencer;
  sequencer.frame_q = frame;
  sequencer_core::inputs in{true, false, true, 0};
  const auto of_rooms = sequencer.comb(in, {});
  in.dr2_y = RayOfPattern;
  const auto of_pattern = sequencer.comb(in, {});
  interlace = k.interlace && of_rooms.scene_interlace;
  shading_b = of_rooms.shading_b;
  inverse = of_rooms.inverse;
  palette = Palettes[of_rooms.palette];
  pattern_palette = Palettes[of_pattern.palette];
  lock = of_rooms.lock     ? GoldenLock::Full
         : of_pattern.lock ? GoldenLock::Partial
                           : GoldenLock::None;
  const auto camera = fly_to(frame, k);
  const DemoPlaces places{of_rooms.scene_flags};
  rooms = Explorer(places, room_depth).explore(camera.room_q, camera.position_q);
}

GoldenWorld::GoldenWorld(const SceneFile& scene, const CameraPath& path, int frame, const knobs& k)
    : GoldenWorld(k) {
  const Shot& shot = scene.shot_at(frame);
  interlace = k.interlace && shot.camera.interlace;
  shading_b = shot.look.shading == Shading::Dithered;
  inverse = shot.look.inverse;
  palette = shot.look.palette;
  pattern_palette = shot.look.pattern_palette;
  lock = shot.look.pattern == Pattern::Full      ? GoldenLock::Full
         : shot.look.pattern == Pattern::Partial ? GoldenLock::Partial
                                                 : GoldenLock::None;
  const PathPoint& camera = path.points.at(frame);
  vec3 position;
  for (int axis = 0; axis < 3; ++axis) position[axis] = -camera.position[axis];
  rooms = Explorer(ScenePlaces{scene, corner_bits}, room_depth).explore(camera.room, position);
}

}  // namespace racebeam
