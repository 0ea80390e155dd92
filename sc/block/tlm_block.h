// tlm_block: the block renderer with its frame store as a TLM-2.0 component, loosely timed.
//
// What    block_machine behind sockets: the same words, counters and clocks as block_chip. A host
//         writes the scene by host_socket, in floats, and starts; a picture leaves by
//         display_socket when it is drawn; knobs and counters are at register_socket.
//         tlm_block_map.h has the addresses.
// Time    as tlm_picture_chip. The scene is what the host has written when it starts: it goes into
//         block_convert then, a number a clock. What is written later is the next picture's.
//         A start while a picture is drawn is refused.
// Sockets those of tlm_picture_chip; host_socket: target, 32 bits, b_transport and, to read,
//         transport_dbg. A word takes a clock. No direct memory. Responses: as tlm_chip's; more
//         than 64 spheres, or a start too early: a command error.
// Test    tests/block/tlm_block_test.cpp
// Source  article "Command and Control"; docs/virtual-platform.md.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sc/block/block_machine.h"
#include "sc/store/tlm_picture_chip.h"

namespace racebeam {

class tlm_block : public tlm_picture_chip {
 public:
  tlm_utils::simple_target_socket_optional<tlm_block> host_socket{"host_socket"};

  tlm_block(const sc_core::sc_module_name& name, const block_knobs& k);

  /// Back door.
  const block_machine& machine() const { return machine_; }
  /// Of the last picture that was sent.
  const block_counters& counters() const { return counters_; }

 private:
  void run();

  const frame_store& store() const override { return machine_.store(); }
  void advance(std::int64_t clock) override;
  drawn picture() const override { return {knobs_.columns(), knobs_.rows(), machine_.picture()}; }
  word read_register(std::uint64_t address) const override;
  bool writable(std::uint64_t) const override { return false; }
  void write_register(std::uint64_t, std::uint32_t) override {}

  void access_host(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  bool write_host(std::uint64_t address, std::uint32_t value);
  word read_host(std::uint64_t address) const;
  unsigned peek_host(tlm::tlm_generic_payload& payload);
  /// Where a float lies; nullptr: nowhere.
  const float* number(std::uint64_t address) const;

  const block_knobs knobs_;
  block_machine machine_;
  // As the host wrote it.
  std::uint32_t spheres_ = 0;
  block_tables tables_;
  std::array<block_ball, BlockEntries> balls_{};
  std::int64_t seen_ = 0;  // the clock, while drawing
  sc_core::sc_event started_;
  block_counters counters_;
};

}  // namespace racebeam
