// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/block_judge.h"

#include <algorithm>
#include <cstdlib>

#include "sc/block/block_rays.h"
#include "tb/bench/store_pins.h"
#include "tb/golden/block_golden.h"
#include "tb/host/load_bar.h"

namespace racebeam {

namespace {

constexpr int Bits = 8, Levels = 1 << Bits;

/// Red, green and blue as they are stored: cut.
std::array<int, 3> levels(const BlockGolden& golden, int x, int y) {
  const std::array<double, 3> channels = golden.pixel(x, y);
  std::array<int, 3> cut{};
  std::transform(channels.begin(), channels.end(), cut.begin(),
                 [](double channel) { return static_cast<int>(channel); });
  return cut;
}

}  // namespace

std::vector<int> block_first_hits(const block_tables& tables, block_knobs k) {
  k.max_passes = 1;
  block_rays rays(k, converted(tables, k));
  std::vector<int> hits(static_cast<std::size_t>(k.columns() * k.rows()));
  for (int y = 0; y < k.rows(); y += BlockSide)
    for (int x = 0; x < k.columns(); x += BlockSide) {
      const std::vector<int>& block = rays.job(x, y).hits;
      for (std::size_t row = 0; row * BlockSide < block.size(); ++row)
        std::copy_n(
            &block[row * BlockSide], BlockSide,
            &hits[(static_cast<std::size_t>(y) + row) * static_cast<std::size_t>(k.columns()) +
                  static_cast<std::size_t>(x)]);
    }
  return hits;
}

VgaFrame block_golden_picture(const scene_tables* scene, const knob_values& values, int picture) {
  const block_knobs k = values;
  const BlockGolden golden(k, tables_of(block_program_of(scene), k, picture));
  VgaFrame drawn;
  drawn.width = k.columns();
  drawn.height = k.rows();
  drawn.bits = Bits;
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x) {
      const auto [red, green, blue] = levels(golden, x, y);
      drawn.push(static_cast<std::uint32_t>((red << Bits | green) << Bits | blue));
    }
  drawn.image_crc = image_crc(drawn);
  return drawn;
}

PictureErrors block_golden_errors(const scene_tables* scene, const knob_values& values, int picture,
                                  const PackedPicture& chip, int step) {
  const block_knobs k = values;
  return block_errors(tables_of(block_program_of(scene), k, picture), k, chip, step).all;
}

BlockErrors block_errors(const block_tables& tables, const block_knobs& k,
                         const PackedPicture& chip, int step) {
  const BlockGolden golden(k, tables);
  const std::vector<int> hits = block_first_hits(tables, k);
  BlockErrors errors;
  errors.all.most = Levels - 1;
  for (int y = 0; y < chip.height; y += step)
    for (int x = 0; x < chip.width; x += step) {
      if (LoadBar::covers(k, x, y)) continue;
      const auto at = static_cast<std::size_t>(y * chip.width + x);
      const std::uint32_t colour = chip.colour(at);
      const std::array<int, 3> wanted = levels(golden, x, y);
      int most = 0;
      for (int c = 0; c < 3; ++c) {
        const int level = static_cast<int>(colour >> (2 - c) * Bits) & (Levels - 1);
        const int off = std::abs(level - wanted[static_cast<std::size_t>(c)]);
        most = std::max(most, off);
        errors.all.squares += static_cast<std::uint64_t>(off) * static_cast<std::uint64_t>(off);
      }
      ++errors.all.pixels;
      errors.all.differing += most > 0;
      errors.all.by_more += most > 1;
      errors.all.wrong_hits += golden.first_hit(x, y) != hits[at];
      errors.by_more_than_2 += most > 2;
      errors.by_more_than_16 += most > 16;
    }
  return errors;
}

}  // namespace racebeam
