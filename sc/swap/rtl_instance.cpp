// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_instance.h"

#include <cstdint>
#include <cstring>

namespace racebeam {

namespace {

constexpr const char* Clock = "clk_i";

}  // namespace

rtl_instance::rtl_instance(const std::string& plugin, const std::string& unit,
                           const std::vector<any_port*>& pins,
                           const std::vector<rtl_parameter>& wanted)
    : library_(plugin) {
  if (unit != model().unit)
    throw RtlError(plugin + " holds the unit " + model().unit + ", not " + unit);
  std::vector<rtl_pin> ports;
  for (const any_port* pin : pins)
    ports.push_back({pin->port_name(), pin->is_input(), pin->bits(), pin->is_optional()});
  const std::string faults = port_faults(model(), ports);
  if (!faults.empty())
    throw RtlError(rtl_place(model()) + ": this does not fit the unit " + unit + "; " + unit +
                   ".h below sc/ has its ports:" + faults);
  for (any_port* pin : pins) {
    if (!has_rtl_port(model(), pin->port_name())) continue;
    const rtl_port& rtl = rtl_port_of(model(), pin->port_name());
    if (pin->port_name() == std::string(Clock)) continue;
    if (pin->is_input()) {
      inputs_.push_back({pin, value(rtl)});
      continue;
    }
    outputs_.push_back({pin, value(rtl)});
    auto& alike = rtl.bytes == 1   ? bytes_
                  : rtl.bytes == 2 ? halves_
                  : rtl.bytes == 4 ? words_
                                   : doubles_;
    alike.push_back({rtl.data, 0, pin});
  }
  forget_inputs();
  std::string other;
  for (const rtl_parameter& parameter : other_parameters(built_parameters(model()), wanted))
    other += " " + parameter.name + "=" + std::to_string(parameter.value);
  if (!other.empty())
    throw RtlError(plugin + " was built with other parameters; build it with" + other);
}

std::uint64_t rtl_instance::value::read() const {
  switch (port_->bytes) {
    case 1: return *static_cast<const std::uint8_t*>(port_->data);
    case 2: return *static_cast<const std::uint16_t*>(port_->data);
    case 4: return *static_cast<const std::uint32_t*>(port_->data);
    default: return *static_cast<const std::uint64_t*>(port_->data);
  }
}

void rtl_instance::value::write(std::uint64_t value) const {
  const std::uint64_t raw = raw_bits(value, port_->bits);
  switch (port_->bytes) {
    case 1: *static_cast<std::uint8_t*>(port_->data) = static_cast<std::uint8_t>(raw); break;
    case 2: *static_cast<std::uint16_t*>(port_->data) = static_cast<std::uint16_t>(raw); break;
    case 4: *static_cast<std::uint32_t*>(port_->data) = static_cast<std::uint32_t>(raw); break;
    default: *static_cast<std::uint64_t*>(port_->data) = raw;
  }
}

void rtl_instance::settle() {
  bool moved = !settled_;
  if (!bound_)
    for (auto* side : {&inputs_, &outputs_})
      for (joint& port : *side) port.wire = port.pin->contents();
  bound_ = settled_ = true;
  for (joint& in : inputs_) {
    const std::uint64_t now = in.wire.value();
    if (now == in.last) continue;
    in.last = now;
    in.rtl.write(now);
    moved = true;
  }
  if (moved) library_.eval();
}

void rtl_instance::edge() { library_.rise(); }

template <class Raw>
void rtl_instance::drive(std::vector<driven>& outputs) {
  for (driven& out : outputs) {
    const std::uint64_t now = *static_cast<const Raw*>(out.data);
    if (now == out.last) continue;
    out.last = now;
    out.pin->drive_wire(now);
  }
}

void rtl_instance::drive() {
  drive<std::uint8_t>(bytes_);
  drive<std::uint16_t>(halves_);
  drive<std::uint32_t>(words_);
  drive<std::uint64_t>(doubles_);
}

void rtl_instance::seek(int frame) {
  seek_frame([this](const input_values& in, int edges) { private_edges(in, edges); }, frame);
}

void rtl_instance::place(const vec3& position, int room) {
  place_camera([this](const input_values& in, int edges) { private_edges(in, edges); }, position,
               room);
}

void rtl_instance::private_edges(const input_values& inputs, int edges) {
  for (const auto& [name, value] : inputs) port(name).write(static_cast<std::uint64_t>(value));
  for (; edges > 0; --edges) edge();
  forget_inputs();
}

// They have other values than the wires, or others follow from them: the next settle() sees to it.
void rtl_instance::forget_inputs() {
  for (joint& in : inputs_) in.last = in.rtl.read();
  settled_ = false;
}

rtl_instance::value rtl_instance::signal(const std::string& name) const {
  for (int n = 0; n < model().signal_count; ++n)
    if (name == model().signals[n].name) return value(model().signals[n]);
  throw RtlError(std::string("there is no signal ") + name + " in " + model().unit);
}

std::vector<probe> rtl_instance::probes() const {
  std::vector<probe> all;
  for (int n = 0; n < model().signal_count; ++n) {
    const rtl_port& signal = model().signals[n];
    all.push_back({signal.name, signal.bits, [&signal] {
                     std::uint64_t bits = 0;  // the machine's bytes begin with the lowest
                     std::memcpy(&bits, signal.data, static_cast<std::size_t>(signal.bytes));
                     return bits;
                   }});
  }
  return all;
}

void rtl_instance::deposit(const std::string& name, std::uint64_t value) {
  signal(name).write(value);
  forget_inputs();
}

rtl_instance::value rtl_instance::port(const std::string& name) const {
  return value(rtl_port_of(model(), name));
}

}  // namespace racebeam
