// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/sphere_hands.h"

#include "tb/bench/sphere_bench.h"

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
    : PictureHands(chip, k.clocks_per_pixel),
      chip_(chip),
      program_(program),
      knobs_(k.resolved()),
      motion_(program.moving, program.box, k.capture_guard) {
  chip_.remember([this](int picture) { return program_.inputs_before(picture); });
}

void SphereHands::go_to(int picture) {
  motion_ = {program_.moving, program_.box, knobs_.capture_guard};
  for (int n = 1; n < picture; ++n) motion_.picture(program_.inputs_before(n).rotz_q);
}

void SphereHands::stop() {
  give_up();
  put(chip_.board().key_n, chip_.board().key_n.read().to_int() & ~Key3);
  chip_.board().valid.write(false);
}

void SphereHands::begin(int picture) {
  if (picture > 0) motion_.picture(program_.inputs_before(picture).rotz_q);
  words_.emplace(motion_.table(), knobs_.host_clocks_per_word);
  started_ = false;
  put(chip_.board(), program_.board_in(picture));
  put_words();
}

void SphereHands::put_words() {
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
}

bool SphereHands::send() {
  const bool done = chip_.board().done.read();
  put_words();
  started_ |= !done;
  return started_ && done && words_->sent();
}

void SphereHands::prepare(int picture) {
  if (!program_.resets(picture)) return;
  const sphere_board board = program_.board_in(picture);
  put(chip_.board(), {board.sw, board.key_n & ~Key3});
}

std::unique_ptr<Surroundings> make_sphere_hands(wired_chip& chip,
                                                const WiredBench::Setting& setting) {
  return std::make_unique<SphereHands>(static_cast<sphere_chip&>(chip),
                                       sphere_program_of(setting.scene), setting.k);
}

}  // namespace racebeam
