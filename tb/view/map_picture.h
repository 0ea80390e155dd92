// Maps of a frame in colours, with the bar that explains them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/picture/rgb_image.h"
#include "tb/view/frame_maps.h"

namespace racebeam {

constexpr int MapBarHeight = 44;  ///< pixels of a colour bar

/// The colour of a value. Slack: red where the beam won, then from yellow (just in time) to blue on
/// a logarithmic scale to 1024 clocks. Cost: from black to white, logarithmic, 1/32 to 16
/// decisions. Depth: from violet (the camera's room) to yellow (8 rooms and more). Grey: unknown.
Rgb map_colour(MapKind kind, float value);

/// Paints the map over the top left of the picture. Where it is unknown but `running`, the pixel
/// stays as it is: the beam has not come there yet.
void paint_map(RgbImage& picture, const FrameMap& map, bool running = false);

/// Paints a bar of 640 x MapBarHeight with ticks, unit and title; `where` goes to its right end.
void paint_bar(RgbImage& picture, int top, MapKind kind, const std::string& where);

/// A picture for a file: the map of 640 x 480 with the bar below.
RgbImage map_picture(const FrameMap& map, const std::string& where);

}  // namespace racebeam
