// RenderedFrame: a frame with all that is made of it alone, so that any process can make it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sc/beam/frame_stats.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// A picture for the folder: its name there, and the whole file.
struct PictureFile {
  std::string name, bytes;
};

struct RenderedFrame {
  int number = 0;
  VgaFrame picture;
  FrameStats stats;
  std::optional<GoldenCounts> golden;  ///< if it was compared
  std::vector<PictureFile> files;

  std::string bytes() const;
  static RenderedFrame of_bytes(const std::string& bytes);
};

/// A picture of a frame; "frame" is the kind of the chip's own.
PictureFile picture_file(const char* kind, int frame, const std::vector<std::uint8_t>& colours,
                         int width = VisibleColumns, int height = VisibleRows);

}  // namespace racebeam
