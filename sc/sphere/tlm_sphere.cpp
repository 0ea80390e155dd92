// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/tlm_sphere.h"

#include <algorithm>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

constexpr int HostLinkClocks = 2;  // in which its registers have followed its wires
constexpr int TableClocks = 3;     // from an edge of `valid` to the first RAY, at most

}  // namespace

tlm_sphere::tlm_sphere(const sc_core::sc_module_name& name, const sphere_knobs& k,
                       const sphere_tables& tables, const sphere_board& board)
    : tlm_picture_chip(name, k.resolved().store(), k.clocks_per_pixel, VisibleColumns, VisibleRows),
      knobs_(k.resolved()),
      tables_(tables),
      board_(board) {
  SC_HAS_PROCESS(tlm_sphere);
  SC_THREAD(run);
  core_.emplace(knobs_, tables_, board_);
  host_socket.register_b_transport(this, &tlm_sphere::access_host);
  host_socket.register_transport_dbg(this, &tlm_sphere::peek_host);
  host_socket.register_get_direct_mem_ptr(this, &tlm_sphere::refuse_memory);
}

void tlm_sphere::restart() {
  restart_clock();
  core_.emplace(knobs_, tables_, board_);
  reset_ = false;
  wait(period_);
}

void tlm_sphere::run() {
  for (;;) {
    restart();
    while (!reset_) {
      await_table();
      if (reset_) break;
      send_picture();
      counters_ = core_->counters();
      core_->finish(board_);
      end_picture();
    }
  }
}

// In HOST, to its end. Without a CPU that ends when the host link gives up.
void tlm_sphere::await_table() {
  while (!drawing_ && !reset_) {
    const sc_core::sc_time now = sc_core::sc_time_stamp();
    wait(look_ > now ? look_ - now : HostPatience * period_, news_);
    advance(clock_at(sc_core::sc_time_stamp()));
  }
}

// All clocks before this one, with the wires as they are; not past the end of a picture.
void tlm_sphere::advance(std::int64_t clock) {
  while (!drawing_ && core_->store().clock() < clock) {
    if (!core_->host_clock(wires_)) continue;
    seen_ = core_->store().clock();
    core_->draw();
    drawing_ = true;
    news_.notify(sc_core::SC_ZERO_TIME);
  }
  if (!drawing_ || clock <= seen_) return;
  for (int n = 0; n < std::min<std::int64_t>(clock - seen_, HostLinkClocks); ++n)
    core_->busy_clock(wires_);
  seen_ = clock;
}

// The words of a burst one after the other, each at its time.
void tlm_sphere::access_host(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  payload.set_dmi_allowed(false);
  tlm::tlm_response_status status = whole_words(payload);
  const std::uint64_t begin = payload.get_address(), end = begin + payload.get_data_length();
  if (status == tlm::TLM_OK_RESPONSE) {
    if (end > SphereHostEnd) status = tlm::TLM_ADDRESS_ERROR_RESPONSE;
    else if (payload.is_write() && end > SphereHostRotz) status = tlm::TLM_COMMAND_ERROR_RESPONSE;
    else if (payload.is_read() && begin < SphereHostRotz) status = tlm::TLM_COMMAND_ERROR_RESPONSE;
  }
  payload.set_response_status(status);
  if (payload.is_response_error()) return;
  std::uint8_t* data = payload.get_data_ptr();
  for (std::uint64_t address = begin; address < end; address += WordBytes, data += WordBytes) {
    const sc_core::sc_time time = catch_up(delay);
    if (payload.is_read()) {
      put_word(data, read_host(address).value);
    } else if (payload.is_write()) {
      write_wire(address, get_word(data));
      look_ = std::max(look_, time + TableClocks * period_);
      news_.notify(sc_core::SC_ZERO_TIME);
    }
    delay += knobs_.host_clocks_per_word * period_;
  }
}

void tlm_sphere::write_wire(std::uint64_t address, std::uint32_t value) {
  const auto low = [value](int bits) { return static_cast<int>(value) & low_bits(bits); };
  const int coordinate = wrap24(low(SphereBits));
  switch (address) {
    case SphereHostSphere: wires_.sphere = low(8); break;
    case SphereHostColor: wires_.color = low(16); break;
    case SphereHostX1: wires_.x1 = coordinate; break;
    case SphereHostY1: wires_.y1 = coordinate; break;
    case SphereHostZ1: wires_.z1 = coordinate; break;
    case SphereHostReflect: wires_.reflect = low(UnitBits); break;
    case SphereHostRadius: wires_.radius = low(UnitBits); break;
    case SphereHostR2: wires_.r2 = low(SphereBits); break;
    case SphereHostRInv: wires_.r_inv = low(UnitBits); break;
    default: wires_.valid = low(1) != 0; break;
  }
}

tlm_sphere::word tlm_sphere::read_host(std::uint64_t address) const {
  if (address == SphereHostRotz) return {true, static_cast<std::uint32_t>(core_->inputs().rotz_q)};
  if (address == SphereHostDone) return {true, !drawing_};
  return {false, 0};
}

unsigned tlm_sphere::peek_host(tlm::tlm_generic_payload& payload) {
  return peek(payload, [this](std::uint64_t address) { return read_host(address); });
}

bool tlm_sphere::writable(std::uint64_t address) const {
  return address == SphereRegisterReset || address == SphereRegisterSwitches ||
         address == SphereRegisterKeys;
}

void tlm_sphere::write_register(std::uint64_t address, std::uint32_t value) {
  if (address == SphereRegisterSwitches) board_.sw = static_cast<int>(value) & low_bits(18);
  else if (address == SphereRegisterKeys) board_.key_n = static_cast<int>(value) & low_bits(4);
  else if (value & 1) reset_ = true;
  news_.notify(sc_core::SC_ZERO_TIME);
}

tlm_sphere::word tlm_sphere::read_register(std::uint64_t address) const {
  const auto clocks = static_cast<std::uint64_t>(drawing_ ? seen_ : core_->store().clock());
  if (address % WordBytes) return {false, 0};
  if (address >= SphereRegisterFill)
    return counter_word(counted(counters_).histograms.front(), address - SphereRegisterFill);
  if (address >= SphereRegisterCounters)
    return counter_word(counted(counters_).counters, address - SphereRegisterCounters);
  switch (address) {
    case SphereRegisterId: return word_of(SphereRegisterIdValue);
    case SphereRegisterPictures: return word_of(pictures_);
    case SphereRegisterClocks: return word_of(clocks);
    case SphereRegisterClocks + WordBytes: return word_of(clocks >> 32);
    case SphereRegisterPeriod: return word_of(period_.value());
    case SphereRegisterSwitches: return word_of(board_.sw);
    case SphereRegisterKeys: return word_of(board_.key_n);
    default: break;
  }
  if (address < SphereRegisterKnobs) return {false, 0};
  return knob_word(knobs_, address - SphereRegisterKnobs);
}

}  // namespace racebeam
