// FrameJudge: how far the frames of a point are from what is meant, by engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tb/bench/chip_bench.h"
#include "tb/show/show.h"
#include "tb/sweep/block.h"

namespace racebeam {

/// What tells the pictures that a frame is compared with from others of its scene and number; "" or
/// none: there is no such picture.
struct ReferenceKeys {
  std::string reference{}, end{};
  std::vector<std::string> links{};
};

class FrameJudge {
 public:
  virtual ~FrameJudge() = default;

  virtual ReferenceKeys keys() const = 0;
  /// The numbers of SweepKind::errors. What it had to make for that, and the causes, if they are
  /// asked for, it puts into the answer.
  virtual std::vector<std::int64_t> errors(const ChipBench::Frame& frame, const KeptPictures& kept,
                                           Answer& answer) = 0;
};

/// Of a block's point; `show` is its scene, and outlives the judge.
std::unique_ptr<FrameJudge> make_beam_frame_judge(const Show& show, const Block& block);
std::unique_ptr<FrameJudge> make_sphere_frame_judge(const Show& show, const Block& block);
std::unique_ptr<FrameJudge> make_block_frame_judge(const Show& show, const Block& block);
std::unique_ptr<FrameJudge> make_voxel_frame_judge(const Show& show, const Block& block);

}  // namespace racebeam
