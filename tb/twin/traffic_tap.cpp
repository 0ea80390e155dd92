// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/traffic_tap.h"

#include <algorithm>

#include "sc/swap/built_in_plugin.h"

namespace racebeam {

namespace {

constexpr const char* Clock = "clk_i";

std::vector<any_port*> pins_of(const sc_core::sc_module& module) {
  std::vector<any_port*> pins;
  for (any_port* pin : ports_of(module))
    if (pin->port_name() != std::string(Clock)) pins.push_back(pin);
  return pins;
}

}  // namespace

std::vector<PortTraffic::Port> traffic_ports(const sc_core::sc_module& module) {
  std::vector<PortTraffic::Port> ports;
  for (const any_port* pin : pins_of(module))
    ports.push_back({pin->port_name(), pin->bits(), pin->is_input(), pin->is_optional()});
  return ports;
}

/// RTL without logic: what a back door does to it in each clock is written down.
struct TrafficTap::BackDoor : rtl_model {
  const std::string name;
  std::vector<std::string> names;
  std::vector<std::uint64_t> values;  // of the pins; the machine's bytes begin with the lowest
  std::vector<rtl_port> table;
  std::vector<std::uint64_t> heard;  // by clock, then by pin
  const built_in_plugin plugin{[this] { return static_cast<rtl_model*>(this); }};

  BackDoor(const std::string& unit_name, const std::vector<any_port*>& pins)
      : rtl_model{}, name(unit_name), values(pins.size()) {
    for (const any_port* pin : pins) names.emplace_back(pin->port_name());
    for (std::size_t n = 0; n < pins.size(); ++n) {
      const int bits = pins[n]->bits(), bytes = bits <= 8 ? 1 : bits <= 16 ? 2 : bits <= 32 ? 4 : 8;
      table.push_back({names[n].c_str(), bits, bytes, pins[n]->is_input(), &values[n], nullptr, 0});
    }
    unit = name.c_str();
    parameters = remarks = "";
    ports = table.data();
    port_count = static_cast<int>(table.size());
    top = this;
    eval = [](void*) {};
    rise = [](void* self) {
      auto& door = *static_cast<BackDoor*>(self);
      door.heard.insert(door.heard.end(), door.values.begin(), door.values.end());
    };
    destroy = [](rtl_model*) {};  // it is a member
  }
};

TrafficTap::TrafficTap(const std::string& unit, const sc_core::sc_module& module, TrafficSink& sink)
    : sink_(sink),
      pins_(pins_of(module)),
      row_(pins_.size()),
      door_(new BackDoor(unit, pins_)),
      rtl_(new rtl_instance(door_->plugin.name(), unit, pins_, {})) {}

TrafficTap::~TrafficTap() = default;

void TrafficTap::edge() {
  if (wires_.empty())
    for (any_port* pin : pins_) wires_.push_back(pin->contents());
  for (std::size_t n = 0; n < wires_.size(); ++n) row_[n] = wires_[n].value();
  std::copy(row_.begin(), row_.end(), door_->values.begin());  // they stay in their place
  sink_.add(row_.data(), false);
}

void TrafficTap::pass_on() {
  for (std::size_t at = 0; at < door_->heard.size(); at += pins_.size())
    sink_.add(door_->heard.data() + at, true);
  door_->heard.clear();
}

}  // namespace racebeam
