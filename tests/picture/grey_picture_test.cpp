// Grey pictures read by OpenImageIO: numbers as they are in the file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/grey_picture.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <array>
#include <fstream>

#include "tb/picture/png_file.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::ElementsAre;

std::string file_of(const std::string& name, const std::string& bytes) {
  static const ScratchFolder folder;
  std::ofstream(folder / name, std::ios::binary) << bytes;
  return folder / name;
}

TEST(GreyPictureTest, KeepsBytes) {
  GreyPicture picture;
  ASSERT_EQ(read_grey_picture(file_of("a.pgm", "P2 3 2 255  0 1 128  254 255 7\n"), picture), "");
  EXPECT_EQ(picture.width, 3);
  EXPECT_EQ(picture.height, 2);
  EXPECT_EQ(picture.bits, 8);
  EXPECT_THAT(picture.pixels, ElementsAre(0, 1, 128, 254, 255, 7));
  EXPECT_EQ(picture.at(1, 1), 255);
}

TEST(GreyPictureTest, KeepsSixteenBits) {
  const std::array<std::uint16_t, 4> pixels{0x0001, 0x1234, 0xffff, 0x8000};
  const std::string path = file_of("b.png", "");
  const auto out = OIIO::ImageOutput::create("png");
  ASSERT_TRUE(out && out->open(path, OIIO::ImageSpec(2, 2, 1, OIIO::TypeDesc::UINT16)));
  ASSERT_TRUE(out->write_image(OIIO::TypeDesc::UINT16, pixels.data()) && out->close());
  GreyPicture picture;
  ASSERT_EQ(read_grey_picture(path, picture), "");
  EXPECT_EQ(picture.bits, 16);
  EXPECT_THAT(picture.pixels, ElementsAre(0x0001, 0x1234, 0xffff, 0x8000));
}

TEST(GreyPictureTest, TakesEqualChannelsForGrey) {
  RgbImage image(2, 1);
  image.dot(0, 0, {9, 9, 9});
  image.dot(1, 0, {200, 200, 200});
  GreyPicture picture;
  ASSERT_EQ(read_grey_picture(file_of("c.png", png_bytes(image)), picture), "");
  EXPECT_THAT(picture.pixels, ElementsAre(9, 200));
  image.dot(1, 0, {200, 200, 201});
  EXPECT_EQ(read_grey_picture(file_of("d.png", png_bytes(image)), picture),
            "it has colours: it must be grey");
}

TEST(GreyPictureTest, SaysWhyThereIsNone) {
  GreyPicture picture;
  EXPECT_EQ(read_grey_picture("/nowhere/at/all.png", picture), "there is no such file");
  EXPECT_EQ(read_grey_picture("/dev/zero", picture), "this is no file");
  EXPECT_NE(read_grey_picture(file_of("e.png", "no picture"), picture), "");
  const std::string whole = png_bytes(RgbImage(200, 200, {7, 7, 7}));
  EXPECT_EQ(read_grey_picture(file_of("f.png", whole), picture), "");
  EXPECT_NE(read_grey_picture(file_of("g.png", whole.substr(0, whole.size() / 2)), picture), "");
}

}  // namespace
}  // namespace racebeam
