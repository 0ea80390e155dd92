// BlockProgram: what the block renderer and the host beside it have of a scene file; and how the
// host moves it while the last blocks of a picture are drawn.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/block/block_world.h"
#include "tb/host/ball_motion.h"

namespace racebeam {

/// A sphere, in the units of block_tables; per step of time.
struct BlockBody {
  Vector3 centre{}, velocity{};
  double radius = 1;
  std::array<float, 3> colour{};  ///< 0..1
  int counter = 0;                ///< steps until it collides again
};

/// Its own balls are those of picture 0.
struct BlockProgram : block_tables {
  std::vector<BlockBody> bodies;
  MotionBox box{{-6, -5, 0}, {6, 5, 11}};

  /// The balls follow from the bodies.
  void set_bodies(std::vector<BlockBody> all);
};

class BlockMotion {
 public:
  /// The program outlives it.
  BlockMotion(const BlockProgram& program, const block_knobs& k)
      : program_(&program), bodies_(program.bodies), steps_(k.time_skip) {}

  /// A picture on.
  void picture();
  /// As the host sends it.
  block_tables tables() const;

 private:
  const BlockProgram* program_;
  std::vector<BlockBody> bodies_;
  int steps_;
};

/// A picture's scene, without those before it.
block_tables tables_of(const BlockProgram& program, const block_knobs& k, int picture);

/// The scene that is built in: four spheres that stand still.
const BlockProgram& builtin_block_program();

/// `scene` is a BlockProgram, or nullptr: the built-in one.
const BlockProgram& block_program_of(const scene_tables* scene);

}  // namespace racebeam
