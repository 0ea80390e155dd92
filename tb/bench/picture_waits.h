// Who waits for whom in the chips that draw into a frame store: the store's part, up to the tracer,
// which each engine has of its own.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/store/picture_chip.h"
#include "tb/bench/waits.h"

namespace racebeam {

class PictureWaits : public WaitWatch {
 public:
  void clock() final;
  std::vector<Wait> chain() const final;

 protected:
  static constexpr std::uint64_t Told =
      1000;  ///< clocks: an answer of one unit to another takes less

  PictureWaits(const picture_chip& chip, const knob_values& k, std::uint64_t line_clocks);

  /// The tracer's wires.
  virtual void look() = 0;
  /// The store waits for it.
  virtual std::vector<Wait> tracer() const = 0;
  /// A word was on offer, and taken, all the time.
  bool repeats() const { return offered_ >= two_lines_; }

 private:
  const picture_chip& store_;
  const std::uint64_t two_lines_, depth_;  // of the raster, in clocks; of the write buffer
  Held refused_, line_, full_, reads_, offered_;
  std::uint64_t takes_ = 0;  // since a word was put
};

std::unique_ptr<WaitWatch> make_sphere_waits(const wired_chip& chip, const knob_values& k,
                                             const LastRises& heard);
std::unique_ptr<WaitWatch> make_block_waits(const wired_chip& chip, const knob_values& k,
                                            const LastRises& heard);
std::unique_ptr<WaitWatch> make_voxel_waits(const wired_chip& chip, const knob_values& k,
                                            const LastRises& heard);

}  // namespace racebeam
