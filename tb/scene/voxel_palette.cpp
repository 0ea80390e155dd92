// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_palette.h"

namespace racebeam {

namespace {

std::uint32_t mixed(const MaterialColours& c, std::uint32_t part, std::uint32_t whole) {
  std::uint32_t colour = 0;
  for (const int shift : {16, 8, 0}) {
    const std::uint32_t low = c.low >> shift & 255, high = c.high >> shift & 255;
    colour |= (low * (whole - part) + high * part + whole / 2) / whole << shift;
  }
  return colour;
}

}  // namespace

const VoxelColours& landscape_colours() {
  static const VoxelColours colours = {{
      {0x4c8a32, 0xc8dc8c},  // meadow
      {0xb89058, 0xf0dca8},  // sand
      {0x24542c, 0x64985c},  // forest
      {0x605444, 0xb4a48c},  // rock
      {0xb8c8dc, 0xffffff},  // snow
      {0x68401c, 0xc89458},  // wood
      {0x4c4854, 0xa8a0b0},  // roof
      {0x7c3424, 0xdc9478},  // brick
  }};
  return colours;
}

voxel_palette palette_of(const VoxelColours& colours) {
  voxel_palette palette{};
  const std::size_t heights = palette.size() / colours.size();
  for (std::size_t n = 0; n < palette.size(); ++n)
    palette[n] = static_cast<voxel_palette::value_type>(
        mixed(colours[n / heights], static_cast<std::uint32_t>(n % heights),
              static_cast<std::uint32_t>(heights - 1)));
  return palette;
}

}  // namespace racebeam
