// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/chip_signals.h"

#include <cstring>
#include <set>
#include <type_traits>
#include <utility>

#include "tb/scene/engines.h"

namespace racebeam {

namespace {

constexpr int WidestWire = 64;

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

/// Registers and the like; not the clock again, which RTL has at every level.
void add_inner(std::vector<ChipSignal>& all, std::vector<probe> probes, const std::string& scope,
               std::set<std::string> known) {
  for (probe& one : probes) {
    if (!known.insert(one.name).second) continue;
    const std::string path = scope + "." + one.name;
    const auto dot = path.rfind('.');
    ChipSignal signal{path.substr(0, dot), path.substr(dot + 1), one.bits, {}, std::move(one.read)};
    if (!signal.is_clock()) all.push_back(std::move(signal));
  }
}

void add_wires(std::vector<ChipSignal>& all, const sc_core::sc_module& module) {
  const std::string scope = module.name();
  for (const auto* child : module.get_child_objects())
    if_wire(
        *child,
        [&](int bits, wire_contents wire) {
          all.push_back({scope, child->basename(), bits, wire});
        },
        std::make_integer_sequence<int, WidestWire>());
}

void add_unit(std::vector<ChipSignal>& all, const sc_core::sc_module& unit) {
  const std::string scope = unit.name();
  std::set<std::string> ports;
  for (const any_port* port : ports_of(unit)) {
    ports.insert(port->port_name());
    all.push_back({scope, port->port_name(), port->bits(), port->contents()});
  }
  if (const auto* inside = dynamic_cast<const probed*>(&unit))  // RTL names its ports again
    add_inner(all, inside->probes(), scope, std::move(ports));
}

}  // namespace

std::string scope_of_unit(const std::string& unit) {
  const unit_row* row = engine_of_unit(unit).unit(unit);
  return row ? "chip." + row->path() : "chip";
}

std::vector<ChipSignal> chip_signals(const WiredBench& bench) {
  std::vector<ChipSignal> all;
  add_unit(all, bench.dut());
  add_wires(all, bench.dut());
  for (const auto* module : bench.dut().modules()) {
    add_unit(all, *module);
    add_wires(all, *module);
  }
  for (const Lockstep* lockstep : bench.locksteps())
    add_inner(all, lockstep->probes(), scope_of_unit(lockstep->unit()) + ".rtl", {});
  return all;
}

constexpr int MostStateBits = 16;  // so that its states can be counted

const std::vector<std::string>* state_words(const ChipSignal& signal) {
  if (signal.is_port() || signal.bits > MostStateBits) return nullptr;
  std::string path = signal.path();
  if (const auto rtl = path.find(".rtl."); rtl != std::string::npos) path.erase(rtl, 4);
  for (const engine* one : engines())
    for (const auto& [end, words] : one->states) {
      const std::size_t length = std::strlen(end);
      if (path.size() > length && words.size() == std::size_t{1} << signal.bits &&
          path.compare(path.size() - length, length, end) == 0)
        return &words;
    }
  return nullptr;
}

const ChipSignal& example_of(const std::vector<ChipSignal>& signals) {
  for (const ChipSignal& signal : signals)
    if (state_words(signal)) return signal;
  return signals.back();
}

}  // namespace racebeam
