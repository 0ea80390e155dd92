// What is around a tlm_picture_chip: a memory as display, a host that asks when the test tells it
// to.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <systemc>
#include <vector>

#include "sc/base/tlm_words.h"

namespace racebeam {

/// Keeps what is written; tells of each picture.
class PictureDisplay : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<PictureDisplay> socket{"socket"};
  std::vector<std::uint8_t> bytes;
  std::function<void()> on_picture = [] {};

  /// Of so many columns and rows at most.
  PictureDisplay(const sc_core::sc_module_name& name, int columns, int rows)
      : sc_module(name), bytes(last(columns, rows) + 3 * WordBytes), last_(last(columns, rows)) {
    socket.register_b_transport(this, &PictureDisplay::access);
  }
  std::uint32_t word(int n) const { return get_word(&bytes[last_ + 4u * n]); }

 private:
  void access(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
    const std::uint64_t begin = payload.get_address(), end = begin + payload.get_data_length();
    const bool known = payload.is_write() && end <= bytes.size();
    payload.set_response_status(known ? tlm::TLM_OK_RESPONSE : tlm::TLM_ADDRESS_ERROR_RESPONSE);
    if (!known) return;
    std::copy_n(payload.get_data_ptr(), end - begin,
                bytes.begin() + static_cast<std::ptrdiff_t>(begin));
    if (begin == last_) on_picture();
  }
  static std::size_t last(int columns, int rows) {
    return std::size_t{3} * static_cast<unsigned>(columns) * static_cast<unsigned>(rows);
  }

  const std::size_t last_;  // what comes after the rows
};

/// An initiator for a socket of words; calls that last need a process.
class WordInitiator : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<WordInitiator> socket{"socket"};
  tlm::tlm_generic_payload payload;
  sc_core::sc_time delay;

  explicit WordInitiator(const sc_core::sc_module_name& name) : sc_module(name) {}

  tlm::tlm_response_status access(tlm::tlm_command command, std::uint64_t address,
                                  std::uint32_t* words, unsigned bytes) {
    prepare_write(payload, address, reinterpret_cast<std::uint8_t*>(words), bytes);
    payload.set_command(command);
    delay = sc_core::SC_ZERO_TIME;
    socket->b_transport(payload, delay);
    return payload.get_response_status();
  }
  void write(std::uint64_t address, std::uint32_t word) {
    EXPECT_EQ(access(tlm::TLM_WRITE_COMMAND, address, &word, 4), tlm::TLM_OK_RESPONSE);
  }
  std::uint32_t read(std::uint64_t address) {
    std::uint32_t word = 0;
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, address, &word, 4), tlm::TLM_OK_RESPONSE);
    return word;
  }
};

}  // namespace racebeam
