// Against: rendered frames beside those of a reference, checksum by checksum.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/judge/reference_frames.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

class Against {
 public:
  /// Without a reference nothing is compared.
  explicit Against(std::shared_ptr<const ReferenceFrames> reference)
      : reference_(std::move(reference)) {}

  /// Compares a frame; its checksums were asked for.
  void add(int frame, const VgaFrame& picture);

  /// Prints how many are equal and which the reference does not have, unless `quiet`, and tells the
  /// first difference. True if there is one. Throws OutputError.
  bool report(bool quiet) const;
  /// The same as a JSON object; empty without a reference.
  std::string json() const;

 private:
  std::string text() const;
  std::string difference() const;

  struct Difference {
    int frame;
    ReferenceFrames::Frame expected;
    std::uint32_t image, pins;  // that came
    bool image_differs() const { return expected.image && *expected.image != image; }
    bool pins_differ() const { return expected.pins && *expected.pins != pins; }
  };

  const std::shared_ptr<const ReferenceFrames> reference_;
  int compared_ = 0, equal_ = 0;
  std::vector<int> missing_;
  std::optional<Difference> first_;
};

}  // namespace racebeam
