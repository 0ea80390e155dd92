// Pictures of other depths than the chip's, as files.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "tb/base/output_file.h"
#include "tb/picture/contact_sheet.h"
#include "tb/picture/gif_writer.h"
#include "tb/picture/picture_format.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

constexpr int Side = 48;

/// All levels of each channel.
PackedPicture ramps(int bits) {
  PackedPicture picture{Side, Side, bits, {}};
  const std::uint32_t most = (1u << bits) - 1;
  for (std::uint32_t y = 0; y < Side; ++y)
    for (std::uint32_t x = 0; x < Side; ++x)
      picture.push((x * most / (Side - 1)) << 2 * bits | (y * most / (Side - 1)) << bits |
                   (x * y & most));
  return picture;
}

/// Of 255, by the formula.
int light(std::uint32_t level, int bits) {
  return static_cast<int>(std::lround(level * 255.0 / ((1 << bits) - 1)));
}

/// A picture in a file as bytes.
RgbImage read_rgb(const std::string& path) {
  const auto in = OIIO::ImageInput::open(path);
  EXPECT_TRUE(in) << path;
  RgbImage image(in->spec().width, in->spec().height);
  const std::size_t channels = in->spec().nchannels;
  std::vector<std::uint8_t> bytes(channels * image.width() * image.height());
  EXPECT_TRUE(
      in->read_image(0, 0, 0, static_cast<int>(channels), OIIO::TypeDesc::UINT8, bytes.data()));
  for (int n = 0; n < image.width() * image.height(); ++n) {
    const std::uint8_t* const pixel = &bytes[channels * n];
    image.dot(n % image.width(), n / image.width(), {pixel[0], pixel[1], pixel[2]});
  }
  return image;
}

TEST(PictureDepth, AColourComesOutAsItWentIn) {
  for (const int bits : {2, 5, 8, 10}) {
    PackedPicture picture{2, 1, bits, {}};
    const std::uint32_t all = (1u << 3 * bits) - 1;
    for (const std::uint32_t colour : {all, all & 0x2A5A5A5A}) picture.push(colour);
    EXPECT_TRUE(picture.whole());
    EXPECT_EQ(picture.colour(0), all);
    EXPECT_EQ(picture.colour(1), all & 0x2A5A5A5A);
  }
}

TEST(PictureDepth, TheChipsIsAByteAPixel) {
  const PackedPicture picture{3, 1, 2, {0, 27, 63}};
  EXPECT_EQ(picture.colour(1), 27U);
  for (std::uint32_t colour = 0; colour < 64; ++colour)
    EXPECT_EQ(rgb_of(colour, 2), rgb_of(static_cast<int>(colour))) << colour;
}

TEST(PictureDepth, LevelsAreSpreadEvenlyOver255) {
  for (const int bits : {2, 5, 8, 10})
    for (std::uint32_t level = 0; level < 1u << bits; ++level) {
      const Rgb rgb = rgb_of(level << 2 * bits | level, bits);
      EXPECT_EQ(rgb.r, light(level, bits)) << bits << " bits, level " << level;
      EXPECT_EQ(rgb.g, 0);
      EXPECT_EQ(rgb.b, rgb.r);
    }
}

TEST(PictureDepth, APictureThatIsNotWholeIsRefused) {
  PackedPicture picture = ramps(5);
  picture.colours.pop_back();
  EXPECT_THROW(RgbImage image(picture), std::invalid_argument);
}

TEST(PictureDepth, AFileHasEveryPixel) {
  const ScratchFolder folder;
  for (const int bits : {5, 8, 10}) {
    const PackedPicture picture = ramps(bits);
    write_text(folder / "a.png", picture_bytes(picture_format("png"), picture));
    const RgbImage read = read_rgb(folder / "a.png");
    ASSERT_EQ(read.width(), Side);
    ASSERT_EQ(read.height(), Side);
    for (int n = 0; n < Side * Side; ++n)
      ASSERT_EQ(read.at(n % Side, n / Side), rgb_of(picture.colour(n), bits)) << bits << ", " << n;
  }
}

TEST(PictureDepth, AGifHasTheNearestOfItsColours) {
  const ScratchFolder folder;
  const PackedPicture picture = ramps(8);
  GifWriter gif(folder / "a.gif", Side, Side, 10, 1, picture.bits);
  gif.add(picture.colours);
  gif.close();
  const RgbImage read = read_rgb(folder / "a.gif");
  for (int n = 0; n < Side * Side; ++n) {
    const Rgb is = read.at(n % Side, n / Side), was = rgb_of(picture.colour(n), picture.bits);
    ASSERT_LE(std::abs(is.r - was.r), 26) << n;  // half a step of six levels
    ASSERT_LE(std::abs(is.g - was.g), 22) << n;  // of seven
    ASSERT_LE(std::abs(is.b - was.b), 26) << n;
  }
}

TEST(PictureDepth, ASheetTakesAnyDepth) {
  const ScratchFolder folder;
  PackedPicture white{Side, Side, 10, {}};
  for (int n = 0; n < Side * Side; ++n) white.push((1u << 30) - 1);
  write_contact_sheet(folder / "a.png", {{white.colours, "white", 10}}, Side, Side, 1, 1);
  const RgbImage sheet = read_rgb(folder / "a.png");
  EXPECT_EQ(sheet.at(sheet.width() / 2, Side / 2), (Rgb{255, 255, 255}));
  EXPECT_THROW(write_contact_sheet(folder / "b.png", {{white.colours, "white", 5}}, Side, Side, 1),
               std::invalid_argument);
}

}  // namespace
}  // namespace racebeam
