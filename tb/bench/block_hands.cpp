// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/block_hands.h"

#include "sc/block/block_machine.h"

namespace racebeam {

BlockHands::BlockHands(block_chip& chip, const BlockProgram& program, const block_knobs& k)
    : PictureHands(chip, block_knobs::clocks_per_pixel),
      chip_(chip),
      program_(program),
      knobs_(k),
      motion_(program, k) {}

void BlockHands::go_to(int picture) {
  motion_ = BlockMotion(program_, knobs_);
  for (int n = 1; n < picture; ++n) motion_.picture();
}

void BlockHands::begin(int picture) {
  if (picture > 0) motion_.picture();
  const block_tables tables = motion_.tables();
  const block_world world = converted(tables, knobs_);
  numbers_ = block_numbers(tables);
  next_ = 0;
  clocks_ = 0;
  start_ = block_machine::host_clocks(tables.balls.size());
  asked_ = started_ = false;
  block_chip::host_wires& at = chip_.host();
  at.spheres.write(static_cast<unsigned>(tables.balls.size()));
  at.ax.write(static_cast<std::uint32_t>(world.ax));
  at.ay.write(static_cast<std::uint32_t>(world.ay));
  at.cone_sine.write(static_cast<std::uint32_t>(world.cone_sine));
  at.cone_cosine2.write(static_cast<std::uint32_t>(world.cone_cosine2));
  at.start.write(false);
  put_number();
}

void BlockHands::put_number() {
  block_chip::host_wires& at = chip_.host();
  at.valid.write(next_ < numbers_.size());
  if (next_ == numbers_.size()) return;
  const BlockNumber& number = numbers_[next_];
  at.number.write(number.bits);
  at.field.write(static_cast<unsigned>(number.field));
  at.index.write(static_cast<unsigned>(number.index));
}

// The numbers, the clocks of the last sphere, a clock of start.
bool BlockHands::send() {
  block_chip::host_wires& at = chip_.host();
  ++clocks_;
  if (next_ < numbers_.size() && at.ready.read()) {
    ++next_;
    put_number();
  }
  const bool starts = !asked_ && next_ == numbers_.size() && clocks_ >= start_;
  asked_ |= starts;
  at.start.write(starts);
  started_ |= !at.done.read();
  return started_ && at.done.read();
}

std::unique_ptr<Surroundings> make_block_hands(wired_chip& chip,
                                               const WiredBench::Setting& setting) {
  return std::make_unique<BlockHands>(static_cast<block_chip&>(chip),
                                      block_program_of(setting.scene), setting.k);
}

}  // namespace racebeam
