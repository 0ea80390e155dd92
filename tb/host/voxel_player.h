// VoxelPlayer: the voxel tracer of the tlm level and its host, picture by picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/voxel/voxel_machine.h"
#include "tb/host/voxel_show.h"

namespace racebeam {

class VoxelPlayer {
 public:
  /// Stands before picture 0. The program outlives it.
  VoxelPlayer(const VoxelProgram& program, const voxel_knobs& k);

  /// To stand before a picture: what was built before it lies in the memories.
  void seek(int picture);
  /// The next frame begins, and with it the next picture: the host's deeds, and the rays.
  void draw();

  /// That is drawn next.
  int next() const { return show_.picture() + 1; }
  const VoxelShow& show() const { return show_; }
  voxel_machine& machine() { return machine_; }
  const voxel_machine& machine() const { return machine_; }

 private:
  void perform(const VoxelDeed& deed);

  voxel_machine machine_;
  VoxelShow show_;
};

}  // namespace racebeam
