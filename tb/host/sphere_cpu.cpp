// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/sphere_cpu.h"

#include <string>

#include "sc/base/tlm_words.h"

namespace racebeam {

SphereCpu::SphereCpu(const sc_core::sc_module_name& name, SphereWires& wires, SphereMotion motion,
                     std::function<sc_core::sc_time()> pause)
    : sc_module(name), wires_(wires), motion_(std::move(motion)), pause_(std::move(pause)) {
  SC_HAS_PROCESS(SphereCpu);
  SC_THREAD(run);
}

void SphereCpu::write(std::uint64_t address, int value) {
  wait(pause_());
  wires_.write(address, static_cast<std::uint32_t>(value));
}

std::uint32_t SphereCpu::read(std::uint64_t address) {
  wait(pause_());
  return wires_.read(address);
}

void SphereCpu::run() {
  for (;; ++pictures_) {
    while (!read(SphereHostDone)) {
    }
    table_ = motion_.table();
    send();
    motion_.picture(static_cast<int>(read(SphereHostRotz)));
    while (read(SphereHostDone)) {
    }
  }
}

// Each entry by an edge of `valid`; the last one is the light, which the tracer knows.
void SphereCpu::send() {
  const int number = static_cast<int>(table_.size());
  if (number == 0) write(SphereHostSphere, 0);
  for (int n = 0; n < number; ++n) {
    const sphere_row& s = table_[static_cast<std::size_t>(n)];
    write(SphereHostSphere, number << 4 | n);
    write(SphereHostColor, s.color_word());
    write(SphereHostX1, s.centre[0]);
    write(SphereHostY1, s.centre[1]);
    write(SphereHostZ1, s.centre[2]);
    write(SphereHostReflect, s.reflect);
    write(SphereHostRadius, s.radius);
    write(SphereHostR2, s.radius2);
    write(SphereHostRInv, s.inverse);
    write(SphereHostValid, 1);
    write(SphereHostValid, 0);
  }
  write(SphereHostValid, 1);
  write(SphereHostValid, 0);
}

void SphereSocketWires::access(tlm::tlm_command command, std::uint64_t address,
                               std::uint8_t* data) {
  prepare_write(payload_, address, data, WordBytes);
  payload_.set_command(command);
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  socket->b_transport(payload_, delay);
  if (payload_.is_response_error())
    SC_REPORT_ERROR("racebeam/sphere_cpu", ("address " + std::to_string(address) + " is answered " +
                                            payload_.get_response_string())
                                               .c_str());
  wait(delay);
}

void SphereSocketWires::write(std::uint64_t address, std::uint32_t value) {
  std::uint8_t bytes[WordBytes];
  put_word(bytes, value);
  access(tlm::TLM_WRITE_COMMAND, address, bytes);
}

std::uint32_t SphereSocketWires::read(std::uint64_t address) {
  std::uint8_t bytes[WordBytes] = {};
  access(tlm::TLM_READ_COMMAND, address, bytes);
  return get_word(bytes);
}

}  // namespace racebeam
