// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/goldens.h"

#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/judge/block_judge.h"
#include "tb/judge/sphere_judge.h"
#include "tb/judge/voxel_judge.h"

namespace racebeam {

const std::vector<GoldenKind>& goldens() {
  static const std::vector<GoldenKind> table = {
      {sphere_engine(), sphere_golden_picture, sphere_golden_errors},
      {block_engine(), block_golden_picture, block_golden_errors},
      {voxel_engine(), voxel_golden_picture, voxel_golden_errors}};
  return table;
}

const GoldenKind* golden_of(const engine& built) {
  for (const GoldenKind& kind : goldens())
    if (&kind.engine == &built) return &kind;
  return nullptr;
}

}  // namespace racebeam
