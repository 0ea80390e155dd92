// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/silicon.h"

#include <string>

#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_levels.h"

namespace racebeam {

namespace {

constexpr int PixelBits = 24;
constexpr int BorderBits = 26;                        // a border less the origin, 18.8 signed
constexpr int ChannelBits = 8, LightBits = 4;         // voxel_shade's products
constexpr int BorderProducts = 3, PointProducts = 3;  // an axis each

std::string text(int number) { return std::to_string(number); }

}  // namespace

silicon voxel_silicon(const knob_values& values, const scene_tables*) {
  const voxel_knobs k = values;
  const auto bits = [](std::uint64_t entries, int each) {
    return entries * static_cast<std::uint64_t>(each);
  };
  const store_knobs store = k.store();
  const bool slope = k.shading == VoxelShadingSlope;
  silicon s;
  s.memories = {
      {"write buffer", memory_row::Working,
       bits(static_cast<std::uint64_t>(store.write_buffer_depth),
            store.address_bits() + store.data_bits())},
      {"frame store", memory_row::Picture,
       bits(static_cast<std::uint64_t>(k.picture_width) *
                static_cast<std::uint64_t>(k.picture_height),
            PixelBits)},
      {"palette", memory_row::Scene, bits(VoxelPaletteEntries, VoxelColourBits)},
      {"columns", memory_row::Scene,
       bits(static_cast<std::uint64_t>(k.size_x) * static_cast<std::uint64_t>(k.size_y),
            VoxelMemoryBits)},
      {"occupancy", memory_row::Scene, bits(voxel_levels(k).words(), VoxelMemoryBits)},
  };
  s.multipliers = {{"voxel_walker", BorderProducts, BorderBits, VoxelInverseBits},
                   {"voxel_leaf", PointProducts, VoxelTBits, VoxelDirectionBits}};
  if (slope) s.multipliers.push_back({"voxel_shade", 3, ChannelBits, LightBits});
  s.dividers = 3;
  s.scene = {{"word_bits", PixelBits}, {"memory_bits", VoxelMemoryBits}};
  s.quantities = {
      {"work_clocks", "clocks"},
      {"picture_clocks", "clocks"},
      {"host_clocks", "host_clocks + build_clocks"},
      {"racing_clocks", "work_clocks / pixels"},
      {"limited", "outer_limited + inner_limited"},
      // A voxel that is looked at is left or gone down into.
      {"border_products", text(BorderProducts) + " * fetches"},
      {"point_products", text(PointProducts) + " * (samples + limited)"},
      {"colour_products", slope ? "3 * (hits + limited)" : "0"},
      {"products", "border_products + point_products + colour_products"},
      {"roots_found", "0"},
      {"quotients", "3 * (pixels + shadow_rays)"},
      {"scene_bits", "memory_bits * (fetched_words + column_reads)"},
      {"store_bits_written", "word_bits * store_writes"},
      {"store_bits_read", "word_bits * store_reads"},
      {"starved", ""},
  };
  return s;
}

}  // namespace racebeam
