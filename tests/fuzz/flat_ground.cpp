// A flat ground of voxels for whatever is asked for: the ground itself takes its time, and no text
// can break it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "sc/voxel/voxel_world.h"
#include "tb/picture/grey_picture.h"
#include "tb/scene/voxel_terrain.h"

namespace {

using namespace racebeam;

std::vector<std::uint32_t> ground(const vec3& size) {
  return std::vector<std::uint32_t>(
      static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]),
      packed({4, 8, 9, 1, 2}));
}

}  // namespace

std::vector<std::uint32_t> racebeam::tiny_terrain(const vec3& size) { return ground(size); }
std::vector<std::uint32_t> racebeam::hills_terrain(const vec3& size, const HillsTerrain&) {
  return ground(size);
}
std::vector<std::uint32_t> racebeam::canyon_terrain(const vec3& size, const CanyonTerrain&) {
  return ground(size);
}
std::vector<std::uint32_t> racebeam::picture_terrain(const vec3& size,
                                                     const PictureTerrain& pictures) {
  for (const GreyPicture* each : {pictures.low, pictures.middle, pictures.high, pictures.materials})
    if (each && (each->width != size[0] || each->height != size[1])) std::abort();
  return ground(size);
}

/// Every other name is one of a picture.
std::string racebeam::read_grey_picture(const std::string& path, GreyPicture& to) {
  if (path.size() % 2) return "there is none";
  to = {16, 16, 8, std::vector<std::uint16_t>(256)};
  return "";
}
