// Pictures come out of their packing as they went in, and damaged ones do not come out at all.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/packed.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace racebeam {
namespace {

using Colours = std::vector<std::uint8_t>;

Colours runs(const std::vector<std::size_t>& lengths) {
  Colours colours;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    colours.insert(colours.end(), lengths[i], static_cast<std::uint8_t>(i * 21 % 64));
  return colours;
}

void expect_same(const Colours& colours) {
  Colours again(colours.size(), 63);
  unpack_colours(packed_colours(colours), again);
  EXPECT_EQ(again, colours);
}

TEST(Packed, ColoursComeBackWhateverTheirRuns) {
  expect_same(runs({1, 2, 3, 4, 5, 127, 128, 129, 16'383, 16'384, 1}));
  expect_same(runs({640 * 480}));
  expect_same({});
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    Colours colours(5'000);
    for (std::uint8_t& colour : colours) colour = random() % 3 ? colours[0] : random() % 64;
    expect_same(colours);
  }
}

TEST(Packed, BytesComeBack) {
  const std::string bytes("\0\xff\x80 a", 5);
  EXPECT_EQ(unpacked(packed(bytes), bytes.size()), bytes);
  EXPECT_EQ(of_hex(hex_of(bytes)), bytes);
}

TEST(Packed, DamagedPicturesAreRefused) {
  const Colours colours = runs({3, 700, 2, 90});
  const std::string good = packed_colours(colours);
  const auto expect_refused = [](const std::string& runs, std::size_t size) {
    Colours places(size);
    EXPECT_THROW(unpack_colours(runs, places), std::runtime_error);
  };
  expect_refused(good, colours.size() - 1);
  expect_refused(good, colours.size() + 1);
  for (std::size_t size = 0; size < good.size(); ++size)
    expect_refused(good.substr(0, size), colours.size());
  // Runs that end within a length, and one without end.
  for (const std::string& runs : {std::string("\0", 1), std::string("\0\x80", 2),
                                  std::string("\0\0", 2), std::string(20, '\x80')})
    expect_refused(runs, 64);
}

TEST(Packed, NumbersComeBackAndOtherTextIsRefused) {
  using Numbers = std::vector<std::int64_t>;
  for (const Numbers& numbers : {Numbers{}, Numbers{0}, Numbers{-1, 7, INT64_MIN, INT64_MAX, 0}})
    EXPECT_EQ(numbers_of_text(text_of_numbers(numbers)), numbers);
  for (const char* bad : {" ", "1 ", "1  2", "1,2", "x", "1 x", "0x1", "9223372036854775808"})
    EXPECT_THROW(numbers_of_text(bad), std::runtime_error) << bad;
}

TEST(Packed, APictureKeepsItsSizeAndDepth) {
  PackedPicture picture{3, 2, 5, {}};
  for (std::uint32_t n = 0; n < 6; ++n) picture.push(n * 5000);
  const std::string bytes = packed_picture(picture);
  const PackedPicture again = unpacked_picture(bytes);
  EXPECT_EQ(again.width, 3);
  EXPECT_EQ(again.height, 2);
  EXPECT_EQ(again.bits, 5);
  EXPECT_EQ(again.colours, picture.colours);
  for (const std::string& bad : std::vector<std::string>{
           "", "3 2", "9" + bytes, "0 2 5 x", "3 2 11 x", bytes.substr(0, bytes.size() - 2)})
    EXPECT_THROW(unpacked_picture(bad), std::runtime_error) << bad;
}

}  // namespace
}  // namespace racebeam
