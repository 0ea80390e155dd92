// tlm_voxel: the voxel tracer with its memories and its frame store as a TLM-2.0 component, loosely
// timed.
//
// What    voxel_machine behind sockets: the same words, counters and clocks as voxel_chip. A host
//         writes colours and columns by host_socket, has rectangles built, and starts; a picture
//         leaves by display_socket when it is drawn; knobs and counters are at register_socket.
//         tlm_voxel_map.h has the addresses.
// Time    as tlm_picture_chip. The status tells when a rectangle is built. The rays are what the
//         host has written when it starts. Colours, columns, rectangles and a start while one is
//         built or a picture is drawn are refused.
// Sockets those of tlm_picture_chip; host_socket: target, 32 bits, b_transport and, to read,
//         transport_dbg. A word takes a clock. No direct memory. Responses: as tlm_chip's; a
//         rectangle beyond the world, or anything too early: a command error.
// Test    tests/voxel/tlm_voxel_test.cpp
// Source  article "Preparation"; docs/virtual-platform.md.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/store/tlm_picture_chip.h"
#include "sc/voxel/voxel_machine.h"

namespace racebeam {

class tlm_voxel : public tlm_picture_chip {
 public:
  tlm_utils::simple_target_socket_optional<tlm_voxel> host_socket{"host_socket"};

  tlm_voxel(const sc_core::sc_module_name& name, const voxel_knobs& k);

  /// Back door.
  const voxel_machine& machine() const { return machine_; }
  /// Of the last picture that was sent.
  const voxel_counters& counters() const { return counters_; }

 private:
  void run();

  const frame_store& store() const override { return machine_.store(); }
  void advance(std::int64_t clock) override;
  drawn picture() const override {
    return {knobs_.picture_width, knobs_.picture_height, machine_.picture()};
  }
  word read_register(std::uint64_t address) const override;
  bool writable(std::uint64_t) const override { return false; }
  void write_register(std::uint64_t, std::uint32_t) override {}

  void access_host(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  /// Whether it was taken.
  bool write_host(std::uint64_t address, std::uint32_t value);
  bool build();
  word read_host(std::uint64_t address) const;
  unsigned peek_host(tlm::tlm_generic_payload& payload);
  /// A register of the view; nullptr: none is there.
  const int* register_of_view(std::uint64_t address) const;
  /// It builds, or a picture is drawn.
  bool works() const { return drawing_ || seen_ < built_; }

  const voxel_knobs knobs_;
  voxel_machine machine_;
  voxel_view view_;
  std::uint32_t low_ = 0, high_ = 0;  // of the rectangle
  std::int64_t seen_ = 0;             // the clock, which is behind the machine's while it works
  std::int64_t built_ = 0;            // the clock in which the builder is done
  sc_core::sc_event started_;
  voxel_counters counters_;
};

}  // namespace racebeam
