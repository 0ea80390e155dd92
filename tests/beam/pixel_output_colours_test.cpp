// Promises of sc/beam/pixel_output.h: the colours that a scene file brings.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/pixel_output_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using PixelOutputColoursTest = PixelOutputTest<Unit>;
TYPED_TEST_SUITE(PixelOutputColoursTest, Twins);

/// A word of four colours, the first lowest, with `colour` (r * 16 + g * 4 + b) in one place.
int colours_with(int place, int colour, int others) {
  const int place_bits = low_bits(ColourBits) << (ColourBits * place);
  return (others & ~place_bits) | colour << (ColourBits * place);
}

// Header: the palette that a scene file brings, all colours in all places.
TYPED_TEST(PixelOutputColoursTest, TablePaletteShowsTheColoursItIsGiven) {
  auto& d = this->dut;
  for (int n = 0; n < 4 * 64 * 2; ++n) {
    const int place = n & 3, colour = n >> 2 & 63, others = n >> 8 ? low_bits(ColoursBits) : 0;
    const int rgb[3] = {colour >> 4, colour >> 2 & 3, colour & 3};
    d.bench["colours_i"].drive(colours_with(place, colour, others));
    for (int index = 0; index < 4; ++index) {
      const int rest[3] = {others & 3, others & 3, others & 3};
      ASSERT_EQ(d.uo(index, TablePalette), byte_of(index == place ? rgb : rest, 1, 1))
          << "colour " << colour << " in place " << place << ", index " << index;
    }
  }
}

TYPED_TEST(PixelOutputColoursTest, TablePaletteIsInvertedLockedAndBlankedAsTheOthers) {
  auto& d = this->dut;
  const int colours[4] = {0b000001, 0b000100, 0b010000, 0b111001};
  const int rgb[4][3] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {3, 2, 1}};
  int word = 0;
  for (int place = 0; place < 4; ++place) word = colours_with(place, colours[place], word);
  d.bench["colours_i"].drive(word);
  for (const int inverse : {0, 1})
    for (const int lock : {0, 1})
      for (int index = 0; index < 4; ++index) {
        d.bench["inverse_i"].drive(inverse);
        d.bench["lock_i"].drive(lock);
        d.bench.drive("dr2", "_i", {index << 5, 3 << 6, 0});
        const int shown = inverse && index > 1 ? 5 - index : index;  // 17.5
        EXPECT_EQ(d.uo(lock ? 0 : index, TablePalette), byte_of(rgb[shown], 1, 1))
            << index << ", inverse " << inverse << ", lock " << lock;
      }
  d.bench["active_i"].drive(0);
  EXPECT_EQ(d.uo(3, TablePalette), 0x88);
}

// Header, Comb: with palette 3 the pins follow colours_i alone, in the lock effect too.
TYPED_TEST(PixelOutputColoursTest, ColoursReachThePinsWithoutAClock) {
  auto& d = this->dut;
  for (const int lock : {0, 1}) {
    d.bench["lock_i"].drive(lock);
    d.uo(0, TablePalette);
    for (int colour = 63; colour >= 0; --colour) {
      d.bench["colours_i"].drive(colour);
      d.bench.settle();
      const int rgb[3] = {colour >> 4, colour >> 2 & 3, colour & 3};
      ASSERT_EQ(d.bench["uo_o"].value(), byte_of(rgb, 1, 1)) << colour << ", lock " << lock;
    }
  }
}

TYPED_TEST(PixelOutputColoursTest, ColoursHaveNoEffectOnTheChipsPalettes) {
  auto& d = this->dut;
  for (int bit = 0; bit <= ColoursBits; ++bit) {
    d.bench["colours_i"].drive(bit == ColoursBits ? low_bits(ColoursBits) : 1 << bit);
    for (int palette = 0; palette < 3; ++palette)
      for (int index = 0; index < 4; ++index)
        ASSERT_EQ(d.uo(index, palette), byte_of(Colours[palette][index], 1, 1)) << bit;
  }
}

}  // namespace
}  // namespace racebeam
