// What an architect may change of the block renderer, and the table that names it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/base/knob_values.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

enum block_cull_rule { BlockCullCorners = 0, BlockCullCone = 1, BlockCullOff = 2 };
enum block_root_rule { BlockRootTrick = 0, BlockRootHeron = 1, BlockRootExact = 2 };
enum block_size { BlockSize640 = 0, BlockSize512 = 1, BlockSize1920 = 2 };

struct block_knobs {
  int cores = 4;
  int lanes = 4;
  int newton_steps = 2;
  int specular_squarings = 4;
  int max_passes = 3;
  int root = BlockRootTrick;
  int shadow_rays = 0;
  int cull = BlockCullCorners;
  int background = 0;
  int fraction_bits = 20;
  int size = BlockSize640;
  int write_buffer_depth = 64;
  int write_policy = WritePolicyFree;
  int when_full = WhenFullStall;
  int time_skip = 1;
  int load_bar = 0;

  static constexpr int clocks_per_pixel = 2;  ///< of the raster

  block_knobs() = default;
  /// Throws std::logic_error if they are another engine's.
  block_knobs(const knob_values& values);  // NOLINT(google-explicit-constructor)
  operator knob_values() const;            // NOLINT(google-explicit-constructor)

  /// Columns and rows of the picture.
  int columns() const { return size == BlockSize1920 ? 1920 : size == BlockSize512 ? 512 : 640; }
  int rows() const { return size == BlockSize1920 ? 1080 : 480; }
  /// The clocks of a unit vector.
  int normalise_clocks() const { return 3 + 3 * newton_steps; }
  int shade_clocks() const { return 9 + specular_squarings + 2 * normalise_clocks(); }
  /// Of a root, in BlockNear.
  int root_clocks() const { return root == BlockRootTrick ? 1 : root == BlockRootHeron ? 9 : 12; }
  /// Those of the frame store.
  store_knobs store() const {
    store_knobs s;
    s.write_buffer_depth = write_buffer_depth;
    s.write_policy = write_policy;
    s.when_full = when_full;
    s.store_format = StorePlanar;
    s.picture_width = columns();
    s.picture_height = rows();
    return s;
  }
};

/// All knobs: a member without a row does not compile.
const std::vector<knob_of<block_knobs>>& block_knob_table();
/// The same without their places.
const std::vector<knob_row>& block_knob_rows();

}  // namespace racebeam
