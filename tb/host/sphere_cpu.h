// SphereCpu: the CPU beside the sphere tracer as a process of SystemC: waits for `done`, moves the
// spheres, and sends the table, word by word, for picture after picture.
//
// It knows the addresses of tlm_sphere_map.h and nothing of what carries them: a TLM socket, or
// pins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <cstdint>
#include <functional>
#include <systemc>
#include <tlm>
#include <utility>
#include <vector>

#include "sc/sphere/tlm_sphere_map.h"
#include "tb/host/sphere_motion.h"

namespace racebeam {

/// What the CPU's words go through. Calls may last.
class SphereWires {
 public:
  virtual ~SphereWires() = default;
  virtual void write(std::uint64_t address, std::uint32_t value) = 0;
  virtual std::uint32_t read(std::uint64_t address) = 0;
};

class SphereCpu : public sc_core::sc_module {
 public:
  /// `pause`: the time from each word to the next. `wires` must outlive it.
  SphereCpu(const sc_core::sc_module_name& name, SphereWires& wires, SphereMotion motion,
            std::function<sc_core::sc_time()> pause);

  /// Pictures whose table was sent.
  int pictures() const { return pictures_; }
  const SphereMotion& motion() const { return motion_; }

 private:
  void run();
  void write(std::uint64_t address, int value);
  std::uint32_t read(std::uint64_t address);
  void send();

  SphereWires& wires_;
  SphereMotion motion_;
  std::vector<sphere_row> table_;  // that is being sent: a process may be ended in the middle
  std::function<sc_core::sc_time()> pause_;
  int pictures_ = 0;
};

/// Over a TLM-2.0 socket, as to tlm_sphere's host_socket. A response that is not OK is a SystemC
/// error.
class SphereSocketWires : public sc_core::sc_module, public SphereWires {
 public:
  tlm_utils::simple_initiator_socket<SphereSocketWires> socket{"socket"};

  explicit SphereSocketWires(const sc_core::sc_module_name& name) : sc_module(name) {}
  void write(std::uint64_t address, std::uint32_t value) override;
  std::uint32_t read(std::uint64_t address) override;

 private:
  void access(tlm::tlm_command command, std::uint64_t address, std::uint8_t* data);

  tlm::tlm_generic_payload payload_;
};

}  // namespace racebeam
