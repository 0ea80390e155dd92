// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_chip.h"

#include "sc/base/probe.h"
#include "sc/block/block_parameters.h"

namespace racebeam {

namespace {

bool has(const wire<BlockCores>& word, std::size_t core) {
  return word.read().to_uint64() >> core & 1;
}

}  // namespace

block_core_place::block_core_place(const sc_core::sc_module_name& name, const block_knobs& k,
                                   const unit_maker& units)
    : sc_module(name), u_block_core(units.make<block_core>(k)) {}

block_chip::block_chip(const sc_core::sc_module_name& name, const block_knobs& k,
                       const unit_choices& choices)
    : block_chip(name, k, unit_maker(choices, block_parameters(k))) {}

block_chip::block_chip(const sc_core::sc_module_name& name, const block_knobs& k,
                       const unit_maker& units)
    : picture_chip(name, k.store(), block_knobs::clocks_per_pixel, units),
      width("width", static_cast<unsigned>(k.columns())),
      height("height", static_cast<unsigned>(k.rows())),
      u_block_convert(units.make<block_convert>(k)),
      u_block_scheduler(units.make<block_scheduler>(k)),
      u_block_bus(units.make<block_bus>(k)),
      collector_(k) {
  bind_host();
  for (int n = 0; n < k.cores; ++n) {
    g_core.push_back(std::make_unique<block_core_place>(element("g_core", n).c_str(), k, units));
    bind_core(*g_core.back());
  }
  bind_bus();
  SC_HAS_PROCESS(block_chip);
  SC_METHOD(part_jobs);
  sensitive << job_valid;
  SC_METHOD(part_ready);
  sensitive << word_ready;
  SC_METHOD(join);
  for (const auto& place : g_core)
    sensitive << place->job_ready << place->busy << place->word_valid;
  SC_METHOD(choose_word);
  for (const auto& place : g_core)
    chosen_events_.push_back(core.default_event() | place->word_address.default_event() |
                             place->word.default_event());
}

block_chip::~block_chip() = default;

void block_chip::connect(const wired_chip::pins& bench) {
  picture_chip::connect(bench);
  host_ = std::make_unique<host_wires>();
  valid_i(host_->valid);
  float_i(host_->number);
  field_i(host_->field);
  index_i(host_->index);
  ready_o(host_->ready);
  spheres_i(host_->spheres);
  ax_i(host_->ax);
  ay_i(host_->ay);
  cone_sine_i(host_->cone_sine);
  cone_cosine2_i(host_->cone_cosine2);
  start_i(host_->start);
  done_o(host_->done);
}

void block_chip::begin_picture() {
  picture_chip::begin_picture();
  collector_.begin();
}

void block_chip::part_jobs() {
  for (std::size_t n = 0; n < g_core.size(); ++n) g_core[n]->job_valid.write(has(job_valid, n));
}

void block_chip::part_ready() {
  for (std::size_t n = 0; n < g_core.size(); ++n) g_core[n]->word_ready.write(has(word_ready, n));
}

void block_chip::join() {
  std::uint64_t ready = 0, busy_now = 0, valid = 0;
  for (std::size_t n = 0; n < g_core.size(); ++n) {
    const block_core_place& place = *g_core[n];
    ready |= std::uint64_t{place.job_ready.read()} << n;
    busy_now |= std::uint64_t{place.busy.read()} << n;
    valid |= std::uint64_t{place.word_valid.read()} << n;
  }
  job_ready.write(ready);
  busy.write(busy_now);
  word_valid.write(valid);
}

void block_chip::choose_word() {
  const std::size_t chosen = core.read().to_uint();
  const block_core_place& place = *g_core[chosen < g_core.size() ? chosen : 0];
  put_address.write(place.word_address.read());
  put_data.write(place.word.read());
  next_trigger(chosen_events_[chosen < g_core.size() ? chosen : 0]);
}

block_view block_chip::view() const {
  block_view v;
  v.sends = valid_i.read() || !ready_o.read();
  v.done = done_o.read();
  v.store = stored(bus_valid.read());
  for (std::size_t n = 0; n < g_core.size(); ++n) {
    const block_core_place& place = *g_core[n];
    v.cores[n] = {static_cast<std::uint8_t>(place.state.read().to_uint()),
                  static_cast<std::uint8_t>(place.event_told.read().to_uint()),
                  place.word_valid.read() && !place.word_ready.read()};
  }
  return v;
}

std::unique_ptr<wired_chip> make_block_chip(const char* name, const knob_values& k,
                                            const scene_tables*, const unit_choices& choices) {
  return std::make_unique<block_chip>(name, k, choices);
}

}  // namespace racebeam
