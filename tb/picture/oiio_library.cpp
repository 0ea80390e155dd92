// libracebeam_images.so: the one file of the program that knows OpenImageIO.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/oiioversion.h>

#include "tb/picture/image_library.h"

namespace {

constexpr int Channels = 3;
constexpr int FontSize = 14;  // pixels
constexpr float Ink[Channels] = {224 / 255.0F, 224 / 255.0F, 224 / 255.0F};

void put_text(std::uint8_t* rgb, int width, int height, const std::string& words, int left,
              int right, int baseline) {
  OIIO::ImageBuf picture(OIIO::ImageSpec(width, height, Channels, OIIO::TypeDesc::UINT8), rgb);
  const OIIO::ROI roi(left, right, 0, height, 0, 1, 0, Channels);
  using OIIO::ImageBufAlgo::TextAlignX;
  using OIIO::ImageBufAlgo::TextAlignY;
  for (const char* font : {"", "DejaVuSans", "LiberationSans-Regular"}) {
    if (OIIO::ImageBufAlgo::render_text(picture, left, baseline, words, FontSize, font, Ink,
                                        TextAlignX::Left, TextAlignY::Baseline, 0, roi))
      return;
    (void)picture.geterror();
  }
}

}  // namespace

extern "C" {
extern const racebeam::ImageLibrary racebeam_image_library;
const racebeam::ImageLibrary racebeam_image_library = {OIIO_VERSION_STRING, put_text};
}
