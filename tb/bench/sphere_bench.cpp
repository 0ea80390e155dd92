// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/sphere_bench.h"

#include "tb/bench/sphere_signal_bench.h"
#include "tb/bench/sphere_tlm_bench.h"
#include "tb/bench/store_pins.h"

namespace racebeam {

const SphereProgram& sphere_program_of(const scene_tables* scene) {
  return scene ? *static_cast<const SphereProgram*>(scene) : builtin_sphere_program();
}

VgaFrame sphere_picture(int picture, const std::vector<std::uint64_t>& words, bool narrow,
                        const sphere_knobs& k, const BenchWishes& wishes) {
  VgaFrame drawn;
  drawn.index = static_cast<std::uint64_t>(picture);
  drawn.width = k.columns(narrow);
  drawn.height = sphere_knobs::rows(narrow);
  drawn.bits = k.colour_bits;
  drawn.colours.reserve(drawn.pixels() * static_cast<std::size_t>(drawn.colour_bytes()));
  const int column_bits = k.store().column_bits();
  const std::uint64_t colour = (std::uint64_t{1} << 3 * k.colour_bits) - 1;
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x)
      drawn.push(static_cast<std::uint32_t>(words[static_cast<std::size_t>(y << column_bits | x)] &
                                            colour));
  if (wishes.crc) drawn.image_crc = image_crc(drawn);
  return drawn;
}

std::unique_ptr<ChipBench> make_sphere_bench(const std::string& level,
                                             const WiredBench::Setting& setting,
                                             const BenchWishes& wishes) {
  if (level != setting.built.levels.front())
    return std::make_unique<SphereSignalBench>(setting, wishes);
  return std::make_unique<SphereTlmBench>(setting, wishes);
}

}  // namespace racebeam
