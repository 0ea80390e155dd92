// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/tlm_voxel.h"

#include <algorithm>

#include "sc/voxel/tlm_voxel_map.h"

namespace racebeam {

namespace {

constexpr int HalfWord = 16;

/// {y, x}
std::uint32_t pair_of(int y, int x) {
  return static_cast<std::uint32_t>(y) << HalfWord | static_cast<std::uint32_t>(x);
}
int x_of(std::uint32_t pair) { return static_cast<int>(pair & 0xffff); }
int y_of(std::uint32_t pair) { return static_cast<int>(pair >> HalfWord); }

}  // namespace

tlm_voxel::tlm_voxel(const sc_core::sc_module_name& name, const voxel_knobs& k)
    : tlm_picture_chip(name, k.store(), voxel_knobs::clocks_per_pixel, VoxelDisplayColumns,
                       VoxelDisplayRows),
      knobs_(k),
      machine_(k) {
  SC_HAS_PROCESS(tlm_voxel);
  SC_THREAD(run);
  host_socket.register_b_transport(this, &tlm_voxel::access_host);
  host_socket.register_transport_dbg(this, &tlm_voxel::peek_host);
  host_socket.register_get_direct_mem_ptr(this, &tlm_voxel::refuse_memory);
}

void tlm_voxel::run() {
  restart_clock();
  for (;;) {
    wait(started_);
    send_picture();
    counters_ = machine_.counters();
    end_picture();
  }
}

void tlm_voxel::advance(std::int64_t clock) {
  seen_ = std::max(seen_, clock);
  if (!drawing_) machine_.go_to(clock);
}

void tlm_voxel::access_host(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  access_words(
      payload, delay, [this](std::uint64_t address) { return read_host(address); },
      [this](std::uint64_t address, std::uint32_t value) { return write_host(address, value); });
}

const int* tlm_voxel::register_of_view(std::uint64_t address) const {
  const auto in = [&](std::uint64_t begin, const vec3& values) -> const int* {
    const std::uint64_t at = (address - begin) / WordBytes;
    return address >= begin && at < values.size() ? &values[at] : nullptr;
  };
  if (const int* found = in(VoxelHostOrigin, view_.origin)) return found;
  if (const int* found = in(VoxelHostD00, view_.d00)) return found;
  if (const int* found = in(VoxelHostDx, view_.dx)) return found;
  if (const int* found = in(VoxelHostDy, view_.dy)) return found;
  return in(VoxelHostLight, view_.light);
}

bool tlm_voxel::build() {
  const voxel_rectangle r{x_of(low_), y_of(low_), x_of(high_), y_of(high_)};
  if (r.x_low >= r.x_high || r.y_low >= r.y_high || r.x_high > knobs_.size_x ||
      r.y_high > knobs_.size_y)
    return false;
  machine_.build(r);
  built_ = machine_.store().clock();
  return true;
}

bool tlm_voxel::write_host(std::uint64_t address, std::uint32_t value) {
  if (const int* const found = register_of_view(address)) {
    *const_cast<int*>(found) = static_cast<int>(value);
    return true;
  }
  if (address == VoxelHostLow) {
    low_ = value;
    return true;
  }
  if (works() || address < VoxelHostLow || address == VoxelHostStatus) return false;
  if (address == VoxelHostHigh) {
    high_ = value;
    return build();
  }
  if (address >= VoxelHostColumns) {
    machine_.write_column(static_cast<std::uint32_t>((address - VoxelHostColumns) / WordBytes),
                          value);
  } else if (address >= VoxelHostPalette) {
    machine_.write_colour(static_cast<int>((address - VoxelHostPalette) / WordBytes),
                          static_cast<int>(value) & low_bits(VoxelColourBits));
  } else if (value & 1) {
    machine_.draw(view_);
    drawing_ = true;
    started_.notify(sc_core::SC_ZERO_TIME);
  }
  return true;
}

tlm_voxel::word tlm_voxel::read_host(std::uint64_t address) const {
  if (address % WordBytes) return {false, 0};
  if (address >= VoxelHostColumns) {
    const auto& columns = machine_.world().columns();
    const std::uint64_t at = (address - VoxelHostColumns) / WordBytes;
    return at < columns.size() ? word_of(columns[at]) : word{false, 0};
  }
  if (address >= VoxelHostPalette) {
    const std::uint64_t at = (address - VoxelHostPalette) / WordBytes;
    return at < VoxelPaletteEntries ? word_of(machine_.palette()[at]) : word{false, 0};
  }
  if (const int* const found = register_of_view(address)) return word_of(*found);
  switch (address) {
    case VoxelHostSize: return word_of(pair_of(knobs_.size_y, knobs_.size_x));
    case VoxelHostVoxel:
      return word_of(knobs_.voxel_z << 16 | knobs_.voxel_y << 8 | knobs_.voxel_x);
    case VoxelHostLevels: return word_of(machine_.world().levels().count());
    case VoxelHostLow: return word_of(low_);
    case VoxelHostHigh: return word_of(high_);
    case VoxelHostStatus: return word_of((seen_ < built_) | drawing_ << 1);
    case VoxelHostStart: return word_of(0);
    default: return {false, 0};
  }
}

unsigned tlm_voxel::peek_host(tlm::tlm_generic_payload& payload) {
  return peek(payload, [this](std::uint64_t address) { return read_host(address); });
}

tlm_voxel::word tlm_voxel::read_register(std::uint64_t address) const {
  const auto clocks = static_cast<std::uint64_t>(drawing_ ? seen_ : store().clock());
  if (address % WordBytes) return {false, 0};
  if (address >= VoxelRegisterCounters)
    return counter_word(counted(counters_).counters, address - VoxelRegisterCounters);
  switch (address) {
    case VoxelRegisterId: return word_of(VoxelRegisterIdValue);
    case VoxelRegisterPictures: return word_of(pictures_);
    case VoxelRegisterClocks: return word_of(clocks);
    case VoxelRegisterClocks + WordBytes: return word_of(clocks >> 32);
    case VoxelRegisterPeriod: return word_of(period_.value());
    default: break;
  }
  if (address < VoxelRegisterKnobs) return {false, 0};
  return knob_word(knobs_, address - VoxelRegisterKnobs);
}

}  // namespace racebeam
