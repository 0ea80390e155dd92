// The viewer's picture: the frame at the beam with what was asked for on, below and beside it.
//
// Nothing covers the chip's own pixels unless it is asked for: without overlays the picture is the
// frame, 640 x 480; a message comes over it for two seconds. A map brings its bar below, gauges and
// statistics a panel to the right.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/picture/rgb_image.h"
#include "tb/view/frame_source.h"
#include "tb/view/view_control.h"

namespace racebeam {

constexpr int PanelWidth = 216;  ///< pixels

/// What the picture says beyond the frame.
struct ViewWords {
  std::string where;       ///< for the bar of a map: "demo frame 60"
  std::string statistics;  ///< lines of up to 34 letters
  std::string error;       ///< in a red field, until it is mended; empty: none
};

RgbImage view_picture(const FrameSource& source, const ViewState& state, const ViewWords& words);

/// Writes lines over the chip's picture, far from the beam.
void paint_message(RgbImage& picture, const std::string& message, const FrameWatch& watch);

}  // namespace racebeam
