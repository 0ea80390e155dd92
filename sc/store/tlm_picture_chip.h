// tlm_picture_chip: what chips that draw pictures into a frame store share as TLM-2.0 components,
// loosely timed.
//
// What    a picture leaves by display_socket when it is drawn; registers are at register_socket. An
//         engine derives from it, and adds its host_socket.
// Time    a picture is drawn at once, and sent at the end of its last clock. Whoever asks about a
//         later time waits until it was sent: initiators may be ahead as far as they like, but are
//         heard in the order of their calls.
// Sockets display_socket: initiator, b_transport only. A response that is not OK is a SystemC
//         error. register_socket: target, 32 bits, may stay unbound, b_transport and, to read,
//         transport_dbg. A register takes a clock. No direct memory. Responses: as tlm_chip's.
//         display_socket writes, no byte enables, when a picture is drawn:
//         3 * width * row     3 * columns bytes  a row, from 0: red, green, blue of each column, 8
//                             bits each
//         3 * width * height  3 words  after the last row: number of the picture, from 0; columns;
//                             rows
//         width and height are those of the largest picture.
// Test    tests/sphere/tlm_sphere_test.cpp, tests/block/tlm_block_test.cpp
// Source  docs/virtual-platform.md.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <systemc>
#include <tlm>
#include <vector>

#include "sc/base/frame_counts.h"
#include "sc/base/knob_values.h"
#include "sc/base/tlm_words.h"
#include "sc/store/frame_scanout.h"
#include "sc/store/frame_store.h"

namespace racebeam {

class tlm_picture_chip : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<tlm_picture_chip> display_socket{"display_socket"};
  tlm_utils::simple_target_socket_optional<tlm_picture_chip> register_socket{"register_socket"};

  /// Pictures that were sent.
  std::uint32_t pictures() const { return pictures_; }

 protected:
  struct word {
    bool known;
    std::uint32_t value;
  };
  template <class Value>
  static word word_of(Value value) {
    return {true, static_cast<std::uint32_t>(value)};
  }
  /// What the store holds of a picture, and where the next one lies.
  struct drawn {
    int columns, rows;
    std::vector<std::uint64_t> words;  ///< by address
  };

  tlm_picture_chip(const sc_core::sc_module_name& name, const store_knobs& k, int clocks_per_pixel,
                   int width, int height);

  // What an engine adds.
  virtual const frame_store& store() const = 0;
  /// All clocks before this one, with what is known by now; not past the end of a picture.
  virtual void advance(std::int64_t clock) = 0;
  virtual drawn picture() const = 0;
  virtual word read_register(std::uint64_t address) const = 0;
  /// One that can be written; it need not be readable.
  virtual bool writable(std::uint64_t address) const = 0;
  virtual void write_register(std::uint64_t address, std::uint32_t value) = 0;

  /// Clock 0 is the next one.
  void restart_clock();
  std::int64_t clock_at(const sc_core::sc_time& time) const;
  sc_core::sc_time time_of(std::int64_t clock) const;
  /// Brings the tracer to the time of an access, which may be ahead; that time. The call lasts
  /// until all pictures before it were sent.
  sc_core::sc_time catch_up(sc_core::sc_time& delay);
  /// In a thread: waits for the end of the picture that is drawn, and sends it.
  void send_picture();
  /// After send_picture(): the tracer waits for its host again.
  void end_picture();

  /// A counter of 64 bits, a word at a time.
  static word counter_word(const std::vector<std::uint64_t>& values, std::uint64_t at);
  static word knob_word(const knob_values& values, std::uint64_t at);
  /// A host's access to words, a clock each: `read(address)`, `write(address, value)`, whether it
  /// was taken.
  template <class Read, class Write>
  void access_words(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay, Read&& read,
                    Write&& write) {
    payload.set_dmi_allowed(false);
    tlm::tlm_response_status status = whole_words(payload);
    const std::uint64_t begin = payload.get_address(), end = begin + payload.get_data_length();
    std::uint8_t* data = payload.get_data_ptr();
    for (std::uint64_t at = begin; at < end && status == tlm::TLM_OK_RESPONSE; at += WordBytes)
      if (!read(at).known) status = tlm::TLM_ADDRESS_ERROR_RESPONSE;
    for (std::uint64_t at = begin; at < end && status == tlm::TLM_OK_RESPONSE;
         at += WordBytes, data += WordBytes) {
      catch_up(delay);
      if (payload.is_read()) put_word(data, read(at).value);
      else if (payload.is_write() && !write(at, get_word(data)))
        status = tlm::TLM_COMMAND_ERROR_RESPONSE;
      delay += period_;
    }
    payload.set_response_status(status);
  }
  template <class Read>
  static unsigned peek(tlm::tlm_generic_payload& payload, Read&& read) {
    if (!payload.is_read() || payload.get_address() % WordBytes) return 0;
    unsigned done = 0;
    for (; done + WordBytes <= payload.get_data_length(); done += WordBytes) {
      const word w = read(payload.get_address() + done);
      if (!w.known) break;
      put_word(payload.get_data_ptr() + done, w.value);
    }
    return done;
  }
  bool refuse_memory(tlm::tlm_generic_payload&, tlm::tlm_dmi& memory) {
    return no_direct_memory(memory);
  }

  const sc_core::sc_time period_;
  bool drawing_ = false;
  sc_core::sc_event sent_;
  std::uint32_t pictures_ = 0;

 private:
  void send(std::uint64_t address, const std::uint8_t* data, std::size_t bytes);
  void access_registers(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned peek_registers(tlm::tlm_generic_payload& payload);

  const store_knobs store_knobs_;
  const std::uint64_t pitch_;  // bytes
  const int height_;
  sc_core::sc_time begin_;  // of clock 0
  tlm::tlm_generic_payload payload_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace racebeam
