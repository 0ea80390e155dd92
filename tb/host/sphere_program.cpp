// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/sphere_program.h"

#include <algorithm>

namespace racebeam {

namespace {

constexpr int Key2 = 1 << 2, Key3 = 1 << 3;

}  // namespace

sphere_board SphereProgram::board_in(int picture) const {
  sphere_board now{modes, 15};
  for (const SphereInput& input : inputs) {
    if (picture < input.picture || picture - input.picture >= input.pictures) continue;
    now.sw |= input.sw;
    now.key_n &= ~(input.keys & ~Key3);
  }
  return now;
}

void SphereProgram::set_start(bool planes_on) {
  board = {modes, 15};
  if (planes_on) board.key_n &= ~Key2;
}

std::vector<sphere_board> SphereProgram::boards_before(int picture) const {
  std::vector<sphere_board> boards;
  for (int n = 0; n <= picture; ++n) {
    const sphere_board now = board_in(n);
    if (resets(n)) boards.push_back({now.sw, now.key_n & ~Key3});
    if (n < picture) boards.push_back(now);
  }
  return boards;
}

bool SphereProgram::resets(int picture) const {
  return picture > 0 && std::any_of(inputs.begin(), inputs.end(), [&](const SphereInput& input) {
           return input.keys & Key3 && input.picture == picture;
         });
}

sphere_inputs_core SphereProgram::inputs_before(int picture) const {
  sphere_inputs_core now;
  now.clock({false, board.sw, board.key_n, false}, start);
  for (const sphere_board& at : boards_before(picture))
    now.clock({true, at.sw, at.key_n, true}, start);
  return now;
}

const SphereProgram& builtin_sphere_program() {
  static const SphereProgram program = [] {
    SphereProgram built_in;
    for (const sphere_row& row : builtin_spheres(false)) {
      MovingSphere sphere;
      for (std::size_t n = 0; n < row.centre.size(); ++n) sphere.centre[n] = row.centre[n] / 4096.0;
      sphere.radius = row.radius;
      sphere.colour = row.colour;
      sphere.reflect = row.reflect;
      built_in.moving.push_back(sphere);
    }
    built_in.spheres = static_cast<int>(built_in.moving.size());
    built_in.set_start(false);
    return built_in;
  }();
  return program;
}

}  // namespace racebeam
