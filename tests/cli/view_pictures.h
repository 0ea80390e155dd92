// Pictures that tests of the viewer expect, and those that it writes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/bench/interval_event.h"
#include "tb/view/map_picture.h"

namespace racebeam {

using Bytes = std::vector<std::uint8_t>;

/// Three bytes a pixel; empty if there is no such file.
Bytes read_rgb(const std::string& path);

/// The intervals of a frame of the demo.
std::vector<IntervalEvent> intervals_of(int frame);

Bytes bytes_of(const RgbImage& picture);

/// A frame of the demo as the cores render it.
Bytes frame_of(int frame);

/// A map of a frame of the demo, with its bar.
Bytes map_of(MapKind kind, int frame);

}  // namespace racebeam
