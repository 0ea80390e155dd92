// Widths and sizes that are fixed: the names and values of sc/base/constants.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

package racebeam_pkg;
  /* verilator lint_off UNUSEDPARAM */  // a unit uses some of them

  // Raster
  localparam int LinePixels = 800;
  localparam int FirstPosition = -480;
  localparam int FirstLine = -273;
  localparam int LastLine = 251;

  // Rays
  localparam int DrBits = 10;
  localparam int DrPortBits = 13;
  localparam int DdrPortBits = 14;
  localparam int DdrFractionBits = 9;
  localparam int PixelBits = 10;
  localparam int LastPixel = 639;
  localparam int AngleBits = 11;

  // Rooms
  localparam int CornerBits = 12;
  localparam int CornerPortBits = 16;
  localparam int NavigatorBits = 9;
  localparam int NavigatorPortBits = 16;
  localparam int VelocityPortBits = 11;
  localparam int RoomBits = 9;
  localparam int RoomPortBits = 13;
  localparam int SolidRoom = 8191;
  localparam int PortalBits = 2;
  localparam int MaxPortals = 4;

  // Position in the decision tree
  localparam int DepthBits = 4;
  localparam int LevelBits = 3;
  localparam int TagBits = DepthBits + LevelBits;
  localparam int TagPortBits = PortalBits + TagBits;
  localparam int FaceBits = 2;
  localparam int FacePortBits = 2 * PortalBits + FaceBits;
  localparam int StackPointerPortBits = 6;
  localparam int StackCountPortBits = 7;

  // Colours
  localparam int ColourBits = 6;
  localparam int ColoursBits = 4 * ColourBits;
  localparam int TablePalette = 3;

  // Demo
  localparam int FrameBits = 14;
  localparam int DemoFrames = 12799;

  /* verilator lint_on UNUSEDPARAM */
endpackage

`default_nettype wire
