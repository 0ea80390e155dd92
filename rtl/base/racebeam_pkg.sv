// Widths and sizes that are fixed, the names and values of sc/base/constants.h; and the codes of
// sc/beam/codes.h.
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

  // Codes
  typedef enum logic [1:0] {
    StateLeft = 2'd0,
    StateRight = 2'd1,
    StateBisect = 2'd2,
    StateReturn = 2'd3
  } subdivider_state;

  typedef enum logic [1:0] {
    LookThrough = 2'd0,
    LookNext = 2'd1,
    LookPrevious = 2'd2
  } look_way;

  typedef enum logic [2:0] {
    CornerHold = 3'd0,
    CornerAddVelocity = 3'd1,
    CornerAddS = 3'd2,
    CornerSubtract2S = 3'd3,
    CornerLeavePlus = 3'd4,
    CornerLeaveMinus = 3'd5,
    CornerAddR = 3'd6,
    CornerCamera = 3'd7
  } corner_op;
endpackage

`default_nettype wire
