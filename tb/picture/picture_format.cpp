// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/picture_format.h"

#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/base/output_file.h"
#include "tb/picture/image_library.h"
#include "tb/picture/png_file.h"

namespace racebeam {

namespace {

const PictureFormat* find_format(const std::string& name) {
  for (const PictureFormat& format : picture_formats())
    if (format.name == name) return &format;
  return nullptr;
}

}  // namespace

const std::vector<PictureFormat>& picture_formats() {
  static const std::vector<PictureFormat> formats = {
      {"png", nullptr, nullptr, "exact, and the smallest"},
      {"exr", "openexr", "zip", "exact; linear light as 16-bit floats", true},
      {"tif", "tiff", "zip", "exact"},
      {"tiff", "tiff", "zip", "exact"},
      {"jpg", "jpeg", "jpeg:95", "lossy"},
      {"jpeg", "jpeg", "jpeg:95", "lossy"},
      {"webp", "webp", "webp:90", "lossy"}};
  return formats;
}

const PictureFormat& picture_format(const std::string& name) {
  if (const PictureFormat* format = find_format(name)) return *format;
  std::vector<std::string> known;
  for (const PictureFormat& format : picture_formats()) known.push_back(format.name);
  throw unknown_name("picture format", name, known);
}

const PictureFormat* format_of_file(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension.empty() ? nullptr : find_format(extension.substr(1));
}

std::string picture_bytes(const PictureFormat& format, const RgbImage& picture) {
  if (!format.writer) return png_bytes(picture);
  const ImageLibrary& library = image_library();
  std::string bytes;
  const std::string error =
      library.encode(format, picture.bytes(), picture.width(), picture.height(), bytes);
  if (!error.empty())
    throw MissingTool(std::string("OpenImageIO ") + library.version + " cannot write ." +
                      format.name + ": " + error);
  return bytes;
}

std::string picture_bytes(const PictureFormat& format, const PackedPicture& picture) {
  return picture.bits == 2 ? picture_bytes(format, picture.colours, picture.width, picture.height)
                           : picture_bytes(format, RgbImage(picture));
}

std::string picture_bytes(const PictureFormat& format, const std::vector<std::uint8_t>& colours,
                          int width, int height) {
  return format.writer ? picture_bytes(format, RgbImage(colours, width, height, width, height))
                       : png_bytes(colours, width, height);
}

}  // namespace racebeam
