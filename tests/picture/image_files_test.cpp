// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <random>
#include <stdexcept>

#include "tb/base/output_file.h"
#include "tb/picture/contact_sheet.h"
#include "tb/picture/gif_writer.h"
#include "tb/picture/png_file.h"
#include "tests/support/gif_delays.h"
#include "tests/support/read_picture.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

/// Runs of random length in `colours` colours, of which the last ones are rare.
Picture random_picture(int width, int height, int colours, unsigned seed) {
  std::mt19937 random(seed);
  Picture picture;
  while (picture.size() < static_cast<std::size_t>(width) * height) {
    const int rank = static_cast<int>(random() % colours) & static_cast<int>(random() % colours);
    picture.insert(picture.end(), 1 + random() % 9, (rank * 37 + seed) & 63);
  }
  picture.resize(static_cast<std::size_t>(width) * height);
  return picture;
}

/// So many colours, each in a row of its own.
RgbImage rows_of_colours(int colours) {
  RgbImage picture(40, colours);
  for (int y = 0; y < colours; ++y)
    picture.fill(0, y, 40, 1, {static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(y >> 8), 7});
  return picture;
}

/// Bytes of the RGB PNG that OpenImageIO makes of a picture.
std::size_t size_by_openimageio(const Picture& picture, int width, int height) {
  const RgbImage rgb(picture, width, height, width, height);
  OIIO::Filesystem::IOVecOutput bytes;
  const auto out = OIIO::ImageOutput::create("png");
  out->set_ioproxy(&bytes);
  EXPECT_TRUE(out->open("a.png", OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8)));
  EXPECT_TRUE(out->write_image(OIIO::TypeDesc::UINT8, rgb.bytes()));
  EXPECT_TRUE(out->close());
  return bytes.buffer().size();
}

class ImageFiles : public testing::Test {
 protected:
  ScratchFolder folder;

  /// Bits a sample and colour type, as the header of a PNG file says.
  std::pair<int, int> png_kind(const std::string& name) const {
    char bytes[26] = {};
    std::ifstream(folder / name, std::ios::binary).read(bytes, sizeof bytes);
    return {bytes[24], bytes[25]};
  }
};

constexpr int PngRgb = 2, PngPalette = 3;

TEST_F(ImageFiles, PngKeepsAllColoursInAPaletteOfThose) {
  for (const auto& [colours, bits] :
       {std::pair{1, 1}, {2, 1}, {3, 2}, {4, 2}, {5, 4}, {16, 4}, {17, 8}, {64, 8}}) {
    Picture picture = random_picture(640, 480, colours, colours);
    for (int c = 0; c < colours; ++c) picture[c] = (c * 37 + colours) & 63;  // the rare ones too
    write_png(folder / "a.png", picture, 640, 480);
    EXPECT_EQ(read_picture(folder / "a.png"), picture) << colours;
    EXPECT_EQ(png_kind("a.png"), std::pair(bits, PngPalette)) << colours;
    EXPECT_LE(std::filesystem::file_size(folder / "a.png"), size_by_openimageio(picture, 640, 480))
        << colours;
    EXPECT_EQ(folder.files(), 1);
  }
}

TEST_F(ImageFiles, PngOfMoreThan256ColoursIsRgb) {
  for (const auto& [colours, type] : {std::pair{256, PngPalette}, {257, PngRgb}}) {
    const RgbImage picture = rows_of_colours(colours);
    write_png(folder / "a.png", picture);
    EXPECT_EQ(png_kind("a.png"), std::pair(8, type));
    const auto in = OIIO::ImageInput::open(folder / "a.png");
    ASSERT_TRUE(in && in->spec().nchannels == 3);
    Picture bytes(40 * colours * 3);
    ASSERT_TRUE(in->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, bytes.data()));
    EXPECT_EQ(bytes, Picture(picture.bytes(), picture.bytes() + bytes.size())) << colours;
  }
}

TEST_F(ImageFiles, PngRefusesASizeThatIsNotThePictures) {
  EXPECT_THROW(write_png(folder / "a.png", Picture(10), 3, 3), std::invalid_argument);
}

