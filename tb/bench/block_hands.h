// BlockHands: what is around the wired block renderer: its host.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sc/block/block_chip.h"
#include "tb/bench/picture_hands.h"
#include "tb/bench/wired_bench.h"
#include "tb/host/block_numbers.h"
#include "tb/host/block_program.h"

namespace racebeam {

class BlockHands final : public PictureHands {
 public:
  /// As PictureHands; `program` outlives it, too.
  BlockHands(block_chip& chip, const BlockProgram& program, const block_knobs& k);

  /// The host has no reset: the picture goes on to its end.
  void stop() override { hold(); }

  /// What was counted of the picture that was done last.
  const block_counters& counters() const { return counters_; }

 private:
  void go_to(int) override;
  void begin(int picture) override;
  bool send() override;
  void end() override { counters_ = chip_.collector().last(); }
  void put_number();

  block_chip& chip_;
  const BlockProgram& program_;
  const block_knobs knobs_;

  BlockMotion motion_;
  std::vector<BlockNumber> numbers_;
  std::size_t next_ = 0;  // number that is offered
  int clocks_ = 0;        // of the picture
  int start_ = 0;         // the first one in which it may start
  bool asked_ = false;    // start was sent
  bool started_ = false;  // the scheduler deals
  block_counters counters_;
};

/// BenchKind::around.
std::unique_ptr<Surroundings> make_block_hands(wired_chip& chip,
                                               const WiredBench::Setting& setting);

}  // namespace racebeam
