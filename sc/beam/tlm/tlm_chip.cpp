// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/tlm/tlm_chip.h"

#include <string>

#include "sc/base/tlm_words.h"

namespace racebeam {

tlm_chip::tlm_chip(const sc_core::sc_module_name& name, const chip_lines::options& o)
    : sc_module(name),
      knobs_(o.k),
      period_(clock_period_ps(o.k.clocks_per_pixel), sc_core::SC_PS),
      lines_(o) {
  SC_HAS_PROCESS(tlm_chip);
  SC_THREAD(run);
  register_socket.register_b_transport(this, &tlm_chip::access);
  register_socket.register_transport_dbg(this, &tlm_chip::peek);
  register_socket.register_get_direct_mem_ptr(this, &tlm_chip::refuse_memory);
}

void tlm_chip::deposit(int frame) { lines_.deposit(frame); }

void tlm_chip::run() {
  wait(period_);  // in reset
  quantum_.reset();
  for (;;) {
    if (reset_) {
      lines_.reset();
      quantum_.inc(period_);
      ++clocks_;
      reset_ = false;
    }
    lines_.run_line();
    clocks_ += lines_.line_clocks();
    quantum_.inc(lines_.line_clocks() * period_);
    send_line();
    if (lines_.next_line() == FirstLine) {
      stats_ = lines_.take_stats();
      ++frames_;
      std::uint8_t number[WordBytes];
      put_word(number, lines_.frame());
      send(DisplayFrame, number, sizeof number);
      quantum_.sync();
    } else if (quantum_.need_sync()) {
      quantum_.sync();
    }
  }
}

void tlm_chip::send_line() {
  const std::uint64_t line = DisplayLinePitch * (lines_.y() - FirstLine);
  if (lines_.visible())
    send(std::uint64_t{VisibleColumns} * (lines_.y() - FirstVisibleLine), lines_.pixels().data(),
         VisibleColumns);
  if (!lines_.pins().empty()) send(DisplayPins + line, lines_.pins().data(), lines_.pins().size());
  if (lines_.sound().empty()) return;
  bytes_.resize(WordBytes * lines_.sound().size());
  std::uint8_t* to = bytes_.data();
  for (const auto& change : lines_.sound()) {
    put_word(to, change.clock << 1 | change.level);
    to += WordBytes;
  }
  send(DisplaySound + line, bytes_.data(), bytes_.size());
}

void tlm_chip::send(std::uint64_t address, const std::uint8_t* data, std::size_t bytes) {
  prepare_write(payload_, address, data, bytes);
  sc_core::sc_time delay = quantum_.get_local_time();
  display_socket->b_transport(payload_, delay);
  quantum_.set(delay);
  if (payload_.is_response_error())
    SC_REPORT_ERROR("racebeam/tlm_chip",
                    ("the display answers a write to address " + std::to_string(address) +
                     " with " + payload_.get_response_string())
                        .c_str());
}

void tlm_chip::access(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  payload.set_dmi_allowed(false);
  payload.set_response_status(serve(payload));
  if (payload.is_response_ok()) delay += payload.get_data_length() / WordBytes * period_;
}

tlm::tlm_response_status tlm_chip::serve(tlm::tlm_generic_payload& payload) {
  const std::uint64_t begin = payload.get_address();
  const unsigned bytes = payload.get_data_length();
  if (const auto whole = whole_words(payload); whole != tlm::TLM_OK_RESPONSE) return whole;
  for (unsigned i = 0; i < bytes; i += WordBytes)
    if (begin + i != RegisterReset && !is_register(begin + i))
      return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  std::uint8_t* const data = payload.get_data_ptr();
  if (payload.is_write()) {
    if (begin != RegisterReset || bytes != WordBytes) return tlm::TLM_COMMAND_ERROR_RESPONSE;
    reset_ |= get_word(data) & 1;
  } else if (payload.is_read()) {
    for (unsigned i = 0; i < bytes; i += WordBytes)
      if (begin + i == RegisterReset) return tlm::TLM_COMMAND_ERROR_RESPONSE;
    for (unsigned i = 0; i < bytes; i += WordBytes) put_word(data + i, read(begin + i).value);
  }
  return tlm::TLM_OK_RESPONSE;
}

// As many words as there are, without time.
unsigned tlm_chip::peek(tlm::tlm_generic_payload& payload) {
  if (!payload.is_read() || payload.get_address() % WordBytes) return 0;
  unsigned done = 0;
  for (; done + WordBytes <= payload.get_data_length(); done += WordBytes) {
    const word w = read(payload.get_address() + done);
    if (!w.known) break;
    put_word(payload.get_data_ptr() + done, w.value);
  }
  return done;
}

bool tlm_chip::refuse_memory(tlm::tlm_generic_payload&, tlm::tlm_dmi& memory) {
  return no_direct_memory(memory);
}

tlm_chip::word tlm_chip::read(std::uint64_t address) const {
  if (address % WordBytes) return {false, 0};
  return address < RegisterCounters ? read_chip(address) : read_stats(address);
}

tlm_chip::word tlm_chip::read_chip(std::uint64_t address) const {
  const auto word_of = [](auto value) { return word{true, static_cast<std::uint32_t>(value)}; };
  switch (address) {
    case RegisterId: return word_of(RegisterIdValue);
    case RegisterFrame: return word_of(lines_.next_frame());
    case RegisterLine: return word_of(lines_.next_line());
    case RegisterFrames: return word_of(frames_);
    case RegisterClocks: return word_of(clocks_);
    case RegisterClocks + WordBytes: return word_of(clocks_ >> 32);
    case RegisterLineClocks: return word_of(lines_.line_clocks());
    case RegisterPeriod: return word_of(clock_period_ps(knobs_.clocks_per_pixel));
    default: break;
  }
  const std::uint64_t knob = (address - RegisterKnobs) / WordBytes;
  if (address < RegisterKnobs || knob >= knob_table().size()) return {false, 0};
  return word_of(knobs_.*knob_table()[knob].member);
}

tlm_chip::word tlm_chip::read_stats(std::uint64_t address) const {
  const auto in_table = [address](std::uint64_t begin, std::size_t bytes) {
    return address >= begin && address < begin + bytes;
  };
  const auto half = [address](std::uint64_t counter) {
    return word{true, static_cast<std::uint32_t>(counter >> (address % 8 * 8))};
  };
  static const auto registers = counter_registers();
  if (in_table(RegisterCounters, 8 * registers.size()))
    return half(stats_.*registers[(address - RegisterCounters) / 8]);
  std::uint64_t begin = RegisterHistograms;
  for (const histogram_row& row : histogram_table()) {
    const auto& values = stats_.*row.member;
    if (in_table(begin, 8 * values.size())) return half(values[(address - begin) / 8]);
    begin += HistogramPitch;
  }
  begin = RegisterLines;
  for (const line_row& row : line_table()) {
    if (in_table(begin, WordBytes * VisibleRows)) {
      const auto& values = stats_.*row.member;
      const std::size_t line = (address - begin) / WordBytes;
      return {true, line < values.size() ? static_cast<std::uint32_t>(values[line]) : 0};
    }
    begin += LinesPitch;
  }
  return {false, 0};
}

}  // namespace racebeam
