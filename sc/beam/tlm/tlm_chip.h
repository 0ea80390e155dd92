// tlm_chip: the chip as a TLM-2.0 component, loosely timed, decoupled by scan line.
//
// What    the cores of all units in one loop (chip_lines): same pixels, counters and clocks as the
//         wired chip. Each visible line and each frame leave as a write transaction; frame counter,
//         knobs and statistics are read by another socket. tlm_map.h has both address maps.
// Time    one clock in reset, then line after line, each ahead of time: a line transaction is
//         annotated with the end of its line. Synchronises when the global quantum is used up, and
//         at the end of every frame.
// Sockets display_socket: initiator, 32 bits, b_transport only. A response that is not OK is a
//         SystemC error. register_socket: target, 32 bits, may stay unbound, b_transport and
//         transport_dbg; a word takes one clock; what it reads may be ahead by the quantum. No
//         direct memory. Responses: address error (not a register, not aligned), command error
//         (write to what is read only, read of what is write only), burst error (length not whole
//         words, streaming), byte enable error.
// Reset   by register: one clock in reset before the next line.
// Test    tests/beam/tlm_chip_test.cpp, tests/beam/tlm_registers_test.cpp,
//         tests/beam/tlm_equality_test.cpp
// Source  docs/virtual-platform.md.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>
#include <tlm_utils/tlm_quantumkeeper.h>

#include <cstdint>
#include <systemc>
#include <tlm>

#include "sc/beam/tlm/chip_lines.h"
#include "sc/beam/tlm/tlm_map.h"

namespace racebeam {

class tlm_chip : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<tlm_chip> display_socket{"display_socket"};
  tlm_utils::simple_target_socket_optional<tlm_chip> register_socket{"register_socket"};

  tlm_chip(const sc_core::sc_module_name& name, const chip_lines::options& o);

  /// Puts the demo to the start of a frame (back door, between frames).
  void deposit(int frame);
  /// The counters of the last whole frame (back door).
  const frame_stats& stats() const { return stats_; }
  /// Clocks of lines and resets since the start.
  std::uint64_t clocks() const { return clocks_; }
  const chip_lines& lines() const { return lines_; }

 private:
  void run();
  void send_line();
  void send(std::uint64_t address, const std::uint8_t* data, std::size_t bytes);
  void access(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned peek(tlm::tlm_generic_payload& payload);
  bool refuse_memory(tlm::tlm_generic_payload& payload, tlm::tlm_dmi& memory);
  tlm::tlm_response_status serve(tlm::tlm_generic_payload& payload);
  bool is_register(std::uint64_t address) const { return read(address).known; }
  struct word {
    bool known;
    std::uint32_t value;
  };
  word read(std::uint64_t address) const;
  word read_chip(std::uint64_t address) const;
  word read_stats(std::uint64_t address) const;

  const knobs knobs_;
  const sc_core::sc_time period_;
  chip_lines lines_;
  tlm_utils::tlm_quantumkeeper quantum_;
  tlm::tlm_generic_payload payload_;
  frame_stats stats_;
  std::uint64_t clocks_ = 0;
  std::uint32_t frames_ = 0;
  bool reset_ = false;  // before the next line
  std::vector<std::uint8_t> bytes_;
};

}  // namespace racebeam
