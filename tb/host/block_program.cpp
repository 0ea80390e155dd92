// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/block_program.h"

#include <utility>

namespace racebeam {

namespace {

block_ball ball_of(const BlockBody& body) {
  block_ball ball{{}, static_cast<float>(body.radius), body.colour};
  for (std::size_t n = 0; n < 3; ++n) ball.centre[n] = static_cast<float>(body.centre[n]);
  return ball;
}

std::vector<block_ball> balls_of(const std::vector<BlockBody>& bodies) {
  std::vector<block_ball> balls;
  for (const BlockBody& body : bodies) balls.push_back(ball_of(body));
  return balls;
}

}  // namespace

void BlockProgram::set_bodies(std::vector<BlockBody> all) {
  bodies = std::move(all);
  balls = balls_of(bodies);
}

void BlockMotion::picture() {
  for (int n = 0; n < steps_; ++n) {
    move(bodies_, program_->box);
    collide(bodies_, [](const BlockBody& a, const BlockBody& b, double) {
      return a.counter == 0 && b.counter == 0;
    });
  }
}

block_tables BlockMotion::tables() const {
  block_tables tables = *program_;
  tables.balls = balls_of(bodies_);
  return tables;
}

block_tables tables_of(const BlockProgram& program, const block_knobs& k, int picture) {
  BlockMotion motion(program, k);
  for (int n = 0; n < picture; ++n) motion.picture();
  return motion.tables();
}

const BlockProgram& builtin_block_program() {
  static const BlockProgram program = [] {
    BlockProgram quad;
    quad.set_bodies({{{0, 0, 6}, {}, 2.5, {0.25f, 0.75f, 0.5f}},
                     {{-2, 1, 2}, {}, 0.75, {0.75f, 0.25f, 0.25f}},
                     {{2, -1, 3}, {}, 0.75, {0.25f, 0.25f, 0.75f}},
                     {{0.5, 2, 1}, {}, 0.75, {0.75f, 0.75f, 0.25f}}});
    return quad;
  }();
  return program;
}

const BlockProgram& block_program_of(const scene_tables* scene) {
  return scene ? *static_cast<const BlockProgram*>(scene) : builtin_block_program();
}

}  // namespace racebeam
