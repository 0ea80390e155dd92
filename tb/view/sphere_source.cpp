// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/sphere_source.h"

#include <fmt/format.h>

#include <utility>

#include "sc/sphere/engine.h"

namespace racebeam {

namespace {

constexpr int Key2 = 1 << 2, Key3 = 1 << 3;

}  // namespace

SphereSource::SphereSource(const SphereProgram& program, const sphere_knobs& k, int pictures)
    : StoreSource(k.resolved().store(), k.clocks_per_pixel, k.colour_bits, pictures),
      program_(program),
      knobs_(k.resolved()) {
  restart();
  begin(core_->picture());
}

void SphereSource::restart() {
  sphere_board start = program_.board;
  start.sw ^= pins_.switches;
  if (pins_.keys & Key2) start.key_n &= ~Key2;
  core_.emplace(knobs_, program_, start);
  motion_.emplace(program_.moving, program_.box, knobs_.capture_guard);
}

std::uint64_t SphereSource::picture_clocks() const {
  const sphere_counters& n = core_->counters();
  return n.clocks + n.host_clocks;
}

// KEY3 apart, which is a reset.
sphere_board SphereSource::board_now() const {
  sphere_board board = program_.board_in(next());
  board.sw ^= pins_.switches;
  board.key_n &= ~(pins_.keys & ~Key3);
  return board;
}

// Board and CPU before a picture.
void SphereSource::before_picture() {
  if (program_.resets(next()) || (pins_.keys & Key3)) {
    core_->reset(board_now());
    touched_ |= (pins_.keys & Key3) != 0;
  }
  if (next() > 0) motion_->picture(core_->inputs().rotz_q);
}

// KEY2 is held until it is pressed again.
std::vector<std::uint64_t> SphereSource::draw() {
  before_picture();
  core_->load(motion_->table());
  core_->draw(board_now());
  pins_.keys &= Key2;
  return core_->picture();
}

void SphereSource::skip() {
  before_picture();
  core_->finish(board_now());
  pins_.keys &= Key2;
}

void SphereSource::press(BoardPins pins) {
  pins_ = pins;
  touched_ = true;
}

FrameSource::Rows SphereSource::rows() const {
  const sphere_board board = board_now();
  Rows rows = {{"SW17..SW0", fmt::format("{:018b}", board.sw)},
               {"KEY3..KEY0", fmt::format("{:04b}", 15 & ~(board.key_n & ~(pins_.keys & Key3)))},
               {"", ""}};
  for (auto& counter : StoreSource::rows()) rows.push_back(std::move(counter));
  return rows;
}

const std::vector<counter_info>& SphereSource::counter_infos() const {
  return sphere_engine().counters;
}

namespace {

std::unique_ptr<FrameSource> make(const Run& run) {
  const scene_tables* const tables = run.show.tables();
  return std::make_unique<SphereSource>(
      tables ? *static_cast<const SphereProgram*>(tables) : builtin_sphere_program(), run.k,
      run.show.frames());
}

}  // namespace

SourceKind sphere_sources() { return {sphere_engine(), {LevelTlm}, KeyHelp::Board, make}; }

}  // namespace racebeam
