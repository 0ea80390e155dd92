// Widths and sizes that are fixed in the silicon (contract section 3). What an architect may change
// is in knobs.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

// Raster: 800 x 525 pixels (seed 000 "640x480 60 fps", contract section 3).
constexpr int LinePixels = 800;  // pixel positions in a line, blanking included
constexpr int FrameLines = 525;  // lines in a frame, blanking included
constexpr int VisibleColumns = 640;
constexpr int VisibleRows = 480;
constexpr int FirstLine = -273;  // y of the first line of a frame
constexpr int FirstVisibleLine = -240;
constexpr int LastLine = 251;        // y of the last line: the navigator's
constexpr int FirstPosition = -480;  // h_pos of the first pixel of a line
constexpr double PixelClockHz = 25.2e6;

// Rays.
constexpr int DrBits = 10;          // knob dr_bits
constexpr int DrPortBits = 13;      // dr ports are wide enough for any dr_bits
constexpr int DdrPortBits = 14;     // ddr and delta: one bit more than dr
constexpr int DdrFractionBits = 9;  // ddr counts 1/512 of a dr LSB per pixel
constexpr int PixelBits = 10;
constexpr int LastPixel = 639;

// Rooms.
constexpr int CornerBits = 12;    // signed, per axis
constexpr int NavigatorBits = 9;  // signed, stored camera coordinates
constexpr int RoomBits = 9;       // {k(1), j(4), i(4)}
constexpr int SolidRoom = 511;    // "no neighbour"

// Position in the decision tree.
constexpr int DepthBits = 4;
constexpr int LevelBits = 3;
constexpr int TagBits = DepthBits + LevelBits;
constexpr int StackPointerPortBits = 6;  // wide enough for any interval_stack_depth
constexpr int StackCountPortBits = 7;

// Demo.
constexpr int FrameBits = 14;
constexpr int DemoFrames = 12799;  // then the frame counter restarts

}  // namespace racebeam
