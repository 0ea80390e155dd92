// Each format of pictures keeps what it says, read back by OpenImageIO.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/picture/picture_format.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

constexpr int Width = 200, Height = 150;

/// A picture as bytes of sRGB, of whatever it is kept as; empty if it is none.
std::vector<int> srgb_of(const std::string& path) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in || in->spec().width != Width || in->spec().height != Height || in->spec().nchannels != 3)
    return {};
  const bool light = in->spec().get_string_attribute("oiio:ColorSpace") == "Linear";
  EXPECT_EQ(light, in->spec().format == OIIO::TypeDesc::HALF);
  std::vector<float> samples(Width * Height * 3);
  if (!in->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, samples.data())) return {};
  std::vector<int> bytes;
  for (const float v : samples) {
    const double shown = !light           ? v
                         : v <= 0.0031308 ? 12.92 * v
                                          : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    bytes.push_back(static_cast<int>(std::lround(255 * shown)));
  }
  return bytes;
}

double mean_difference(const std::vector<int>& a, const std::vector<int>& b) {
  if (a.empty() || a.size() != b.size()) return 255;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

/// Stripes of all bytes in each channel, and a stretch of noise.
RgbImage all_bytes() {
  RgbImage picture(Width, Height);
  std::mt19937 random(7);
  const auto byte = [](unsigned n) { return static_cast<std::uint8_t>(n); };
  for (int y = 0; y < Height; ++y)
    for (int x = 0; x < Width; ++x) {
      const unsigned n = static_cast<unsigned>(y / 2 + x / 2 * 3);
      picture.dot(x, y, {byte(n), byte(n * 5 + 1), byte(y < 20 ? random() : n / 2)});
    }
  return picture;
}

TEST(PictureFormats, EachKeepsThePictureAsItsNoteSays) {
  const ScratchFolder folder;
  const RgbImage picture = all_bytes();
  const std::vector<int> bytes(picture.bytes(), picture.bytes() + 3 * Width * Height);
  for (const PictureFormat& format : picture_formats()) {
    const std::string path = folder / (std::string("a.") + format.name), note = format.note;
    ASSERT_EQ(format_of_file(path), &format);
    write_text(path, picture_bytes(format, picture));
    const double difference = mean_difference(srgb_of(path), bytes);
    if (note.find("lossy") == std::string::npos) {
      EXPECT_EQ(difference, 0) << format.name;
    } else {
      EXPECT_GT(difference, 0) << format.name;
      EXPECT_LT(difference, 12) << format.name;
    }
    EXPECT_EQ(picture_bytes(format, picture), picture_bytes(format, picture)) << format.name;
  }
}

TEST(PictureFormats, ColoursOfTheChipAreThoseOfTheirPicture) {
  std::vector<std::uint8_t> colours(Width * Height);
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = i / 7 % 64;
  for (const PictureFormat& format : picture_formats())
    EXPECT_EQ(picture_bytes(format, colours, Width, Height),
              picture_bytes(format, RgbImage(colours, Width, Height, Width, Height)))
        << format.name;
}

TEST(PictureFormats, NamesAreOfAnyCaseInFilesAndOthersAreRefused) {
  EXPECT_EQ(format_of_file("a/b.EXR"), &picture_format("exr"));
  EXPECT_EQ(format_of_file("a.png"), &picture_formats().front());
  for (const char* other : {"", "a", "a.v2", "png", "a.png/b"})
    EXPECT_EQ(format_of_file(other), nullptr) << other;
  EXPECT_THROW(picture_format("gif"), UsageError);
}

TEST(PictureFormats, WhatOpenImageIOCannotWriteIsTold) {
  const PictureFormat strange{"xyz", "xyz", "none", ""};
  try {
    picture_bytes(strange, RgbImage(4, 4));
    FAIL();
  } catch (const MissingTool& error) {
    EXPECT_EQ(std::string(error.what()).find("OpenImageIO 2"), 0u);
    EXPECT_NE(std::string(error.what()).find("cannot write .xyz: "), std::string::npos);
  }
}

}  // namespace
}  // namespace racebeam
