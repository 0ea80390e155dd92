// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/block_source.h"

#include "sc/block/engine.h"

namespace racebeam {

namespace {

constexpr int Bits = 8;  // of a channel in the store

std::unique_ptr<FrameSource> make(const Run& run) {
  return std::make_unique<BlockSource>(block_program_of(run.show.tables()), run.k,
                                       run.show.frames());
}

}  // namespace

BlockSource::BlockSource(const BlockProgram& program, const block_knobs& k, int pictures)
    : StoreSource(k.store(), block_knobs::clocks_per_pixel, Bits, pictures),
      program_(program),
      knobs_(k),
      bar_(k) {
  restart();
  begin(machine_->picture());
}

void BlockSource::restart() {
  machine_.emplace(knobs_);
  motion_.emplace(program_, knobs_);
  bar_.forget();
}

std::vector<std::uint64_t> BlockSource::draw() {
  skip();
  machine_->draw(motion_->tables());
  bar_.add(machine_->counters());
  return machine_->picture();
}

void BlockSource::skip() {
  if (next() > 0) motion_->picture();
}

std::uint64_t BlockSource::picture_clocks() const {
  const block_counters& n = machine_->counters();
  return n.clocks + n.host_clocks;
}

const std::vector<counter_info>& BlockSource::counter_infos() const {
  return block_engine().counters;
}

void BlockSource::finish(PackedPicture& picture) {
  if (knobs_.load_bar) bar_.draw(picture);
}

SourceKind block_sources() { return {block_engine(), {LevelTlm}, KeyHelp::Plain, make}; }

}  // namespace racebeam
