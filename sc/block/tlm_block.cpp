// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/tlm_block.h"

#include <algorithm>
#include <cstring>

#include "sc/block/tlm_block_map.h"

namespace racebeam {

tlm_block::tlm_block(const sc_core::sc_module_name& name, const block_knobs& k)
    : tlm_picture_chip(name, k.store(), block_knobs::clocks_per_pixel, BlockDisplayColumns,
                       BlockDisplayRows),
      knobs_(k),
      machine_(k) {
  SC_HAS_PROCESS(tlm_block);
  SC_THREAD(run);
  host_socket.register_b_transport(this, &tlm_block::access_host);
  host_socket.register_transport_dbg(this, &tlm_block::peek_host);
  host_socket.register_get_direct_mem_ptr(this, &tlm_block::refuse_memory);
}

void tlm_block::run() {
  restart_clock();
  for (;;) {
    wait(started_);
    send_picture();
    counters_ = machine_.counters();
    end_picture();
  }
}

void tlm_block::advance(std::int64_t clock) {
  if (drawing_) seen_ = std::max(seen_, clock);
  else machine_.go_to(clock);
}

void tlm_block::access_host(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  access_words(
      payload, delay, [this](std::uint64_t address) { return read_host(address); },
      [this](std::uint64_t address, std::uint32_t value) { return write_host(address, value); });
}

const float* tlm_block::number(std::uint64_t address) const {
  const auto in = [&](std::uint64_t begin, const auto& values) -> const float* {
    const std::uint64_t at = (address - begin) / WordBytes;
    return address >= begin && at < values.size() ? &values[at] : nullptr;
  };
  if (const float* found = in(BlockHostEye, tables_.eye)) return found;
  if (const float* found = in(BlockHostLight, tables_.light)) return found;
  if (const float* found = in(BlockHostScreen, tables_.screen)) return found;
  if (address < BlockHostTable || address >= BlockHostEnd) return nullptr;
  const block_ball& ball = balls_[(address - BlockHostTable) / BlockHostRow];
  const std::uint64_t at = (address - BlockHostTable) % BlockHostRow / WordBytes;
  if (at == ball.centre.size()) return &ball.radius;
  if (at < ball.centre.size()) return &ball.centre[at];
  return at < BlockHostNumbers ? &ball.colour[at - ball.centre.size() - 1] : nullptr;
}

bool tlm_block::write_host(std::uint64_t address, std::uint32_t value) {
  if (address == BlockHostSize) return false;
  if (address == BlockHostSpheres) {
    if (value > BlockEntries) return false;
    spheres_ = value;
  } else if (address == BlockHostControl) {
    if (!(value & 1)) return true;
    if (drawing_) return false;
    tables_.balls.assign(balls_.begin(), balls_.begin() + spheres_);
    seen_ = store().clock();
    machine_.draw(tables_);
    drawing_ = true;
    started_.notify(sc_core::SC_ZERO_TIME);
  } else {
    std::memcpy(const_cast<float*>(number(address)), &value, sizeof value);
  }
  return true;
}

tlm_block::word tlm_block::read_host(std::uint64_t address) const {
  switch (address) {
    case BlockHostControl: return word_of(drawing_);
    case BlockHostSpheres: return word_of(spheres_);
    case BlockHostSize: return word_of(knobs_.rows() << 16 | knobs_.columns());
    default: break;
  }
  const float* const found = address % WordBytes ? nullptr : number(address);
  if (!found) return {false, 0};
  std::uint32_t value = 0;
  std::memcpy(&value, found, sizeof value);
  return {true, value};
}

unsigned tlm_block::peek_host(tlm::tlm_generic_payload& payload) {
  return peek(payload, [this](std::uint64_t address) { return read_host(address); });
}

tlm_block::word tlm_block::read_register(std::uint64_t address) const {
  const auto clocks = static_cast<std::uint64_t>(drawing_ ? seen_ : store().clock());
  if (address % WordBytes) return {false, 0};
  if (address >= BlockRegisterBusy) {
    const auto& busy = counters_.busy_by_core;
    return counter_word({busy.begin(), busy.begin() + knobs_.cores}, address - BlockRegisterBusy);
  }
  if (address >= BlockRegisterCounters)
    return counter_word(counted(counters_).counters, address - BlockRegisterCounters);
  switch (address) {
    case BlockRegisterId: return word_of(BlockRegisterIdValue);
    case BlockRegisterPictures: return word_of(pictures_);
    case BlockRegisterClocks: return word_of(clocks);
    case BlockRegisterClocks + WordBytes: return word_of(clocks >> 32);
    case BlockRegisterPeriod: return word_of(period_.value());
    default: break;
  }
  if (address < BlockRegisterKnobs) return {false, 0};
  return knob_word(knobs_, address - BlockRegisterKnobs);
}

}  // namespace racebeam
