// RenderedFrame: a frame with all that is made of it alone, so that any process can make it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sc/base/frame_counts.h"
#include "tb/bench/chip_bench.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/picture/rgb_image.h"
#include "tb/render/render_options.h"

namespace racebeam {

/// A picture: its name in the folder, or its path without one, and the whole file.
struct PictureFile {
  std::string name, bytes;
};

struct RenderedFrame {
  int number = 0;
  VgaFrame picture;
  frame_counts stats;
  std::optional<GoldenCounts> golden;  ///< if it was compared
  std::vector<PictureFile> files;
  PictureTime time{};  ///< of an engine that does not race the beam

  std::string bytes() const;
  static RenderedFrame of_bytes(const std::string& bytes);
};

/// The chip's picture of a frame, as the plan has it.
PictureFile picture_file(const OutputPlan& plan, int frame, const VgaFrame& picture);
/// Another picture of it, for the folder.
PictureFile picture_file(const OutputPlan& plan, const std::string& kind, int frame,
                         const RgbImage& picture);

}  // namespace racebeam
