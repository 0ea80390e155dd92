// libFuzzer target: no text makes the scene reader crash or hang, and a scene without faults can
// be compiled for the chip, flown and laid out for a drawing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "tb/scene/camera_path.h"
#include "tb/scene/plan_storeys.h"
#include "tb/scene/scene_compiler.h"
#include "tb/scene/scene_reader.h"
#include "tb/scene/scene_sight.h"

namespace {

// The chip's table says of each portal which one leads back.
void check_table(const racebeam::scene_program& program) {
  for (std::size_t number = 0; number < program.rooms.size(); ++number)
    for (int face = 0; face < racebeam::FaceCount; ++face)
      for (const racebeam::portal_row& portal : program.rooms[number].portals[face]) {
        if (portal.room == racebeam::SolidRoom) continue;
        const auto& back = program.rooms.at(portal.room).portals[racebeam::opposite(face)];
        if (portal.back >= racebeam::MaxPortals || back[portal.back].room != number) std::abort();
      }
}

// Each portal leads back, and, unless the file allows otherwise, the rooms touch.
void check_portals(const racebeam::SceneFile& scene) {
  for (const racebeam::Room& room : scene.rooms)
    for (int face = 0; face < racebeam::FaceCount; ++face)
      for (const int next : room.portals[face]) {
        const racebeam::Room& other = scene.rooms.at(next);
        bool back = false;
        for (const int number : other.portals[racebeam::opposite(face)])
          back |= &scene.rooms.at(number) == &room;
        if (!back || (!scene.overlap && !racebeam::rooms_touch(room, face, other))) std::abort();
      }
}

// Every room is in one storey, and every frame on one strand, or on two where the storey changes.
void check_strands(const racebeam::SceneFile& scene, const racebeam::CameraPath& path) {
  const std::vector<racebeam::Storey> storeys = racebeam::storeys_of(scene);
  std::size_t rooms = 0, frames = 0;
  for (const racebeam::Storey& storey : storeys)
    rooms += storey.rooms.size() + storey.shafts.size();
  if (rooms != scene.rooms.size()) std::abort();
  for (const racebeam::Strand& strand : racebeam::strands_of(scene, path, storeys))
    frames += strand.points.size();
  if (frames < path.points.size()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace racebeam;
  const SceneResult result =
      read_scene(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
  (void)result.faults.text("fuzz");
  if (!result.faults.none()) return 0;
  check_portals(result.scene);
  const CameraPath path = fly(result.scene);
  if (path.end || path.points.size() != static_cast<std::size_t>(result.scene.frames)) std::abort();
  check_table(compile_scene(result.scene));
  (void)deepest_view(result.scene);
  // The rest is slow under sanitizers and the same for every frame.
  if (result.scene.rooms.size() > 200 || result.scene.frames > 2000) return 0;
  check_strands(result.scene, path);
  return 0;
}
