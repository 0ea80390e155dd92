// Widths and sizes that are fixed in the silicon (contract section 3). What an architect may change
// is in sc/beam/knobs.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

// Raster: 800 x 525 pixels (contract section 3).
constexpr int LinePixels = 800;  // pixel positions in a line, blanking included
constexpr int FrameLines = 525;  // lines in a frame, blanking included
constexpr int VisibleColumns = 640;
constexpr int VisibleRows = 480;
constexpr int FirstLine = -273;  // y of the first line of a frame
constexpr int FirstVisibleLine = -240;
constexpr int LastLine = 251;        // y of the last line: the navigator's
constexpr int FirstPosition = -480;  // h_pos of the first pixel of a line
constexpr double PixelClockHz = 25.2e6;
/// Whole picoseconds of a clock; 19841 at 50.4 MHz.
constexpr int clock_period_ps(int clocks_per_pixel) {
  return static_cast<int>(1e12 / (PixelClockHz * clocks_per_pixel));
}

// Rays.
constexpr int DrBits = 10;          // knob dr_bits
constexpr int DrPortBits = 13;      // dr ports are wide enough for any dr_bits
constexpr int DdrPortBits = 14;     // ddr and delta: one bit more than dr
constexpr int DdrFractionBits = 9;  // ddr counts 1/512 of a dr LSB per pixel
constexpr int PixelBits = 10;
constexpr int LastPixel = 639;
constexpr int AngleBits = 11;  // 2048 to the turn

// Rooms. Ports are wide enough for any scene file; the chip's own widths are the defaults of knobs.
constexpr int CornerBits = 12;         // signed, per axis
constexpr int CornerPortBits = 16;     // corners, sizes, distances
constexpr int NavigatorBits = 9;       // signed, stored camera coordinates
constexpr int NavigatorPortBits = 16;  // camera coordinates
constexpr int VelocityPortBits = 11;   // signed, per frame
constexpr int RoomBits = 9;            // {k(1), j(4), i(4)}
constexpr int RoomPortBits = 13;
constexpr int SolidRoom = 8191;  // "no neighbour": all bits set; 511 in the chip's 9 bits
constexpr int PortalBits = 2;    // number of a portal among those of one face
constexpr int MaxPortals = 4;    // in one face; 1 on the chip

// Position in the decision tree.
constexpr int DepthBits = 4;
constexpr int LevelBits = 3;
constexpr int TagBits = DepthBits + LevelBits;           // {depth, level}
constexpr int TagPortBits = PortalBits + TagBits;        // {portal, depth, level}
constexpr int FaceBits = 2;                              // face OR dom
constexpr int FacePortBits = 2 * PortalBits + FaceBits;  // {back, portal, face OR dom}
constexpr int StackPointerPortBits = 6;                  // wide enough for any interval_stack_depth
constexpr int StackCountPortBits = 7;

// Colours.
constexpr int ColourBits = 6;                // r * 16 + g * 4 + b
constexpr int ColoursBits = 4 * ColourBits;  // four of them, the first lowest
constexpr int TablePalette = 3;              // the palette that a scene file brings

// Demo.
constexpr int FrameBits = 14;
constexpr int DemoFrames = 12799;  // then the frame counter restarts

}  // namespace racebeam
