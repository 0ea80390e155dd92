// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/sphere_hands.h"

#include "tb/bench/sphere_bench.h"
#include "tb/monitor/raster.h"

namespace racebeam {

namespace {

constexpr int Key3 = 1 << 3;

template <class Wire>
void put(Wire& wire, int value) {
  wire.write(static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << wire.read().length()) - 1));
}

void put(sphere_chip::board_wires& at, const sphere_board& board) {
  put(at.sw, board.sw);
  put(at.key_n, board.key_n);
}

}  // namespace

SphereHands::SphereHands(sphere_chip& chip, const SphereProgram& program, const sphere_knobs& k)
    : chip_(chip),
      program_(program),
      knobs_(k.resolved()),
      frame_clocks_(Raster(k.clocks_per_pixel).frame_clocks()),
      motion_(program.moving, program.box, k.capture_guard) {
  chip_.remember([this](int picture) { return program_.inputs_before(picture); });
}

void SphereHands::seek(int picture) {
  motion_ = {program_.moving, program_.box, knobs_.capture_guard};
  for (int n = 1; n < picture; ++n) motion_.picture(program_.inputs_before(n).rotz_q);
  next_ = picture;
  frame_clock_ = 0;
  held_ = false;
  begin();
}

void SphereHands::hold_reset() {
  held_ = true;
  busy_ = begun_ = false;
  put(chip_.board().key_n, chip_.board().key_n.read().to_int() & ~Key3);
  chip_.board().valid.write(false);
}

// The wires of the first clock of a frame, which is about to begin or has just begun.
void SphereHands::begin() {
  if (next_ > 0) motion_.picture(program_.inputs_before(next_).rotz_q);
  words_.emplace(motion_.table(), knobs_.host_clocks_per_word);
  chip_.begin_picture();
  begun_ = true;
  busy_ = started_ = false;
  put(chip_.board(), program_.board_in(next_));
  send();
}

void SphereHands::send() {
  const sphere_host_pins& pins = words_->clock();
  auto& at = chip_.board();
  put(at.sphere, pins.sphere);
  put(at.color, pins.color);
  put(at.x1, pins.x1);
  put(at.y1, pins.y1);
  put(at.z1, pins.z1);
  put(at.cpu_reflect, pins.reflect);
  put(at.cpu_radius, pins.radius);
  put(at.r2, pins.r2);
  put(at.r_inv, pins.r_inv);
  at.valid.write(pins.valid);
  busy_ |= pins.valid;
}

void SphereHands::finish() {
  memory_ = chip_.memory();
  counters_ = chip_.collector().last();
  begun_ = busy_ = false;
  resting_ = rest_;
  ++next_;
  ++pictures_;
}

void SphereHands::clock() {
  const bool done = chip_.board().done.read();
  const bool last = ++frame_clock_ == frame_clocks_;  // clock of the frame, ending now
  if (last) frame_clock_ = 0;
  if (held_) return;
  if (!begun_) {
    if (last && resting_-- == 0) begin();
    else if (resting_ == 0 && frame_clock_ == frame_clocks_ - 1 && program_.resets(next_)) {
      const sphere_board board = program_.board_in(next_);
      put(chip_.board(), {board.sw, board.key_n & ~Key3});
    }
    return;
  }
  send();
  started_ |= !done;
  if (started_ && done && words_->sent() && !chip_.take_valid.read()) finish();
}

std::unique_ptr<Surroundings> make_sphere_hands(wired_chip& chip,
                                                const WiredBench::Setting& setting) {
  return std::make_unique<SphereHands>(static_cast<sphere_chip&>(chip),
                                       sphere_program_of(setting.scene), setting.k);
}

}  // namespace racebeam
