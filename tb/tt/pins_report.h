// The statistics of a Tiny Tapeout chip's pins: JSON of schema "racebeam-pins" version 1, and a
// table.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/tt/tt_bench.h"

namespace racebeam {

class PinsReport {
 public:
  /// With CRCs if `crc`.
  PinsReport(const TtProject& project, TtInputs inputs, const FoundFrames& found, bool crc);

  /// Adds a whole frame.
  void add(int frame, const TtBench::Frame& seen);
  int frames() const { return static_cast<int>(frames_.size()); }

  /// The whole document; one line per frame. `against`: the comparison with a reference as JSON, if
  /// there was one. The periods hold for every frame but in the clocks of `faults`: the monitor
  /// checks each clock.
  std::string text(const VgaFaults& faults, const std::string& against = "") const;

  /// What was found about the syncs, and the titles of the rows.
  std::string table_header() const;
  std::string table_row(int frame, const TtBench::Frame& seen) const;
  /// The pins over all frames.
  std::string table_pins() const;

 private:
  const TtProject project_;
  const TtInputs inputs_;
  const FoundFrames found_;
  const bool crc_;
  std::vector<std::string> frames_;  // JSON texts
  PinStats total_;
};

}  // namespace racebeam
