// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/signal_trace.h"

#include <fnmatch.h>

#include <algorithm>
#include <set>
#include <type_traits>
#include <utility>

#include "tb/errors.h"

namespace racebeam {

namespace {

constexpr const char* Clock = "clk_i";
constexpr int WidestWire = 32;
constexpr int FirstColumn = -320;  // position of the first visible pixel

/// Words for the values of registers that hold a state.
const std::vector<std::string>* words_of(std::string path) {
  static const std::map<std::string, std::vector<std::string>> all = {
      {"u_subdivider.state_q", {"left", "right", "bisect", "return"}},
      {"u_camera_unit.phase_q", {"product", "load", "scale", "run"}},
      {"u_navigator.nav_state_q",
       {"idle", "to_plus", "check_plus", "check_minus", "finish", "store", "adjust", "7",
        "try_plus", "try_done", "try_check_plus", "try_check_minus", "try_next", "13", "14",
        "15"}}};
  if (const auto rtl = path.find(".rtl."); rtl != std::string::npos) path.erase(rtl, 4);
  for (const auto& [end, words] : all)
    if (path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0)
      return &words;
  return nullptr;
}

std::pair<std::string, std::string> scope_and_name(const std::string& path) {
  const auto dot = path.rfind('.');
  return {path.substr(0, dot), path.substr(dot + 1)};
}

/// Calls found(bits, contents) if `object` is a wire.
template <class Found, int... Bits>
void if_wire(const sc_core::sc_object& object, const Found& found,
             std::integer_sequence<int, Bits...>) {
  const auto as = [&](auto* signal, int bits) {
    if (!signal) return;
    const auto& value = signal->read();
    if constexpr (std::is_same_v<decltype(value), const bool&>)
      found(bits, wire_contents{&value, nullptr});
    else found(bits, wire_contents{nullptr, &value});
  };
  (as(dynamic_cast<const wire<Bits + 1>*>(&object), Bits + 1), ...);
}

}  // namespace

bool TraceSelection::takes(const std::string& path) const {
  if (depth > 0 && std::count(path.begin(), path.end(), '.') > depth) return false;
  return scopes.empty() || std::any_of(scopes.begin(), scopes.end(), [&](const auto& pattern) {
           return fnmatch(pattern.c_str(), path.c_str(), 0) == 0 ||
                  fnmatch((pattern + ".*").c_str(), path.c_str(), 0) == 0;
         });
}

SignalTrace::SignalTrace(SignalBench& bench, const Raster& raster, int period_ps,
                         const TraceSelection& selection, std::function<std::string(int)> part,
                         VcdWriter& vcd)
    : bench_(bench),
      raster_(raster),
      period_(static_cast<std::uint64_t>(period_ps)),
      selection_(selection),
      part_(std::move(part)),
      vcd_(vcd) {
  add_beam();
  const std::size_t virtual_ones = vcd_.names().size();
  add_chip(bench.dut());
  for (const Lockstep* lockstep : bench.locksteps()) {
    const std::string unit = lockstep->unit();
    add_probes(lockstep->probes(),
               unit == WholeChip ? "chip.rtl" : "chip." + instance_of(unit) + ".rtl");
  }
  if (vcd_.names().size() == virtual_ones)
    throw UsageError(
        "no signal is under --scope and --depth; names look like chip.u_subdivider.i1_q: try "
        "--scope 'chip.u_subdivider', or '*_q'");
}

void SignalTrace::add_beam() {
  frame_ = vcd_.add("beam", "frame", FrameBits);
  line_ = vcd_.add("beam", "line", 10);
  pixel_ = vcd_.add("beam", "pixel", 11);
  clock_ = vcd_.add("beam", "clock", count_bits(raster_.line_clocks()));
  show_ = vcd_.add_text("beam", "part");
  clk_ = vcd_.add("beam", Clock, 1);
}

void SignalTrace::add_chip(const sc_core::sc_module& chip) {
  add_unit(chip, "chip");
  for (const auto* child : chip.get_child_objects()) {
    if_wire(
        *child,
        [&](int bits, wire_contents wire) { add_wire("chip", child->basename(), bits, wire); },
        std::make_integer_sequence<int, WidestWire>());
  }
  for (const auto* child : chip.get_child_objects())
    if (const auto* unit = dynamic_cast<const sc_core::sc_module*>(child))
      add_unit(*unit, std::string("chip.") + unit->basename());
}

void SignalTrace::add_unit(const sc_core::sc_module& unit, const std::string& scope) {
  std::set<std::string> ports;
  for (const any_port* port : ports_of(unit)) {
    ports.insert(port->port_name());
    add_wire(scope, port->port_name(), port->bits(), port->contents());
  }
  const auto* inside = dynamic_cast<const probed*>(&unit);
  if (!inside) return;
  std::vector<probe> others;
  for (probe& one : inside->probes())  // RTL has its ports among its signals
    if (!ports.count(one.name)) others.push_back(std::move(one));
  add_probes(others, scope);
}

void SignalTrace::add_probes(const std::vector<probe>& probes, const std::string& scope) {
  std::set<std::string> seen;
  for (const probe& one : probes) {
    const bool is_clock = scope_and_name("." + one.name).second == Clock;
    if (!is_clock && seen.insert(one.name).second)
      add_reading(scope + "." + one.name, one.bits, one.read);
  }
}

void SignalTrace::add_wire(const std::string& scope, const std::string& name, int bits,
                           wire_contents wire) {
  if (!selection_.takes(scope + "." + name)) return;
  if (name == Clock) return vcd_.alias(scope, name, clk_);
  const void* carrier = wire.bit ? static_cast<const void*>(wire.bit) : wire.word;
  if (const auto known = wires_.find(carrier); known != wires_.end())
    return vcd_.alias(scope, name, known->second);
  const int signal = vcd_.add(scope, name, bits);
  wires_[carrier] = signal;
  readings_.push_back(
      {signal, [wire] { return static_cast<std::uint64_t>(wire.value()); }, None, nullptr});
}

void SignalTrace::add_reading(const std::string& path, int bits,
                              std::function<std::uint64_t()> read) {
  if (!selection_.takes(path)) return;
  const auto [scope, name] = scope_and_name(path);
  const auto* words = words_of(path);
  const int word = words ? vcd_.add_text(scope, name + "_name") : None;
  readings_.push_back({vcd_.add(scope, name, bits), std::move(read), word, words});
}

void SignalTrace::sample(const TracePoint& at) {
  bench_.settle();
  const auto time = static_cast<std::uint64_t>(at.ordinal(raster_)) * period_;
  const int position = raster_.clocks[static_cast<std::size_t>(at.clock)].position;
  const auto raw = [](int value, int bits) {
    return static_cast<std::uint64_t>(value & low_bits(bits));
  };
  vcd_.change(time, clk_, 1);
  vcd_.change(time, frame_, raw(at.frame, FrameBits));
  vcd_.change(time, line_, raw(at.line, 10));
  vcd_.change(time, pixel_, raw(position - FirstColumn, 11));
  vcd_.change(time, clock_, raw(at.clock, 31));
  if (at.frame != shown_) vcd_.change(time, show_, part_(shown_ = at.frame));
  for (const Reading& one : readings_) {
    const std::uint64_t value = one.read();
    vcd_.change(time, one.signal, value);
    if (one.word != None) vcd_.change(time, one.word, one.words->at(value));
  }
  vcd_.change(time + period_ / 2, clk_, 0);
}

}  // namespace racebeam
