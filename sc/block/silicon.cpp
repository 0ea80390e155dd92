// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/silicon.h"

#include <string>

#include "sc/block/block_world.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

namespace {

constexpr int SphereRowBits = 12 * BlockBits;  // pose, rv, centre, radius and its square, colour
constexpr int BuiltInSpheres = 4;
constexpr int WordBits = 64, Planes = 3, PixelByte = 8;
// What a pass multiplies for a sphere, for a unit vector beside Newton's steps, for a hit beside
// the squarings.
constexpr int FirstPass = 4, LaterPass = 7, UnitVector = 6, NewtonStep = 3, Hit = 21;
// What a pass and a hit read of a sphere.
constexpr int TestedBits = 4 * BlockBits, HitBits = 6 * BlockBits;

std::string text(int number) { return std::to_string(number); }

}  // namespace

silicon block_silicon(const knob_values& values, const scene_tables* scene) {
  const block_knobs k = values;
  const auto* const tables = static_cast<const block_tables*>(scene);
  const auto bits = [](int entries, int each) {
    return static_cast<std::uint64_t>(entries) * static_cast<std::uint64_t>(each);
  };
  const store_knobs store = k.store();
  silicon s;
  s.memories = {
      {"spheres of the cores", memory_row::Working, bits(k.cores * BlockEntries, SphereRowBits)},
      {"pixels on their way to words", memory_row::Working, bits(k.cores * Planes, WordBits)},
      {"write buffer", memory_row::Working,
       bits(store.write_buffer_depth, store.address_bits() + store.data_bits())},
      {"frame store", memory_row::Picture, bits(k.columns() * k.rows(), Planes * PixelByte)},
  };
  s.multipliers = {{"block_lane", 4 * k.lanes * k.cores, BlockBits, BlockBits},
                   {"block_normalise", 3 * k.cores, BlockBits, BlockBits},
                   {"block_shade", 3 * k.cores, BlockBits, BlockBits},
                   {"block_convert", 3, BlockBits, BlockBits}};
  s.roots = k.cores;
  s.dividers = k.root == BlockRootHeron ? k.cores : 0;
  s.scene = {{"spheres", tables ? static_cast<double>(tables->balls.size()) : BuiltInSpheres},
             {"word_bits", WordBits}};
  // No counter tells rays to the light from others.
  const bool countable = !k.shadow_rays;
  s.quantities = {
      {"work_clocks", "clocks"},
      {"picture_clocks", "clocks"},
      {"host_clocks", "host_clocks"},
      {"racing_clocks", "work_clocks / pixels"},
      {"rays", "groups / ceil(spheres / lanes)"},
      {"later_rays", "shades - shades_by_pass_" + text(k.max_passes - 1)},
      {"first_rays", "rays - later_rays"},
      {"sphere_products",
       "spheres * (" + text(FirstPass) + " * first_rays + " + text(LaterPass) + " * later_rays)"},
      {"unit_products", "(" + text(UnitVector) + " + " + text(NewtonStep) +
                            " * newton_steps) * (first_rays + 2 * shades)"},
      {"hit_products", "(" + text(Hit) + " + specular_squarings) * shades"},
      {"products", countable ? "sphere_products + unit_products + hit_products" : ""},
      {"roots_found", "roots"},
      {"quotients", k.root == BlockRootHeron ? "roots" : "0"},
      {"scene_bits", countable
                         ? text(TestedBits) + " * spheres * rays + " + text(HitBits) + " * shades"
                         : std::string()},
      {"store_bits_written", "store_writes * word_bits"},
      {"store_bits_read", "store_reads * word_bits"},
      {"starved", ""},
  };
  return s;
}

}  // namespace racebeam
