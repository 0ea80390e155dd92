// A virtual platform for tlm_sphere: a memory as display, a host that asks when the test tells it
// to.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "sc/base/tlm_words.h"
#include "sc/sphere/tlm_sphere.h"

namespace racebeam {

/// Keeps what is written; tells of each picture.
class SphereDisplay : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<SphereDisplay> socket{"socket"};
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(SphereDisplayPicture + 3 * WordBytes);
  std::function<void()> on_picture = [] {};

  explicit SphereDisplay(const sc_core::sc_module_name& name) : sc_module(name) {
    socket.register_b_transport(this, &SphereDisplay::access);
  }
  std::uint32_t word(int n) const { return get_word(&bytes[SphereDisplayPicture + 4u * n]); }

 private:
  void access(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
    const std::uint64_t begin = payload.get_address(), end = begin + payload.get_data_length();
    const bool known = payload.is_write() && end <= bytes.size();
    payload.set_response_status(known ? tlm::TLM_OK_RESPONSE : tlm::TLM_ADDRESS_ERROR_RESPONSE);
    if (!known) return;
    std::copy_n(payload.get_data_ptr(), end - begin,
                bytes.begin() + static_cast<std::ptrdiff_t>(begin));
    if (begin == SphereDisplayPicture) on_picture();
  }
};

/// An initiator for a socket of the tracer; calls that last need a process.
class SphereInitiator : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<SphereInitiator> socket{"socket"};
  tlm::tlm_generic_payload payload;
  sc_core::sc_time delay;

  explicit SphereInitiator(const sc_core::sc_module_name& name) : sc_module(name) {}

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

/// A picture of 320 x 240, two clocks a word.
struct SpherePlatform : testing::Test {
  static constexpr int Narrow = 0;

  SpherePlatform() {
    chip.display_socket.bind(display.socket);
    host.socket.bind(chip.host_socket);
    registers.socket.bind(chip.register_socket);
  }
  /// To `clocks` clocks after the reset, in the middle of a clock.
  void run_to(std::int64_t clocks) {
    const sc_core::sc_time end = (static_cast<double>(clocks) + 1.5) * Clock;
    sc_core::sc_start(end - sc_core::sc_time_stamp());
  }

  const sc_core::sc_time Clock{clock_period_ps(1), sc_core::SC_PS};
  sphere_tables tables;
  sphere_board board{Narrow, 15};
  tlm_sphere chip{"chip", {}, tables, board};
  SphereDisplay display{"display"};
  SphereInitiator host{"host"}, registers{"registers"};
};

}  // namespace racebeam
