// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_island.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <utility>

#include "sc/swap/rtl_remarks.h"
#include "sc/swap/wire_place.h"

namespace racebeam {

namespace {

constexpr const char* Clock = "clk_i";
constexpr std::uint64_t Checked = 256;  // edges, of which one looks whether late inputs are

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// The machine's bytes begin with the lowest.
void write(const rtl_port& port, std::uint64_t value) {
  const std::uint64_t raw = raw_bits(value, port.bits);
  std::memcpy(port.data, &raw, static_cast<std::size_t>(port.bytes));
}

/// The event of a rising edge, which a signal has from when somebody asks for it.
struct rising_event : sc_core::sc_signal<bool, sc_core::SC_UNCHECKED_WRITERS> {
  static constexpr auto of = &rising_event::m_posedge_event_p;
};

/// The channel of a bound port.
const sc_core::sc_object* channel_of(const any_port& pin) {
  const auto* port = dynamic_cast<const sc_core::sc_port_base*>(&pin);
  return dynamic_cast<const sc_core::sc_object*>(port->get_interface());
}

/// The clock of all; not every unit has it.
in_port<1>& clock_of(const std::vector<island_unit*>& units) {
  for (const island_unit* unit : units)
    for (any_port* pin : ports_of(unit->module()))
      if (pin->port_name() == std::string(Clock)) return dynamic_cast<in_port<1>&>(*pin);
  throw RtlError(units.at(0)->plugin() + " has no unit with a clock");
}

}  // namespace

std::string wire_name(const std::string& port) {
  for (const char* suffix : {"_i", "_o"})
    if (ends_with(port, suffix)) return port.substr(0, port.size() - 2);
  for (const char* suffix : {"_ni", "_no"})
    if (ends_with(port, suffix)) return port.substr(0, port.size() - 1);
  return port;
}

rtl_island::rtl_island(const std::string& name, const std::vector<island_unit*>& units)
    : sc_prim_channel(name.c_str()), library_(units.at(0)->plugin()), units_(units) {
  join(units);
  sc_core::sc_spawn_options on_inputs, on_edge;
  for (auto* process : {&on_inputs, &on_edge}) process->spawn_method();
  on_inputs.set_sensitivity(&moved_event_);
  sc_core::sc_spawn([this] { comb(); }, (name + "_comb").c_str(), &on_inputs);
  on_edge.dont_initialize();
  on_edge.set_sensitivity(&clock_of(units).pos());
  sc_core::sc_spawn([this] { seq(); }, (name + "_seq").c_str(), &on_edge);
}

// Of the inputs that read one wire the first one stands for all.
void rtl_island::join(const std::vector<island_unit*>& units) {
  std::map<std::string, any_port*> readers, drivers;
  for (const island_unit* unit : units)
    for (any_port* pin : ports_of(unit->module())) {
      const std::string port = pin->port_name();
      if (port == Clock) continue;
      auto& side = pin->is_input() ? readers : drivers;
      side.emplace(wire_name(port), pin);
    }
  const rtl_model& model = library_.model();
  for (int n = 0; n < model.port_count; ++n) {
    const rtl_port& port = model.ports[n];
    const std::string name = port.name;
    if (name == IslandTick || name.rfind(IslandTake, 0) == 0 || name.rfind(OwnTick, 0) == 0 ||
        name.rfind(OwnPins, 0) == 0)
      continue;
    const bool late = port.is_input && name.rfind(IslandLate, 0) == 0;
    const std::size_t from = port.is_input ? name.find('_') + 1 : 0;
    const auto& side = port.is_input ? readers : drivers;
    const auto at = side.find(name.substr(from, name.size() - 2 - from));
    if (at == side.end() || at->second->bits() != port.bits)
      throw RtlError(units.at(0)->plugin() + " is made of other units: " + name + " is not theirs");
    if (port.is_input) (late ? late_ : inputs_).push_back({at->second, &port});
    else outputs_.push_back({at->second, &port});
  }
}

// A wire is inner if it lies in the chip, and all that reads it is in the island.
void rtl_island::find_wires() {
  std::set<std::string> inside;
  for (const island_unit* unit : units_) inside.insert(unit->module().name());
  const sc_core::sc_object* chip = units_.at(0)->module().get_parent_object();
  std::set<const void*> read_outside;
  for (const sc_core::sc_object* child : chip->get_child_objects()) {
    const auto* module = dynamic_cast<const sc_core::sc_module*>(child);
    if (!module || inside.count(module->name()) != 0) continue;
    for (const any_port* pin : ports_of(*module))
      if (pin->is_input()) read_outside.insert(place_of(pin->contents()));
  }
  std::map<std::string, const void*> by_name;
  for (auto* side : {&inputs_, &late_})
    for (const input& in : *side) {
      wires_.follow(*in.pin, *in.rtl, &moved_event_);
      by_name[wire_name(in.pin->port_name())] = place_of(in.pin->contents());
    }
  for (output& out : outputs_) {
    out.wire = out.pin->contents();
    by_name[wire_name(out.pin->port_name())] = place_of(out.wire);
    const sc_core::sc_object* channel = channel_of(*out.pin);
    out.is_inner = channel && channel->get_parent_object() == chip &&
                   read_outside.count(place_of(out.wire)) == 0;
    out.rises = dynamic_cast<const racebeam::wire<1>*>(channel);
  }
  for (const island_unit* unit : units_)
    for (const any_port* pin : ports_of(unit->module())) {
      const auto at = by_name.find(wire_name(pin->port_name()));
      if (at != by_name.end() && at->second != place_of(pin->contents()))
        throw RtlError(std::string(pin->port_name()) + " of " + unit->module().name() +
                       " is wired to what is named otherwise; use this unit's RTL without others");
    }
  std::vector<const rtl_port*> ports;
  for (const output& out : outputs_) {
    ports.push_back(out.rtl);
    driven_.push_back(out.is_inner ? nullptr : &wire_of(*out.pin));
  }
  changes_ = changed_ports(ports);
  bound_ = true;
}

/// Whether an input has moved.
bool rtl_island::settle() {
  const bool first = !std::exchange(settled_, true);
  if (first && !bound_) find_wires();
  const bool moved = wires_.prompt_moved() || first;
  followed_ |= moved;
  if (moved) rest_.end();
  if (moved && due_) library_.rise_and_eval();
  else if (moved && !first) library_.eval_moved();
  else if (moved) library_.eval();
  else if (due_) library_.rise();
  return moved;
}

// Its wires have what the other inputs have made of them.
void rtl_island::check_late() {
  library_.eval();
  changes_.visit([this](std::size_t n, std::uint64_t) {
    tell_not_quiet(library_.model(), outputs_[n].rtl->name);
  });
}

void rtl_island::comb() {
  bool moved = settle();
  if (!moved && !due_) return;
  moved |= drive();
  show();
  if (std::exchange(due_, false)) rest_.look(library_.model(), moved);
}

// At the edge others still read what the wires had before it.
void rtl_island::seq() {
  if (rest_.now()) {
    if (!wires_.quiet_moved()) return library_.pass();
    rest_.end();
  }
  if (wires_.quiet_moved()) library_.copy_quiet();
  if (++edges_ % Checked == 0 && !late_.empty()) check_late();
  due_ = std::exchange(followed_, false) && library_.can_rise_and_eval();
  if (due_) return moved_event_.notify(sc_core::SC_ZERO_TIME);
  library_.rise();
  rest_.look(library_.model(), drive());
  if (!to_show_.empty()) request_update();
}

void rtl_island::update() { show(); }

/// Outer wires; inner ones are to be shown. Whether an output has moved.
bool rtl_island::drive() {
  return changes_.visit([this](std::size_t n, std::uint64_t value) {
    if (any_wire* wire = driven_[n]) wire->drive(value);
    else to_show_.emplace_back(n, value);
  });
}

void rtl_island::show() {
  for (const auto& [n, value] : to_show_) {
    const output& out = outputs_[n];
    put(out.wire, value);
    if (!value || !out.rises) continue;
    if (sc_core::sc_event* rises = out.rises->*rising_event::of)
      rises->notify(sc_core::SC_ZERO_TIME);
  }
  to_show_.clear();
}

std::vector<probe> rtl_island::probes(const std::string& instance) const {
  const std::string above = instance + ".";
  std::vector<probe> all;
  for (int n = 0; n < library_.model().signal_count; ++n) {
    const rtl_port& signal = library_.model().signals[n];
    const std::string name = signal.name;
    if (name.rfind(above, 0) == 0)
      all.push_back(
          {name.substr(above.size()), signal.bits, [&signal] { return port_value(signal); }});
  }
  return all;
}

void rtl_island::private_edges(const std::string& instance, const input_values& inputs, int edges) {
  const rtl_model& model = library_.model();
  settle();
  for (const island_unit* unit : units_) {
    if (unit->module().basename() != instance) continue;
    for (const any_port* pin : ports_of(unit->module())) {
      const std::string own = OwnPins + instance + "_" + pin->port_name();
      if (pin->is_input() && has_rtl_port(model, own))
        write(rtl_port_of(model, own), pin->contents().value());
    }
  }
  for (const auto& [port, value] : inputs)
    write(rtl_port_of(model, OwnPins + instance + "_" + port), static_cast<std::uint64_t>(value));
  const rtl_port& own = rtl_port_of(model, OwnPins + instance);
  const rtl_port& tick = rtl_port_of(model, OwnTick + instance);
  write(own, 1);
  library_.eval();
  for (; edges > 0; --edges) {
    write(tick, port_value(tick) ^ 1);
    library_.eval();
  }
  write(own, 0);
  library_.eval();
  rest_.end();
  drive();
  show();
}

std::vector<std::unique_ptr<rtl_island>> islands_of(const sc_core::sc_module& chip) {
  std::map<std::string, std::vector<island_unit*>> by_plugin;
  for (sc_core::sc_object* child : chip.get_child_objects())
    if (auto* unit = dynamic_cast<island_unit*>(child)) by_plugin[unit->plugin()].push_back(unit);
  std::vector<std::unique_ptr<rtl_island>> islands;
  for (const auto& [plugin, units] : by_plugin) {
    islands.push_back(
        std::make_unique<rtl_island>("island_" + std::to_string(islands.size()), units));
    for (island_unit* unit : units) unit->join(*islands.back());
  }
  return islands;
}

}  // namespace racebeam
