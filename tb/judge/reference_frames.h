// ReferenceFrames: checksums of the frames of a chip, from a CSV file.
//
// The first line is `frame,image_crc32,pins_crc32`; one of the checksums may be left out. Then any
// frames in any order, each once. The checksums are those of `racebeam render --crc`, in up to 8
// hexadecimal digits.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace racebeam {

class ReferenceFrames {
 public:
  struct Frame {
    std::optional<std::uint32_t> image, pins;
  };

  /// From a file, or, called "demo", of the taped-out chip: the file that comes with the program.
  /// Throws UsageError, with the line.
  explicit ReferenceFrames(const std::string& name);

  const std::string& name() const { return name_; }
  /// Whose frames they are: "the taped-out chip's", "those of F.csv".
  std::string whose() const;
  /// What is compared: "picture and pins", "picture" or "pins".
  const char* what() const;
  /// nullptr if the reference does not have the frame.
  const Frame* find(int frame) const;
  /// For a message: "12 frames from 0 to 40".
  std::string extent() const;

 private:
  const std::string name_;
  bool has_image_ = false, has_pins_ = false;
  std::map<int, Frame> frames_;
};

}  // namespace racebeam
