// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/tlm_sphere.h"

#include <algorithm>
#include <string>

#include "sc/base/constants.h"
#include "sc/base/tlm_words.h"
#include "sc/store/frame_scanout.h"

namespace racebeam {

namespace {

constexpr int HostLinkClocks = 2;  // in which its registers have followed its wires
constexpr int TableClocks = 3;     // from an edge of `valid` to the first RAY, at most

std::uint8_t byte_of(int dac) { return static_cast<std::uint8_t>(dac >> (DacBits - 8)); }

}  // namespace

tlm_sphere::tlm_sphere(const sc_core::sc_module_name& name, const sphere_knobs& k,
                       const sphere_tables& tables, const sphere_board& board)
    : sc_module(name),
      knobs_(k.resolved()),
      tables_(tables),
      period_(clock_period_ps(k.clocks_per_pixel), sc_core::SC_PS),
      board_(board),
      begin_(period_) {
  SC_HAS_PROCESS(tlm_sphere);
  SC_THREAD(run);
  core_.emplace(knobs_, tables_, board_);
  host_socket.register_b_transport(this, &tlm_sphere::access_host);
  host_socket.register_transport_dbg(this, &tlm_sphere::peek<&tlm_sphere::read_host>);
  host_socket.register_get_direct_mem_ptr(this, &tlm_sphere::refuse_memory);
  register_socket.register_b_transport(this, &tlm_sphere::access_registers);
  register_socket.register_transport_dbg(this, &tlm_sphere::peek<&tlm_sphere::read_register>);
  register_socket.register_get_direct_mem_ptr(this, &tlm_sphere::refuse_memory);
}

std::int64_t tlm_sphere::clock_at(const sc_core::sc_time& time) const {
  if (time < begin_) return 0;
  return static_cast<std::int64_t>((time - begin_).value() / period_.value());
}

sc_core::sc_time tlm_sphere::time_of(std::int64_t clock) const {
  return begin_ + sc_core::sc_time::from_value(static_cast<std::uint64_t>(clock) * period_.value());
}

void tlm_sphere::restart() {
  begin_ = sc_core::sc_time_stamp() + period_;
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
      const std::int64_t done = core_->store().clock();
      if (time_of(done) > sc_core::sc_time_stamp()) wait(time_of(done) - sc_core::sc_time_stamp());
      advance(done);
      send_picture();
      counters_ = core_->counters();
      core_->finish(board_);
      drawing_ = false;
      ++pictures_;
      sent_.notify();
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

/// Brings the tracer to the time of an access, which may be ahead; that time. The call lasts until
/// all pictures before it were sent.
sc_core::sc_time tlm_sphere::catch_up(sc_core::sc_time& delay) {
  const sc_core::sc_time time = sc_core::sc_time_stamp() + delay;
  const auto over = [&] { return drawing_ && time_of(core_->store().clock()) <= time; };
  for (;;) {
    while (over()) wait(sent_);
    advance(clock_at(time));
    if (!over()) break;
  }
  const sc_core::sc_time now = sc_core::sc_time_stamp();
  delay = time > now ? time - now : sc_core::SC_ZERO_TIME;
  return std::max(time, now);
}

void tlm_sphere::send_picture() {
  const std::vector<std::uint64_t> words = core_->picture();
  const int columns = core_->columns(), rows = core_->rows();
  const store_knobs store = knobs_.store();
  for (int y = 0; y < rows; ++y) {
    bytes_.clear();
    for (int x = 0; x < columns; ++x) {
      const std::uint64_t word = words[static_cast<std::size_t>(core_->address(x, y))];
      const frame_scanout_core::colour c = frame_scanout_core::unpack(word, store);
      bytes_.insert(bytes_.end(), {byte_of(c.red), byte_of(c.green), byte_of(c.blue)});
    }
    send(SphereDisplayPitch * static_cast<std::uint64_t>(y), bytes_.data(), bytes_.size());
  }
  std::uint8_t last[3 * WordBytes];
  put_word(last, pictures_);
  put_word(last + WordBytes, static_cast<std::uint32_t>(columns));
  put_word(last + 2 * WordBytes, static_cast<std::uint32_t>(rows));
  send(SphereDisplayPicture, last, sizeof last);
}

void tlm_sphere::send(std::uint64_t address, const std::uint8_t* data, std::size_t bytes) {
  prepare_write(payload_, address, data, bytes);
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  display_socket->b_transport(payload_, delay);
  if (payload_.is_response_error())
    SC_REPORT_ERROR("racebeam/tlm_sphere",
                    ("the display answers a write to address " + std::to_string(address) +
                     " with " + payload_.get_response_string())
                        .c_str());
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

void tlm_sphere::access_registers(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  payload.set_dmi_allowed(false);
  tlm::tlm_response_status status = whole_words(payload);
  const std::uint64_t begin = payload.get_address();
  const unsigned bytes = payload.get_data_length();
  std::uint8_t* const data = payload.get_data_ptr();
  for (unsigned i = 0; i < bytes && status == tlm::TLM_OK_RESPONSE; i += WordBytes) {
    const std::uint64_t address = begin + i;
    if (address == SphereRegisterReset) {
      if (payload.is_read()) status = tlm::TLM_COMMAND_ERROR_RESPONSE;
    } else if (!read_register(address).known) {
      status = tlm::TLM_ADDRESS_ERROR_RESPONSE;
    }
  }
  if (status == tlm::TLM_OK_RESPONSE && payload.is_read()) {
    catch_up(delay);
    for (unsigned i = 0; i < bytes; i += WordBytes)
      put_word(data + i, read_register(begin + i).value);
  } else if (status == tlm::TLM_OK_RESPONSE && payload.is_write()) {
    if (bytes == WordBytes && begin >= SphereRegisterReset && begin <= SphereRegisterKeys) {
      catch_up(delay);
      write_register(begin, get_word(data));
    } else {
      status = tlm::TLM_COMMAND_ERROR_RESPONSE;
    }
  }
  payload.set_response_status(status);
  if (payload.is_response_ok()) delay += bytes / WordBytes * period_;
}

void tlm_sphere::write_register(std::uint64_t address, std::uint32_t value) {
  if (address == SphereRegisterSwitches) board_.sw = static_cast<int>(value) & low_bits(18);
  else if (address == SphereRegisterKeys) board_.key_n = static_cast<int>(value) & low_bits(4);
  else if (value & 1) reset_ = true;
  news_.notify(sc_core::SC_ZERO_TIME);
}

tlm_sphere::word tlm_sphere::read_register(std::uint64_t address) const {
  const auto word_of = [](auto value) { return word{true, static_cast<std::uint32_t>(value)}; };
  const auto clocks = static_cast<std::uint64_t>(drawing_ ? seen_ : core_->store().clock());
  if (address % WordBytes) return {false, 0};
  if (address >= SphereRegisterCounters) return read_counter(address);
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
  const std::uint64_t knob = (address - SphereRegisterKnobs) / WordBytes;
  if (address < SphereRegisterKnobs || knob >= sphere_knob_table().size()) return {false, 0};
  return word_of(knobs_.*sphere_knob_table()[knob].member);
}

tlm_sphere::word tlm_sphere::read_counter(std::uint64_t address) const {
  const bool fill = address >= SphereRegisterFill;
  const std::uint64_t at = address - (fill ? SphereRegisterFill : SphereRegisterCounters);
  const frame_counts counts = counted(counters_);
  const std::vector<std::uint64_t>& values = fill ? counts.histograms.front() : counts.counters;
  if (at / 8 >= values.size()) return {false, 0};
  return {true, static_cast<std::uint32_t>(values[at / 8] >> (at % 8 * 8))};
}

// As many words as there are, without time.
template <tlm_sphere::word (tlm_sphere::*Read)(std::uint64_t) const>
unsigned tlm_sphere::peek(tlm::tlm_generic_payload& payload) {
  if (!payload.is_read() || payload.get_address() % WordBytes) return 0;
  unsigned done = 0;
  for (; done + WordBytes <= payload.get_data_length(); done += WordBytes) {
    const word w = (this->*Read)(payload.get_address() + done);
    if (!w.known) break;
    put_word(payload.get_data_ptr() + done, w.value);
  }
  return done;
}

bool tlm_sphere::refuse_memory(tlm::tlm_generic_payload&, tlm::tlm_dmi& memory) {
  return no_direct_memory(memory);
}

}  // namespace racebeam
