// VoxelShow: what the voxel tracer's host does for each picture: it sends what has changed, has it
// built, and starts.
//
// It sends the colours; before picture 0 all columns, then those of new craters only. What is to be
// built is cut into chunks, one for each frame of the raster.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_world.h"
#include "tb/host/voxel_program.h"

namespace racebeam {

struct VoxelDeed {
  enum Kind {
    Colours,  ///< all of the palette, a clock each
    Columns,  ///< of the rectangle, row by row, a clock each
    Build,    ///< the rectangle
    Frame     ///< waits for the next frame of the raster, if none begins now
  };
  Kind kind;
  voxel_rectangle rectangle{};
};

class VoxelShow {
 public:
  /// The program outlives it.
  VoxelShow(const VoxelProgram& program, const voxel_knobs& k);

  /// All is as before a picture.
  void go_to(int picture);
  /// What is done for the next picture, in this order; then it is drawn. Its changes are made.
  std::vector<VoxelDeed> next();

  const VoxelProgram& program() const { return *program_; }
  int picture() const { return picture_; }
  const voxel_view& view() const { return program_->view(picture_); }
  const voxel_palette& palette() const { return program_->palette; }
  /// As column_memory has them: with the changes of the pictures so far.
  const std::vector<std::uint32_t>& columns() const { return columns_; }
  std::uint32_t address(int x, int y) const {
    return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(knobs_.size_x) +
           static_cast<std::uint32_t>(x);
  }

 private:
  std::vector<voxel_rectangle> change(int picture);

  const VoxelProgram* program_;
  const voxel_knobs knobs_;
  std::vector<std::uint32_t> columns_;
  int picture_ = -1;  ///< that next() was called for
};

}  // namespace racebeam
