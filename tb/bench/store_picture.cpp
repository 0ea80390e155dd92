// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/store_picture.h"

#include "sc/store/frame_scanout.h"

namespace racebeam {

VgaFrame rgb888_picture(int picture, const std::vector<std::uint64_t>& words,
                        const store_knobs& k) {
  constexpr int Bits = 8, Low = DacBits - Bits;
  VgaFrame drawn;
  drawn.index = static_cast<std::uint64_t>(picture);
  drawn.width = k.picture_width;
  drawn.height = k.picture_height;
  drawn.bits = Bits;
  drawn.colours.reserve(drawn.pixels() * static_cast<std::size_t>(drawn.colour_bytes()));
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x) {
      const auto dac = frame_scanout_core::pixel(words, y, x, k);
      drawn.push(static_cast<std::uint32_t>((dac.red >> Low << Bits | dac.green >> Low) << Bits |
                                            dac.blue >> Low));
    }
  return drawn;
}

}  // namespace racebeam
