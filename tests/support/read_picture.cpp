// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/read_picture.h"

#include <OpenImageIO/imageio.h>

namespace racebeam {

Picture read_picture(const std::string& path, int index, int& width, int& height) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in || !in->seek_subimage(index, 0)) return {};
  width = in->spec().width;
  height = in->spec().height;
  const int channels = in->spec().nchannels;
  Picture bytes(static_cast<std::size_t>(width) * height * channels), picture;
  if (!in->read_image(index, 0, 0, channels, OIIO::TypeDesc::UINT8, bytes.data())) return {};
  for (std::size_t i = 0; i < bytes.size(); i += channels) {
    const int r = bytes[i], g = bytes[i + 1], b = bytes[i + 2];
    picture.push_back(r % 85 || g % 85 || b % 85 ? 255 : (r * 16 + g * 4 + b) / 85);
  }
  return picture;
}

Picture read_picture(const std::string& path, int index) {
  int width, height;
  return read_picture(path, index, width, height);
}

}  // namespace racebeam
