// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/silicon.h"

#include "sc/sphere/knobs.h"
#include "sc/sphere/sphere_scene.h"

namespace racebeam {

namespace {

constexpr int ColourRowBits = 3 * SphereColourBits;
// Centre, radius and its square and inverse, mirror, colour, is_light.
constexpr int SphereRowBits =
    3 * SphereBits + UnitBits + SphereBits + 2 * UnitBits + ColourRowBits + 1;
// Normal, distance, colour, mirror, checkerboard, limits.
constexpr int PlaneRowBits = 4 * SphereBits + ColourRowBits + UnitBits + 4 + 1 + 3 * UnitBits;

}  // namespace

silicon sphere_silicon(const knob_values& values, const scene_tables* scene) {
  const sphere_knobs k = sphere_knobs(values).resolved();
  const auto* const tables = static_cast<const sphere_tables*>(scene);
  const auto bits = [](std::uint64_t entries, int each) {
    return entries * static_cast<std::uint64_t>(each);
  };
  const store_knobs store = k.store();
  silicon s;
  s.memories = {
      {"sphere table", memory_row::Working,
       bits(static_cast<unsigned>(k.table_entries), SphereRowBits)},
      {"plane table", memory_row::Working, bits(PlaneEntries, PlaneRowBits)},
      {"alias buffer", memory_row::Working, bits(SubRays, 3 * ChannelBits)},
      {"write buffer", memory_row::Working,
       bits(static_cast<unsigned>(store.write_buffer_depth),
            store.address_bits() + store.data_bits())},
      {"frame store", memory_row::Picture,
       bits(std::uint64_t{1} << store.address_bits(), store.data_bits())},
  };
  s.multipliers = {{"vector_unit", 3, SphereBits, SphereBits},
                   {"sphere_shader", 4, UnitBits, UnitBits}};
  s.roots = 1;
  s.dividers = 3;
  s.scene = {{"spheres", static_cast<double>(tables ? tables->spheres : sphere_tables().spheres)},
             {"planes", tables ? static_cast<double>(tables->planes.size()) : 0},
             {"sphere_bits", SphereRowBits},
             {"plane_bits", PlaneRowBits},
             {"word_bits", static_cast<double>(store.data_bits())}};
  s.quantities = {
      {"work_clocks", "clocks"},
      {"picture_clocks", "clocks"},
      {"host_clocks", "host_clocks"},
      {"racing_clocks", "work_clocks / pixels"},
      {"rays", "primary_rays + reflected_rays + shadow_rays"},
      {"ray_products", "3 * rays"},
      {"sphere_products",
       "3 * (state_centre + state_along + state_s_along * 2) + state_front + state_s_front + "
       "3 * hits"},
      {"plane_products", "3 * (state_plane + state_plane_d + divisions - 3 * rays)"},
      {"colour_products",
       "3 * (state_shade + state_lambert + state_reflect + state_shade) + 4 * state_add"},
      {"products", "ray_products + sphere_products + plane_products + colour_products"},
      {"roots_found", "roots"},
      {"quotients", "divisions"},
      {"scene_bits", "sphere_tests * sphere_bits + plane_tests * plane_bits"},
      {"store_bits_written", "store_writes * word_bits"},
      {"store_bits_read", "store_reads * word_bits"},
      {"starved", ""},
  };
  return s;
}

}  // namespace racebeam
