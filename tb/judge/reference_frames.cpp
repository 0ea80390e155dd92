// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/reference_frames.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <limits>
#include <utility>
#include <vector>

#include "tb/base/counted.h"
#include "tb/base/csv_file.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"

namespace racebeam {

namespace {

constexpr const char* Demo = "demo";
constexpr const char *Number = "frame", *Image = "image_crc32", *Pins = "pins_crc32";

std::string path_of(const std::string& name) {
  return name == Demo ? project_folder() + "/tests/reference/chip_frames.csv" : name;
}

/// The columns that the file's first line asks for; all if it is another line.
std::vector<std::string> columns_of(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  const auto names = [&](const char* column) { return line.find(column) != std::string::npos; };
  std::vector<std::string> columns = {Number};
  if (names(Image) || !names(Pins)) columns.emplace_back(Image);
  if (names(Pins) || !names(Image)) columns.emplace_back(Pins);
  return columns;
}

std::uint32_t checksum(const CsvFile& file, std::size_t column) {
  const std::string& text = file.text(column);
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, 16);
  if (error != std::errc{} || stop != end)
    file.fail(column, "is '" + text + "', must be a checksum of up to 8 hexadecimal digits");
  return value;
}

}  // namespace

ReferenceFrames::ReferenceFrames(const std::string& name) : name_(name) {
  const std::string path = path_of(name);
  const std::vector<std::string> columns = columns_of(path);
  CsvFile file(path, columns);
  while (file.next()) {
    const int number = static_cast<int>(file.number(0, 0, std::numeric_limits<int>::max()));
    Frame frame;
    for (std::size_t column = 1; column < columns.size(); ++column)
      (columns[column] == Image ? frame.image : frame.pins) = checksum(file, column);
    if (!frames_.emplace(number, frame).second)
      file.fail(0, fmt::format("is {} a second time; each frame may have one line", number));
  }
  if (frames_.empty()) throw UsageError(path + " has no frames; each has a line below the first");
  has_image_ = frames_.begin()->second.image.has_value();
  has_pins_ = frames_.begin()->second.pins.has_value();
}

std::string ReferenceFrames::whose() const {
  return name_ == Demo ? "the taped-out chip's" : "those of " + name_;
}

const char* ReferenceFrames::what() const {
  return !has_pins_ ? "picture" : !has_image_ ? "pins" : "picture and pins";
}

const ReferenceFrames::Frame* ReferenceFrames::find(int frame) const {
  const auto at = frames_.find(frame);
  return at == frames_.end() ? nullptr : &at->second;
}

std::string ReferenceFrames::extent() const {
  return fmt::format("{} from {} to {}", counted(static_cast<int>(frames_.size()), "frame"),
                     frames_.begin()->first, frames_.rbegin()->first);
}

}  // namespace racebeam
