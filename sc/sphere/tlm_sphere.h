// tlm_sphere: the sphere tracer with its frame store as a TLM-2.0 component, loosely timed.
//
// What    sphere_core behind sockets: the same words, counters and clocks as sphere_chip. A CPU
//         writes its wires by host_socket, and reads `rotz` and `done`; a picture leaves by
//         display_socket when it is drawn; state, switches, keys, knobs and counters are at
//         register_socket. tlm_sphere_map.h has the addresses.
// Time    as tlm_picture_chip. One clock in reset. A write to the host's wires holds from its
//         annotated time on, clock by clock as at the pins. Switches and keys are seen at the end
//         of a picture.
// Sockets those of tlm_picture_chip; host_socket: target, 32 bits, may stay unbound, b_transport
//         and, to read, transport_dbg. A word takes host_clocks_per_word clocks.
// Reset   by register: one clock in reset after the picture, or, in HOST, at once.
// Test    tests/sphere/tlm_sphere_test.cpp
// Source  report "Communication between NIOS II and FPGA"; docs/virtual-platform.md.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "sc/sphere/sphere_core.h"
#include "sc/sphere/tlm_sphere_map.h"
#include "sc/store/tlm_picture_chip.h"

namespace racebeam {

class tlm_sphere : public tlm_picture_chip {
 public:
  tlm_utils::simple_target_socket_optional<tlm_sphere> host_socket{"host_socket"};

  /// With these switches and keys. `tables` must outlive it.
  tlm_sphere(const sc_core::sc_module_name& name, const sphere_knobs& k,
             const sphere_tables& tables, const sphere_board& board = {});

  /// Back door.
  const sphere_core& core() const { return *core_; }
  /// Of the last picture that was sent.
  const sphere_counters& counters() const { return counters_; }

 private:
  void run();
  void restart();
  void await_table();

  const frame_store& store() const override { return core_->store(); }
  void advance(std::int64_t clock) override;
  drawn picture() const override { return {core_->columns(), core_->rows(), core_->picture()}; }
  word read_register(std::uint64_t address) const override;
  bool writable(std::uint64_t address) const override;
  void write_register(std::uint64_t address, std::uint32_t value) override;

  void access_host(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  void write_wire(std::uint64_t address, std::uint32_t value);
  word read_host(std::uint64_t address) const;
  unsigned peek_host(tlm::tlm_generic_payload& payload);

  const sphere_knobs knobs_;
  const sphere_tables& tables_;
  std::optional<sphere_core> core_;
  sphere_board board_;
  sphere_host_pins wires_;
  sc_core::sc_time look_;   // after what the CPU did
  sc_core::sc_event news_;  // the CPU did something, or a picture has begun
  std::int64_t seen_ = 0;   // while drawing: clocks that the host link has seen
  bool reset_ = false;      // as soon as may be
  sphere_counters counters_;
};

}  // namespace racebeam
