// BlockPlace: where blocks are done, if not by workers of this process.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>

#include "tb/sweep/block_runner.h"

namespace racebeam {

class BlockPlace {
 public:
  virtual ~BlockPlace() = default;
  /// Does all of them, each the frames of a point and a scene that are not there. False: it was
  /// interrupted, or goes on without this process.
  virtual bool run(std::list<Block> blocks, BlockRunner::Owner& owner) = 0;
};

}  // namespace racebeam
