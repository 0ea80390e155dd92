// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_instance.h"

#include <cstdint>
#include <cstring>
#include <utility>

#include "sc/swap/rtl_remarks.h"

namespace racebeam {

namespace {

constexpr const char* Clock = "clk_i";
constexpr std::uint64_t Checked = 256;  // edges, of which one looks whether quiet inputs are

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
  std::vector<const rtl_port*> driven;
  for (any_port* pin : pins) {
    if (!has_rtl_port(model(), pin->port_name())) continue;
    const rtl_port& rtl = rtl_port_of(model(), pin->port_name());
    if (pin->port_name() == std::string(Clock)) continue;
    if (pin->is_input()) {
      inputs_.push_back({pin, value(rtl)});
      continue;
    }
    outputs_.push_back({pin, value(rtl)});
    driven.push_back(&rtl);
  }
  changes_ = changed_ports(driven);
  has_quiet_ = !quiet_inputs_of(model()).empty();
  std::string other;
  for (const rtl_parameter& parameter : other_parameters(built_parameters(model()), wanted))
    other += " " + parameter.name + "=" + std::to_string(parameter.value);
  if (!other.empty())
    throw RtlError(plugin + " was built with other parameters; build it with" + other);
}

std::uint64_t rtl_instance::value::read() const { return port_value(*port_); }

void rtl_instance::value::write(std::uint64_t value) const {
  const std::uint64_t raw = raw_bits(value, port_->bits);
  switch (port_->bytes) {
    case 1: *static_cast<std::uint8_t*>(port_->data) = static_cast<std::uint8_t>(raw); break;
    case 2: *static_cast<std::uint16_t*>(port_->data) = static_cast<std::uint16_t>(raw); break;
    case 4: *static_cast<std::uint32_t*>(port_->data) = static_cast<std::uint32_t>(raw); break;
    default: *static_cast<std::uint64_t*>(port_->data) = raw;
  }
}

/// Nothing is known of the inputs yet, or no more.
void rtl_instance::begin(sc_core::sc_event* moved) {
  settled_ = true;
  if (!std::exchange(bound_, true)) {
    for (joint& out : outputs_) {
      out.wire = out.pin->contents();
      driven_.push_back(&wire_of(*out.pin));
    }
    for (joint& in : inputs_) {
      in.wire = in.pin->contents();
      wires_.follow(*in.pin, rtl_port_of(model(), in.rtl.name()), moved);
    }
  } else {
    wires_.take_all();
  }
}

void rtl_instance::settle() {
  bool moved = !settled_;
  if (moved) begin(nullptr);
  moved |= wires_.prompt_moved();
  if (wires_.quiet_moved()) {
    library_.copy_quiet();
    moved = true;
  }
  if (moved) library_.eval();
}

void rtl_instance::edge() { library_.rise(); }

void rtl_instance::follow() {
  const bool first = !settled_;
  if (first) {
    begin(&moved_);
    library_.copy_quiet();
  }
  const bool moved = wires_.prompt_moved() || first;
  followed_ |= moved;
  if (moved) rest_.end();
  if (std::exchange(due_, false)) {
    if (moved) library_.rise_and_eval();
    else library_.rise();
    rest_.look(model(), drive() || moved);
  } else if (moved) {
    if (first) library_.eval();
    else library_.eval_moved();
    drive();
  }
}

void rtl_instance::clock() {
  if (rest_.now()) {
    if (!wires_.quiet_moved()) return library_.pass();
    rest_.end();
  }
  if (wires_.quiet_moved()) library_.copy_quiet();
  if (++edges_ % Checked == 0 && has_quiet_) check_quiet();
  due_ = std::exchange(followed_, false) && library_.can_rise_and_eval();
  if (due_) return moved_.notify(sc_core::SC_ZERO_TIME);
  library_.rise();
  rest_.look(model(), drive());
}

// Its outputs drive what the other inputs have made of them.
void rtl_instance::check_quiet() {
  library_.eval();
  changes_.visit(
      [this](std::size_t n, std::uint64_t) { tell_not_quiet(model(), outputs_[n].rtl.name()); });
}

/// Whether an output has moved.
bool rtl_instance::drive() {
  return changes_.visit([this](std::size_t n, std::uint64_t value) { driven_[n]->drive(value); });
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
  library_.eval();
  for (; edges > 0; --edges) library_.rise();
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
  settled_ = false;
}

rtl_instance::value rtl_instance::port(const std::string& name) const {
  return value(rtl_port_of(model(), name));
}

}  // namespace racebeam
