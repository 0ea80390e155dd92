// The panel beside the viewer's picture: statistics, and gauges of FIFO, stack and depth.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/picture/rgb_image.h"
#include "tb/view/frame_source.h"
#include "tb/view/view_control.h"

namespace racebeam {

/// Paints it to the right of the frame.
void paint_panel(RgbImage& picture, const FrameSource& source, const ViewState& state,
                 const std::string& statistics);

}  // namespace racebeam
