// Widths, states and operations of the sphere tracer: the names and values of sc/sphere/codes.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

package sphere_pkg;
  /* verilator lint_off UNUSEDPARAM */  // a unit uses some of them

  // Numbers: signed 12.12
  localparam int SphereBits = 24;
  localparam int SphereFraction = 12;
  localparam int SphereSumBits = 48;
  localparam int NumeratorBits = 36;
  localparam int UnitBits = 12;
  localparam int SphereColourBits = 5;
  localparam int ChannelBits = 10;

  // Tables
  localparam int SphereIndexBits = 4;
  localparam int SphereEntries = 16;
  localparam int PlaneIndexBits = 3;
  localparam int PlaneEntries = 8;
  localparam int LightRadius = 2;

  // Picture and store
  localparam int StoreAddressBits = 20;
  localparam int StoreDataBits = 64;
  localparam int SubRays = 9;
  localparam int HostPatience = 65535;
  localparam int NearestPlane = 1024;
  localparam int SphereStateBits = 5;

  /* verilator lint_on UNUSEDPARAM */

  typedef enum logic [4:0] {
    SphereRay = 5'd0,
    SphereHost = 5'd1,
    SphereRoot = 5'd4,
    SphereDivide = 5'd5,
    SphereCentre = 5'd7,
    SphereShadowCentre = 5'd8,
    SpherePlane = 5'd9,
    SphereAlong = 5'd10,
    SpherePlaneD = 5'd11,
    SpherePlaneT = 5'd12,
    SphereFront = 5'd13,
    SphereShadowAlong = 5'd14,
    SphereShadowFront = 5'd15,
    SphereChord = 5'd16,
    SphereShadowChord = 5'd17,
    SphereWait = 5'd18,
    SphereHit = 5'd19,
    SphereLight = 5'd20,
    SphereNormal = 5'd21,
    SphereReflect = 5'd22,
    SphereReflectTwo = 5'd23,
    SphereLambert = 5'd24,
    SphereShade = 5'd25,
    SphereLray = 5'd26,
    SphereLroot = 5'd27,
    SphereLdivide = 5'd28,
    SphereAdd = 5'd29,
    SphereNext = 5'd30
  } sphere_state;

  typedef enum logic [1:0] {
    VectorDot = 2'd0,
    VectorScale = 2'd1,
    VectorSquare = 2'd2
  } vector_op;

  typedef enum logic [2:0] {
    ShadeHold = 3'd0,
    ShadeStart = 3'd1,
    ShadeLight = 3'd2,
    ShadeHalf = 3'd3,
    ShadeLit = 3'd4,
    ShadePlain = 3'd5,
    ShadeAdd = 3'd6,
    ShadeStore = 3'd7
  } shader_op;
endpackage

`default_nettype wire
