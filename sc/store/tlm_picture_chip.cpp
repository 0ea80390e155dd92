// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/tlm_picture_chip.h"

#include <algorithm>
#include <string>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

std::uint8_t byte_of(int dac) { return static_cast<std::uint8_t>(dac >> (DacBits - 8)); }

}  // namespace

tlm_picture_chip::tlm_picture_chip(const sc_core::sc_module_name& name, const store_knobs& k,
                                   int clocks_per_pixel, int width, int height)
    : sc_module(name),
      period_(clock_period_ps(clocks_per_pixel), sc_core::SC_PS),
      store_knobs_(k),
      pitch_(std::uint64_t{3} * static_cast<unsigned>(width)),
      height_(height),
      begin_(period_) {
  register_socket.register_b_transport(this, &tlm_picture_chip::access_registers);
  register_socket.register_transport_dbg(this, &tlm_picture_chip::peek_registers);
  register_socket.register_get_direct_mem_ptr(this, &tlm_picture_chip::refuse_memory);
}

void tlm_picture_chip::restart_clock() { begin_ = sc_core::sc_time_stamp() + period_; }

std::int64_t tlm_picture_chip::clock_at(const sc_core::sc_time& time) const {
  if (time < begin_) return 0;
  return static_cast<std::int64_t>((time - begin_).value() / period_.value());
}

sc_core::sc_time tlm_picture_chip::time_of(std::int64_t clock) const {
  return begin_ + sc_core::sc_time::from_value(static_cast<std::uint64_t>(clock) * period_.value());
}

sc_core::sc_time tlm_picture_chip::catch_up(sc_core::sc_time& delay) {
  const sc_core::sc_time time = sc_core::sc_time_stamp() + delay;
  const auto over = [&] { return drawing_ && time_of(store().clock()) <= time; };
  for (;;) {
    while (over()) wait(sent_);
    advance(clock_at(time));
    if (!over()) break;
  }
  const sc_core::sc_time now = sc_core::sc_time_stamp();
  delay = time > now ? time - now : sc_core::SC_ZERO_TIME;
  return std::max(time, now);
}

void tlm_picture_chip::send_picture() {
  const std::int64_t done = store().clock();
  if (time_of(done) > sc_core::sc_time_stamp()) wait(time_of(done) - sc_core::sc_time_stamp());
  advance(done);
  const drawn all = picture();
  for (int y = 0; y < all.rows; ++y) {
    bytes_.clear();
    for (int x = 0; x < all.columns; ++x) {
      const frame_scanout_core::colour c = frame_scanout_core::pixel(all.words, y, x, store_knobs_);
      bytes_.insert(bytes_.end(), {byte_of(c.red), byte_of(c.green), byte_of(c.blue)});
    }
    send(pitch_ * static_cast<std::uint64_t>(y), bytes_.data(), bytes_.size());
  }
  std::uint8_t last[3 * WordBytes];
  put_word(last, pictures_);
  put_word(last + WordBytes, static_cast<std::uint32_t>(all.columns));
  put_word(last + 2 * WordBytes, static_cast<std::uint32_t>(all.rows));
  send(pitch_ * static_cast<std::uint64_t>(height_), last, sizeof last);
}

void tlm_picture_chip::end_picture() {
  drawing_ = false;
  ++pictures_;
  sent_.notify();
}

void tlm_picture_chip::send(std::uint64_t address, const std::uint8_t* data, std::size_t bytes) {
  prepare_write(payload_, address, data, bytes);
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  display_socket->b_transport(payload_, delay);
  if (payload_.is_response_error())
    SC_REPORT_ERROR(("racebeam/" + std::string(basename())).c_str(),
                    ("the display answers a write to address " + std::to_string(address) +
                     " with " + payload_.get_response_string())
                        .c_str());
}

void tlm_picture_chip::access_registers(tlm::tlm_generic_payload& payload,
                                        sc_core::sc_time& delay) {
  payload.set_dmi_allowed(false);
  tlm::tlm_response_status status = whole_words(payload);
  const std::uint64_t begin = payload.get_address();
  const unsigned bytes = payload.get_data_length();
  std::uint8_t* const data = payload.get_data_ptr();
  for (unsigned i = 0; i < bytes && status == tlm::TLM_OK_RESPONSE; i += WordBytes) {
    const std::uint64_t address = begin + i;
    if (read_register(address).known) continue;
    if (!writable(address)) status = tlm::TLM_ADDRESS_ERROR_RESPONSE;
    else if (payload.is_read()) status = tlm::TLM_COMMAND_ERROR_RESPONSE;
  }
  if (status == tlm::TLM_OK_RESPONSE && payload.is_read()) {
    catch_up(delay);
    for (unsigned i = 0; i < bytes; i += WordBytes)
      put_word(data + i, read_register(begin + i).value);
  } else if (status == tlm::TLM_OK_RESPONSE && payload.is_write()) {
    if (bytes == WordBytes && writable(begin)) {
      catch_up(delay);
      write_register(begin, get_word(data));
    } else {
      status = tlm::TLM_COMMAND_ERROR_RESPONSE;
    }
  }
  payload.set_response_status(status);
  if (payload.is_response_ok()) delay += bytes / WordBytes * period_;
}

unsigned tlm_picture_chip::peek_registers(tlm::tlm_generic_payload& payload) {
  return peek(payload, [this](std::uint64_t address) { return read_register(address); });
}

tlm_picture_chip::word tlm_picture_chip::counter_word(const std::vector<std::uint64_t>& values,
                                                      std::uint64_t at) {
  if (at / 8 >= values.size()) return {false, 0};
  return word_of(values[at / 8] >> (at % 8 * 8));
}

tlm_picture_chip::word tlm_picture_chip::knob_word(const knob_values& values, std::uint64_t at) {
  if (at / WordBytes >= values.rows().size()) return {false, 0};
  return word_of(values[at / WordBytes]);
}

}  // namespace racebeam
