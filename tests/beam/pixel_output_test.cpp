// Promises of sc/beam/pixel_output.h: contract sections 4, 15, 17.4 and 17.5.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/pixel_output.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/beam/pixel_output_bench.h"

namespace racebeam {
namespace {

/// 15.1, shading B: by w, sign and odd line.
constexpr int Dithered[3][2][2] = {{{0, 1}, {3, 3}}, {{1, 1}, {2, 3}}, {{1, 2}, {2, 2}}};

TYPED_TEST_SUITE(PixelOutputTest, Twins);

// 15.2, trace: frame 2, y = -240, columns 0, 1, 2.
TYPED_TEST(PixelOutputTest, FirstColumnsOfFrame2AreThoseOfTheTrace) {
  EXPECT_EQ(this->dut.uo(0, 0), 0x88);
  EXPECT_EQ(this->dut.uo(3, 0), 0xCF);
  EXPECT_EQ(this->dut.uo(2, 0), 0xAC);
}

TYPED_TEST(PixelOutputTest, PalettesAreThoseOfTheTable) {
  for (int palette = 0; palette < 3; ++palette)
    for (int index = 0; index < 4; ++index)
      EXPECT_EQ(this->dut.uo(index, palette), byte_of(Colours[palette][index], 1, 1))
          << "palette " << palette << " index " << index;
}

// 15.2: black when not active; the syncs pass through with no latency.
TYPED_TEST(PixelOutputTest, BlankedPixelsAreBlackAndSyncsStillPass) {
  auto& d = this->dut;
  for (int n = 0; n < 96; ++n) {
    const int display = n & 3, hsync = n >> 2 & 1, vsync = n >> 3 & 1, active = n >> 4 & 1;
    const int palette = n >> 5;
    d.bench["hsync_ni"].drive(hsync);
    d.bench["vsync_ni"].drive(vsync);
    d.bench["active_i"].drive(active);
    const int black[3] = {0, 0, 0};
    EXPECT_EQ(d.uo(display, palette),
              byte_of(active ? Colours[palette][display] : black, hsync, vsync))
        << "case " << n;
  }
}

// 15.1, shading A: x wall 3, y wall 2, z wall 1; neither signs nor lines matter.
TYPED_TEST(PixelOutputTest, ShadingAIsByAxis) {
  for (int face = 0; face < 3; ++face)
    for (int signs = 0; signs < 8; ++signs)
      for (const int y : {0, 1, -240, -239, 251})
        EXPECT_EQ(this->dut.value(face, signs, y, 0), 3 - face);
}

// 15.1, shading B: only the sign of the wall's own axis and bit 0 of y matter.
TYPED_TEST(PixelOutputTest, ShadingBIsByAxisSideAndLine) {
  for (int face = 0; face < 3; ++face)
    for (int signs = 0; signs < 8; ++signs)
      for (const int y : {0, 1, -240, -239, 250, 251})
        EXPECT_EQ(this->dut.value(face, signs, y, 1), Dithered[face][signs >> face & 1][y & 1])
            << "face " << face << " signs " << signs << " y " << y;
}

// Section 14: whatever is accepted while starving gets index 0.
TYPED_TEST(PixelOutputTest, EverythingOfferedWhileStarvingIsIndex0) {
  for (int n = 0; n < 96; ++n)
    EXPECT_EQ(this->dut.value(n % 3, n / 3 & 7, n / 24 & 1, n / 48, 1), 0) << "case " << n;
}

// 17.4: index = (dr2_x[6:5] OR dr2_z[5:4]) AND dr2_y[7:6], whatever the FIFO shows.
TYPED_TEST(PixelOutputTest, LockShowsThePatternOfTheRayDirection) {
  constexpr unsigned Seed = 174;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  auto& d = this->dut;
  d.bench["lock_i"].drive(1);
  for (int n = 0; n < 5000; ++n) {
    vec3 dr;
    for (auto& element : dr) element = static_cast<int>(random() % 1024) - 512;
    d.bench.drive("dr2", "_i", dr);
    d.bench["display_i"].drive(static_cast<int>(random() % 4));
    const int x = (dr[0] >> 5) & 3, y = (dr[1] >> 6) & 3, z = (dr[2] >> 4) & 3;
    d.bench.clock();
    ASSERT_EQ(d.index(), (x | z) & y) << dr[0] << ' ' << dr[1] << ' ' << dr[2];
  }
}

TYPED_TEST(PixelOutputTest, LockFollowsTheRayWithoutAClock) {
  auto& d = this->dut;
  d.bench["display_i"].drive(1);
  d.bench.drive("dr2", "_i", {0x60, 0xC0, 0});
  EXPECT_EQ(d.index(), 1) << "the FIFO's";
  d.bench["lock_i"].drive(1);
  EXPECT_EQ(d.index(), 3) << "the pattern's";
  d.bench.drive("dr2", "_i", {0x20, 0xC0, 0});
  EXPECT_EQ(d.index(), 1);
  d.bench.drive("dr2", "_i", {0x20, 0xC0, 0x20});
  EXPECT_EQ(d.index(), 3);
  d.bench.drive("dr2", "_i", {0x20, 0x80, 0x20});
  EXPECT_EQ(d.index(), 2);
  d.bench["lock_i"].drive(0);
  EXPECT_EQ(d.index(), 1) << "the FIFO's again";
  d.bench["lock_i"].drive(1);
  EXPECT_EQ(d.index(), 2) << "the pattern's again";
}

// The ray may move while lock is off; turning lock on shows where it is now.
TYPED_TEST(PixelOutputTest, LockShowsARayThatMovedWhileItWasOff) {
  auto& d = this->dut;
  d.bench["lock_i"].drive(1);
  d.bench.drive("dr2", "_i", {0x60, 0xC0, 0});
  EXPECT_EQ(d.index(), 3);
  d.bench["lock_i"].drive(0);
  EXPECT_EQ(d.index(), 0);
  d.bench.drive("dr2", "_i", {0x20, 0x40, 0});
  d.bench.settle();
  d.bench["lock_i"].drive(1);
  EXPECT_EQ(d.index(), 1);
}

// 17.5: indices 2 and 3 change places, after the lock effect.
TYPED_TEST(PixelOutputTest, InverseSwapsIndices2And3) {
  auto& d = this->dut;
  d.bench["inverse_i"].drive(1);
  const int swapped[4] = {0, 1, 3, 2};
  for (int palette = 0; palette < 3; ++palette)
    for (int index = 0; index < 4; ++index)
      EXPECT_EQ(d.uo(index, palette), byte_of(Colours[palette][swapped[index]], 1, 1));
  d.bench["lock_i"].drive(1);
  for (int pattern = 0; pattern < 4; ++pattern) {
    d.bench.drive("dr2", "_i", {pattern << 5, 3 << 6, 0});
    EXPECT_EQ(d.index(), swapped[pattern]) << "pattern " << pattern;
  }
}

// The blanked lock pattern is black too.
TYPED_TEST(PixelOutputTest, LockIsBlankedOutsideTheVisibleArea) {
  auto& d = this->dut;
  d.bench["lock_i"].drive(1);
  d.bench["active_i"].drive(0);
  d.bench.drive("dr2", "_i", {0x60, 0xC0, 0});
  EXPECT_EQ(d.uo(3, 2), 0x88);
}

template <class Unit>
class PixelOutputKnobs : public testing::Test {};
TYPED_TEST_SUITE(PixelOutputKnobs, Twins);

// Knob dithering = off: odd lines are shaded as even ones are.
TYPED_TEST(PixelOutputKnobs, WithoutDitheringShadingBIsTheSameOnAllLines) {
  knobs k;
  k.dithering = 0;
  Dut<TypeParam> d(k);
  for (int face = 0; face < 3; ++face)
    for (int signs = 0; signs < 8; ++signs)
      for (const int y : {0, 1})
        EXPECT_EQ(d.value(face, signs, y, 1), Dithered[face][signs >> face & 1][0]);
}

TYPED_TEST(PixelOutputKnobs, WithoutDitheringShadingAIsUnchanged) {
  knobs k;
  k.dithering = 0;
  Dut<TypeParam> d(k);
  for (int face = 0; face < 3; ++face)
    for (const int y : {0, 1}) EXPECT_EQ(d.value(face, 7, y, 0), 3 - face);
}

// Knob dithering = checkered: the half tone travels beside the lower index, and shows where column
// plus line is odd.
TYPED_TEST(PixelOutputKnobs, CheckeredShadingBIsTwoIndicesInTurnBehindTheFifo) {
  knobs k;
  k.dithering = DitheringCheckered;
  Dut<TypeParam> d(k);
  for (int face = 0; face < 3; ++face)
    for (int signs = 0; signs < 8; ++signs)
      for (const int y : {0, 1, -240, 239}) {
        const auto& tones = Dithered[face][signs >> face & 1];
        const int value = d.value(face, signs, y, 1), half = d.bench["half_o"].value();
        EXPECT_EQ(value, tones[0]) << "whatever the line";
        EXPECT_EQ(half, tones[1] - tones[0]);
        d.bench["display_half_i"].drive(half);
        d.bench["display_i"].drive(value);
        for (int column = 0; column < 640; column += 53)
          for (const int second : {0, 1}) {
            d.bench["x2_i"].drive(static_cast<std::uint64_t>(2 * (column - 320) + second));
            EXPECT_EQ(d.index(), tones[(column + y) & 1]) << "column " << column << " line " << y;
          }
      }
}

TYPED_TEST(PixelOutputKnobs, CheckeredNothingElseHasHalfTones) {
  knobs k;
  k.dithering = DitheringCheckered;
  Dut<TypeParam> d(k);
  for (int face = 0; face < 3; ++face)
    for (const int y : {0, 1}) {
      EXPECT_EQ(d.value(face, 7, y, 0), 3 - face) << "shading A";
      EXPECT_EQ(d.bench["half_o"].value(), 0u);
      EXPECT_EQ(d.value(face, 7, y, 1, 1), 0) << "starving";
      EXPECT_EQ(d.bench["half_o"].value(), 0u);
    }
  d.bench["display_half_i"].drive(1);
  d.bench["display_i"].drive(1);
  d.bench["x2_i"].drive(2);
  EXPECT_EQ(d.index(), 1) << "line 1";
  d.bench["x2_i"].drive(0);
  EXPECT_EQ(d.index(), 2);
  d.bench["y_i"].drive(0);
  EXPECT_EQ(d.index(), 1);
  d.bench["lock_i"].drive(1);
  d.bench["x2_i"].drive(2);
  EXPECT_EQ(d.index(), 0) << "the ray pattern's";
}

// The chip's own has none.
TYPED_TEST(PixelOutputTest, HalfTonesBehindTheFifoHaveNoEffect) {
  auto& d = this->dut;
  d.bench["display_half_i"].drive(1);
  for (int n = 0; n < 8; ++n) {
    d.bench["x2_i"].drive(static_cast<std::uint64_t>(n));
    EXPECT_EQ(d.value(0, 0, n & 1, 1), Dithered[0][0][n & 1]);
    EXPECT_EQ(d.bench["half_o"].value(), 0u);
    EXPECT_EQ(d.uo(1, 2), byte_of(Colours[2][1], 1, 1));
  }
}

// Knob dr_bits: the pattern is that of the direction in the scale of 10 bits.
template <class Unit>
void expect_pattern_of(int bits) {
  knobs k;
  k.dr_bits = bits;
  Dut<Unit> d(k);
  d.bench["lock_i"].drive(1);
  std::mt19937 random(bits);
  for (int n = 0; n < 1000; ++n) {
    vec3 dr, chip;  // in the knob's scale, and in that of 10 bits
    for (int a = 0; a < 3; ++a) {
      dr[a] = wrap_signed(static_cast<int>(random()), bits);
      chip[a] = rescaled(dr[a], bits, 10);
    }
    d.bench.drive("dr2", "_i", dr);
    ASSERT_EQ(d.index(), (chip[0] >> 5 | chip[2] >> 4) & chip[1] >> 6 & 3) << n;
  }
}

TYPED_TEST(PixelOutputKnobs, PatternOf8BitDirectionsIsTheChips) { expect_pattern_of<TypeParam>(8); }
TYPED_TEST(PixelOutputKnobs, PatternOf13BitDirectionsIsTheChips) {
  expect_pattern_of<TypeParam>(13);
}

}  // namespace
}  // namespace racebeam
