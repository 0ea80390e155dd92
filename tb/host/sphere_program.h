// SphereProgram: what the sphere tracer, the hands at its board and the CPU beside it have of a
// scene file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/sphere/sphere_inputs_core.h"
#include "tb/host/sphere_motion.h"

namespace racebeam {

/// Switches and keys that somebody holds for some pictures.
struct SphereInput {
  int picture = 0, pictures = 1;
  int sw = 0;    ///< the switches, by bit
  int keys = 0;  ///< the keys, by bit
};

struct SphereProgram : sphere_tables {
  std::vector<MovingSphere> moving;
  MotionBox box;
  int modes = 1 << 5;  ///< switches that are always up: size, reflections, antialiasing
  std::vector<SphereInput> inputs;

  /// The board while a picture is drawn.
  sphere_board board_in(int picture) const;
  /// From now on the chip starts with the modes, and KEY2 held if there are to be planes.
  void set_start(bool planes_on);
  /// What sphere_inputs goes through until a picture begins, a board a clock; in a reset KEY3 is
  /// pressed.
  std::vector<sphere_board> boards_before(int picture) const;
  /// Eye, light, screen, modes and turns as a picture begins.
  sphere_inputs_core inputs_before(int picture) const;
  /// Whether KEY3, the reset, is pressed before a picture: when somebody begins to hold it. The
  /// first one follows the power-up.
  bool resets(int picture) const;
};

/// The scene that is built in.
const SphereProgram& builtin_sphere_program();

}  // namespace racebeam
