// tlm_sphere: the sphere tracer with its frame store as a TLM-2.0 component, loosely timed.
//
// What    sphere_core behind sockets: the same words, counters and clocks as sphere_chip. A CPU
//         writes its wires by host_socket, and reads `rotz` and `done`; a picture leaves by
//         display_socket when it is drawn; state, switches, keys, knobs and counters are at
//         register_socket. tlm_sphere_map.h has the addresses.
// Time    one clock in reset. A write to the host's wires holds from its annotated time on, clock
//         by clock as at the pins. A picture is drawn at once, and sent at the end of its last
//         clock. Whoever asks about a later time waits until it was sent: initiators may be
//         ahead as far as they like, but are heard in the order of their calls. Switches and keys
//         are seen at the end of a picture.
// Sockets display_socket: initiator, b_transport only. A response that is not OK is a SystemC
//         error. host_socket, register_socket: targets, 32 bits, may stay unbound, b_transport
//         and, to read, transport_dbg. A word takes host_clocks_per_word clocks, or one of a
//         register. No direct memory. Responses: as tlm_chip's.
// Reset   by register: one clock in reset after the picture, or, in HOST, at once.
// Test    tests/sphere/tlm_sphere_test.cpp
// Source  report "Communication between NIOS II and FPGA"; docs/virtual-platform.md.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <optional>
#include <systemc>
#include <tlm>
#include <vector>

#include "sc/sphere/sphere_core.h"
#include "sc/sphere/tlm_sphere_map.h"

namespace racebeam {

class tlm_sphere : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<tlm_sphere> display_socket{"display_socket"};
  tlm_utils::simple_target_socket_optional<tlm_sphere> host_socket{"host_socket"};
  tlm_utils::simple_target_socket_optional<tlm_sphere> register_socket{"register_socket"};

  /// With these switches and keys. `tables` must outlive it.
  tlm_sphere(const sc_core::sc_module_name& name, const sphere_knobs& k,
             const sphere_tables& tables, const sphere_board& board = {});

  /// Back door.
  const sphere_core& core() const { return *core_; }
  /// Of the last picture that was sent.
  const sphere_counters& counters() const { return counters_; }
  std::uint32_t pictures() const { return pictures_; }

 private:
  struct word {
    bool known;
    std::uint32_t value;
  };

  void run();
  void restart();
  void await_table();
  void send_picture();
  void send(std::uint64_t address, const std::uint8_t* data, std::size_t bytes);

  std::int64_t clock_at(const sc_core::sc_time& time) const;
  sc_core::sc_time time_of(std::int64_t clock) const;
  void advance(std::int64_t clock);
  sc_core::sc_time catch_up(sc_core::sc_time& delay);

  void access_host(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  void write_wire(std::uint64_t address, std::uint32_t value);
  void access_registers(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  void write_register(std::uint64_t address, std::uint32_t value);
  template <word (tlm_sphere::*Read)(std::uint64_t) const>
  unsigned peek(tlm::tlm_generic_payload& payload);
  bool refuse_memory(tlm::tlm_generic_payload& payload, tlm::tlm_dmi& memory);
  word read_host(std::uint64_t address) const;
  word read_register(std::uint64_t address) const;
  word read_counter(std::uint64_t address) const;

  const sphere_knobs knobs_;
  const sphere_tables& tables_;
  const sc_core::sc_time period_;
  std::optional<sphere_core> core_;
  sphere_board board_;
  sphere_host_pins wires_;
  sc_core::sc_time begin_;  // of clock 0
  sc_core::sc_time look_;   // after what the CPU did
  sc_core::sc_event news_;  // the CPU did something, or a picture has begun
  sc_core::sc_event sent_;
  bool drawing_ = false;
  std::int64_t seen_ = 0;  // while drawing: clocks that the host link has seen
  bool reset_ = false;     // as soon as may be
  sphere_counters counters_;
  std::uint32_t pictures_ = 0;
  tlm::tlm_generic_payload payload_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace racebeam