TEST_F(ImageFiles, GifKeepsAllColoursOfAllFrames) {
  for (const int colours : {1, 2, 4, 5, 64}) {
    GifWriter gif(folder / "a.gif", 320, 240, 25);
    std::vector<Picture> pictures;
    for (int i = 0; i < 4; ++i) {
      pictures.push_back(random_picture(320, 240, colours, i));
      gif.add(pictures.back());
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.gif")) << "not whole yet";
    gif.close();
    for (int i = 0; i < 4; ++i) EXPECT_EQ(read_picture(folder / "a.gif", i), pictures[i]) << i;
    std::filesystem::remove(folder / "a.gif");
  }
}

TEST_F(ImageFiles, GifSurvivesEveryLengthOfItsCodes) {
  // Noise fills the code table again and again; sizes up to 1000 end at every place in it.
  std::mt19937 random(5);
  for (int size = 1; size <= 1000; size += 1 + size / 20) {
    Picture noise(static_cast<std::size_t>(size) * 7);
    for (auto& colour : noise) colour = random() % 64;
    GifWriter gif(folder / "a.gif", size, 7, 10);
    gif.add(noise);
    gif.close();
    ASSERT_EQ(read_picture(folder / "a.gif"), noise) << size;
  }
}

TEST_F(ImageFiles, GifWritesOnlyWhatChanged) {
  Picture picture = random_picture(640, 480, 64, 3);
  GifWriter gif(folder / "a.gif", 640, 480, 10);
  gif.add(picture);
  gif.add(picture);
  picture[640 * 479 + 639] ^= 1;
  gif.add(picture);
  gif.close();
  EXPECT_EQ(gif.pictures(), 3);
  EXPECT_EQ(read_picture(folder / "a.gif", 1), read_picture(folder / "a.gif", 0));
  EXPECT_EQ(read_picture(folder / "a.gif", 2), picture);
  GifWriter once(folder / "b.gif", 640, 480, 10);
  once.add(random_picture(640, 480, 64, 3));
  once.close();
  EXPECT_LT(std::filesystem::file_size(folder / "a.gif"),
            std::filesystem::file_size(folder / "b.gif") + 60);
}

TEST_F(ImageFiles, GifPlaysAtTheRateOfItsFrames) {
  const auto delays = [&](double rate, int frames, int after = 1) {
    GifWriter gif(folder / "a.gif", 4, 4, rate);
    for (int i = 0; i < frames; ++i) gif.add(Picture(16), after);
    gif.close();
    const std::vector<int> all = gif_delays(folder / "a.gif");
    EXPECT_EQ(static_cast<int>(all.size()), gif.pictures());
    EXPECT_DOUBLE_EQ(std::accumulate(all.begin(), all.end(), 0) / 100.0, gif.seconds());
    return all;
  };
  EXPECT_EQ(delays(60, 60), std::vector<int>(50, 2));
  EXPECT_EQ(delays(50, 3), std::vector<int>(3, 2));
  EXPECT_EQ(delays(30, 3), (std::vector<int>{3, 4, 3}));
  EXPECT_EQ(delays(10, 3), std::vector<int>(3, 10));
  EXPECT_EQ(delays(0.25, 1), std::vector<int>{400});
  EXPECT_EQ(delays(60, 3, 6), (std::vector<int>{10, 10, 2})) << "five of six frames left out";
  EXPECT_THROW(delays(0, 1), std::invalid_argument);
}

TEST_F(ImageFiles, GifOf60FramesPerSecondLeavesOutOneOfSix) {
  GifWriter gif(folder / "a.gif", 4, 4, 60);
  for (int i = 0; i < 12; ++i) gif.add(Picture(16, static_cast<std::uint8_t>(i)));
  gif.close();
  const int kept[] = {0, 1, 2, 3, 5, 6, 7, 8, 9, 11};
  ASSERT_EQ(gif.pictures(), 10);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(read_picture(folder / "a.gif", i), Picture(16, kept[i]));
}

TEST_F(ImageFiles, GifDownscaleKeepsTheTopLeftPixels) {
  const Picture picture = random_picture(64, 48, 64, 9);
  GifWriter gif(folder / "a.gif", 64, 48, 10, 3);
  gif.add(picture);
  gif.close();
  int width = 0, height = 0;
  const Picture small = read_picture(folder / "a.gif", 0, width, height);
  ASSERT_EQ(width, 21);
  ASSERT_EQ(height, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 21; ++x) EXPECT_EQ(small[y * 21 + x], picture[y * 3 * 64 + x * 3]);
}

TEST_F(ImageFiles, GifNotClosedLeavesNothing) {
  {
    GifWriter gif(folder / "a.gif", 4, 4, 10);
    gif.add(Picture(16));
  }
  EXPECT_EQ(folder.files(), 0);
}

TEST_F(ImageFiles, ContactSheetHoldsEveryThumbnail) {
  std::vector<SheetFrame> frames;
  for (int i = 0; i < 5; ++i) frames.push_back({Picture(64 * 48, i * 13 & 63), "frame"});
  write_contact_sheet(folder / "a.png", frames, 64, 48, 3, 2);
  int width = 0, height = 0;
  const Picture sheet = read_picture(folder / "a.png", 0, width, height);
  ASSERT_EQ(width, 3 * (32 + 8) + 8);
  ASSERT_EQ(height, 2 * (24 + 22 + 8) + 8);
  for (int i = 0; i < 5; ++i)
    for (const int inside : {0, 23}) {
      const int x = 8 + i % 3 * 40 + inside, y = 8 + i / 3 * 54 + inside;
      EXPECT_EQ(sheet[y * width + x], i * 13 & 63) << i;
    }
  EXPECT_THROW(write_contact_sheet(folder / "a.png", {}, 64, 48, 3), std::invalid_argument);
}

TEST_F(ImageFiles, FullDiskIsNoticedAndLeavesNothing) {
  const Picture picture = random_picture(640, 480, 64, 1);
  const FileSizeLimit limit(40000);
  try {
    write_png(folder / "a.png", picture, 640, 480);
    ADD_FAILURE() << "not noticed";
  } catch (const OutputError& error) {
    EXPECT_EQ(error.what(), "cannot write " + (folder / "a.png") + ": File too large");
  }
  EXPECT_THROW(write_contact_sheet(folder / "b.png", {{picture, "one"}}, 640, 480, 1, 1),
               OutputError);
  {
    GifWriter gif(folder / "c.gif", 640, 480, 10);
    EXPECT_THROW(
        {
          gif.add(picture);
          gif.close();
        },
        OutputError);
  }
  EXPECT_EQ(folder.files(), 0);
}

TEST_F(ImageFiles, ErrorsNameThePathAndTheReason) {
  const std::string path = folder / "no/a.png";
  try {
    write_png(path, Picture(1), 1, 1);
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_EQ(error.what(), "cannot write " + path + ": No such file or directory");
  }
  EXPECT_THROW(GifWriter(folder / "no/a.gif", 4, 4, 10), OutputError);
}

}  // namespace
}  // namespace racebeam
