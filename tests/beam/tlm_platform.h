// A virtual platform for tlm_chip: a memory as display, a host that reads registers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "sc/beam/tlm/tlm_chip.h"

namespace racebeam {

/// A target of so many bytes; counts what is written, and when.
class Memory : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<Memory> socket{"socket"};
  std::vector<std::uint8_t> bytes;
  std::set<sc_core::sc_time> times;  // of all writes
  int writes = 0;

  Memory(const sc_core::sc_module_name& name, std::size_t size) : sc_module(name), bytes(size) {
    socket.register_b_transport(this, &Memory::access);
  }

 private:
  void access(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    const std::uint64_t begin = payload.get_address(), end = begin + payload.get_data_length();
    payload.set_response_status(end > bytes.size() ? tlm::TLM_ADDRESS_ERROR_RESPONSE
                                                   : tlm::TLM_OK_RESPONSE);
    if (end > bytes.size()) return;
    ++writes;
    times.insert(sc_core::sc_time_stamp() + delay);
    std::copy_n(payload.get_data_ptr(), end - begin,
                bytes.begin() + static_cast<std::ptrdiff_t>(begin));
  }
};

/// A processor that asks when the test tells it to.
class Host : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<Host> socket{"socket"};
  tlm::tlm_generic_payload payload;
  sc_core::sc_time delay;

  explicit Host(const sc_core::sc_module_name& name) : sc_module(name) {}

  tlm::tlm_response_status access(tlm::tlm_command command, std::uint64_t address, void* data,
                                  unsigned bytes) {
    prepare(command, address, data, bytes);
    delay = sc_core::SC_ZERO_TIME;
    socket->b_transport(payload, delay);
    return payload.get_response_status();
  }
  std::uint32_t read(std::uint64_t address) {
    std::uint32_t word = 0;
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, address, &word, sizeof word), tlm::TLM_OK_RESPONSE);
    return word;
  }
  std::uint64_t read_64(std::uint64_t address) {
    std::uint64_t word = 0;
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, address, &word, sizeof word), tlm::TLM_OK_RESPONSE);
    return word;
  }
  void prepare(tlm::tlm_command command, std::uint64_t address, void* data, unsigned bytes) {
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(static_cast<unsigned char*>(data));
    payload.set_data_length(bytes);
    payload.set_streaming_width(bytes);
    payload.set_byte_enable_ptr(nullptr);
    payload.set_dmi_allowed(true);
    payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  }
};

inline const sc_core::sc_time Clock(19841, sc_core::SC_PS);
inline const sc_core::sc_time LineTime = 1600 * Clock;
inline const sc_core::sc_time FrameTime = FrameLines * LineTime;

/// Chip, memory and host; we stand in the clock of reset.
struct TlmPlatform : testing::Test {
  TlmPlatform() {
    tlm::tlm_global_quantum::instance().set(FrameTime);
    chip.display_socket.bind(display.socket);
    host.socket.bind(chip.register_socket);
    sc_core::sc_start(Clock / 2);
  }
  void run_frames(int count) { sc_core::sc_start(count * FrameTime); }

  tlm_chip chip{"chip", {}};
  Memory display{"display", DisplayFrame + 4};
  Host host{"host"};
  std::uint32_t word = 0;
};

}  // namespace racebeam
