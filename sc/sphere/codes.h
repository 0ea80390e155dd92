// Widths, states and operations of the sphere tracer, the same in rtl/sphere/sphere_pkg.sv;
// those of the frame store are in sc/store/store_knobs.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

// Numbers: signed 12.12.
constexpr int SphereBits = 24;       // positions, directions, distances
constexpr int SphereFraction = 12;   // fraction bits of them
constexpr int SphereSumBits = 48;    // a sum of products, 24.24
constexpr int NumeratorBits = 36;    // of the dividers: 12.12, and 12 bits below
constexpr int UnitBits = 12;         // fractions of one: reflectivity, weight, inverse radius
constexpr int SphereColourBits = 5;  // a channel in the tables
constexpr int ChannelBits = 10;      // a channel on its way to the word

// Tables.
constexpr int SphereIndexBits = 4;
constexpr int SphereEntries = 16;  // the last one used is the light
constexpr int PlaneIndexBits = 3;
constexpr int PlaneEntries = 8;
constexpr int LightRadius = 2;

// Picture and store.
constexpr int SubRays = 9;           // of a pixel, at most
constexpr int HostPatience = 65535;  // clocks without a word of a CPU until the built-in scene
constexpr int NearestPlane = 1024;   // 1/4: a plane is hit beyond it
constexpr int SphereStateBits = 5;

/// Where sphere_tracer is; codes without a name go to SphereRay.
enum sphere_state {
  SphereRay = 0,
  SphereHost = 1,
  SphereRoot = 4,
  SphereDivide = 5,
  SphereCentre = 7,
  SphereShadowCentre = 8,
  SpherePlane = 9,
  SphereAlong = 10,
  SpherePlaneD = 11,
  SpherePlaneT = 12,
  SphereFront = 13,
  SphereShadowAlong = 14,
  SphereShadowFront = 15,
  SphereChord = 16,
  SphereShadowChord = 17,
  SphereWait = 18,
  SphereHit = 19,
  SphereLight = 20,
  SphereNormal = 21,
  SphereReflect = 22,
  SphereReflectTwo = 23,
  SphereLambert = 24,
  SphereShade = 25,
  SphereLray = 26,
  SphereLroot = 27,
  SphereLdivide = 28,
  SphereAdd = 29,
  SphereNext = 30
};

/// What vector_unit multiplies.
enum vector_op {
  VectorDot = 0,    // a_k * b_k
  VectorScale = 1,  // a_k * s
  VectorSquare = 2  // s * s in all three lanes
};

/// What sphere_shader does at the end of a clock.
enum shader_op {
  ShadeHold = 0,   // nothing
  ShadeStart = 1,  // forgets colour and light of the pixel
  ShadeLight = 2,  // colour: full white
  ShadeHalf = 3,   // colour: half the base
  ShadeLit = 4,    // colour: base * (fraction + 1/2)
  ShadePlain = 5,  // colour: the base
  ShadeAdd = 6,    // colour so far += colour * weight; weight *= reflectivity
  ShadeStore = 7   // the sub-ray is done: into the alias buffer; a new one begins
};

}  // namespace racebeam
