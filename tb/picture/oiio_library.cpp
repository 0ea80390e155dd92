// libracebeam_images.so: the one file of the program that knows OpenImageIO.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/oiioversion.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tb/picture/grey_picture.h"
#include "tb/picture/image_library.h"
#include "tb/picture/picture_format.h"

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

/// A file in memory that has a name: not every writer of OpenImageIO takes anything else.
class MemoryFile {
 public:
  MemoryFile() : file_(memfd_create("picture", MFD_CLOEXEC)) {}
  ~MemoryFile() {
    if (file_ >= 0) close(file_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string name() const { return "/proc/self/fd/" + std::to_string(file_); }
  std::string bytes() const {
    const off_t size = lseek(file_, 0, SEEK_END);
    std::string bytes(size > 0 ? static_cast<std::size_t>(size) : 0, 0);
    const ssize_t got = pread(file_, bytes.data(), bytes.size(), 0);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
  }

 private:
  int file_;
};

/// The light of each byte of sRGB, 0..1.
std::array<float, 256> light_of_bytes() {
  std::array<float, 256> light{};
  for (int byte = 0; byte < 256; ++byte) {
    const double c = byte / 255.0;
    light[byte] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return light;
}

std::string encode(const racebeam::PictureFormat& format, const std::uint8_t* rgb, int width,
                   int height, std::string& bytes) {
  using OIIO::TypeDesc;
  const auto out = OIIO::ImageOutput::create(format.writer);
  if (!out) return OIIO::geterror();
  OIIO::ImageSpec spec(width, height, Channels, format.light ? TypeDesc::HALF : TypeDesc::UINT8);
  spec.attribute("compression", format.compression);
  if (format.writer == std::string("jpeg")) spec.attribute("jpeg:subsampling", "4:4:4");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // the same picture makes the same file
  spec.attribute("oiio:ColorSpace", format.light ? "Linear" : "sRGB");
  const MemoryFile file;
  if (!out->open(file.name(), spec)) return out->geterror();
  bool good = false;
  if (format.light) {
    static const std::array<float, 256> light_of = light_of_bytes();
    const std::size_t samples = static_cast<std::size_t>(width) * height * Channels;
    std::vector<float> light(samples);
    for (std::size_t i = 0; i < samples; ++i) light[i] = light_of[rgb[i]];
    good = out->write_image(TypeDesc::FLOAT, light.data());
  } else {
    good = out->write_image(TypeDesc::UINT8, rgb);
  }
  if (!good || !out->close()) return out->geterror();
  bytes = file.bytes();
  return bytes.empty() ? "nothing was written" : "";
}

std::string read_grey(const std::string& path, racebeam::GreyPicture& to) {
  constexpr std::size_t Most = std::size_t{1} << 25;  // pixels: columns of the largest world
  const auto in = OIIO::ImageInput::open(path);
  if (!in) {
    const std::string why = OIIO::geterror();
    return why.empty() ? "this is no picture" : why;
  }
  const OIIO::ImageSpec& spec = in->spec();
  const int colours = std::min(spec.nchannels, Channels) - (spec.nchannels == 2 ? 1 : 0);
  const std::size_t pixels = static_cast<std::size_t>(spec.width) * spec.height;
  if (pixels > Most) return "it has more than " + std::to_string(Most) + " pixels";
  std::vector<std::uint16_t> samples(pixels * colours);
  if (!in->read_image(0, 0, 0, colours, OIIO::TypeDesc::UINT16, samples.data())) {
    const std::string why = in->geterror();
    return why.empty() ? "it ends too early" : why;
  }
  const bool narrow = spec.format.size() == 1;
  to = {spec.width, spec.height, narrow ? 8 : 16, std::vector<std::uint16_t>(pixels)};
  for (std::size_t n = 0; n < pixels; ++n) {
    const std::uint16_t* const sample = &samples[n * colours];
    for (int c = 1; c < colours; ++c)
      if (sample[c] != sample[0]) return "it has colours: it must be grey";
    to.pixels[n] = narrow ? sample[0] / 257 : sample[0];
  }
  return "";
}

}  // namespace

extern "C" {
extern const racebeam::ImageLibrary racebeam_image_library;
const racebeam::ImageLibrary racebeam_image_library = {OIIO_VERSION_STRING, put_text, encode,
                                                       read_grey};
}
