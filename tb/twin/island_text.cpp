// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/island_text.h"

#include <fmt/format.h>

#include <map>
#include <numeric>

#include "sc/swap/rtl_island.h"

namespace racebeam {

namespace {

constexpr const char* IslandClock = "racebeam_clock";

bool drives(const RtlSyntax::Port& port) { return port.direction != "input"; }

/// What wire a port is on, by whether one of the units drives it.
class Wires {
 public:
  explicit Wires(const std::vector<IslandUnit>& units) {
    for (const IslandUnit& unit : units)
      for (const RtlSyntax::Port& port : unit.syntax.ports) {
        if (port.name == unit.syntax.clock) continue;
        Wire& wire = wires_[wire_name(port.name)];
        wire.is_driven |= drives(port);
        wire.is_late &= unit.quiet.count(port.name) != 0;
        if (wire.bits != 0 && wire.bits != port.bits)
          throw RtlError(fmt::format("{} of {} is {} bits wide, and others have it with {}",
                                     port.name, unit.unit, port.bits, wire.bits));
        wire.bits = port.bits;
      }
  }
  /// What a unit has at the port.
  std::string at(const std::string& port) const {
    const auto& named = *wires_.find(wire_name(port));
    return named.second.is_driven || named.second.is_late ? text(named) : held(text(named));
  }
  /// As ports, those that are driven, and those from outside that are late.
  std::string ports() const {
    std::string list;
    for (const auto& named : wires_)
      if (named.second.is_driven || named.second.is_late)
        list += fmt::format(",\n  {} wire [{}:0] {}", named.second.is_driven ? "output" : "input",
                            named.second.bits - 1, text(named));
    return list;
  }
  /// Name and bits of each other wire from outside.
  std::vector<std::pair<std::string, int>> inputs() const {
    std::vector<std::pair<std::string, int>> all;
    for (const auto& named : wires_)
      if (!named.second.is_driven && !named.second.is_late)
        all.emplace_back(text(named), named.second.bits);
    return all;
  }
  static std::string held(const std::string& input) { return input + "_held"; }

 private:
  struct Wire {
    int bits = 0;
    bool is_driven = false;
    bool is_late = true;  // for all that read it
  };
  static std::string text(const std::pair<const std::string, Wire>& named) {
    if (named.second.is_driven) return named.first + "_o";
    return (named.second.is_late ? IslandLate : "") + named.first + "_i";
  }
  std::map<std::string, Wire> wires_;
};

/// A clock that rises with `tick` or with `more`, and falls as soon as all registers have seen it.
std::string pulse(const std::string& clock, const std::string& tick, const std::string& more) {
  return fmt::format(
      "reg {1}_seen = 0;\nwire {0} = ({1} ^ {1}_seen){2};\nalways @(posedge {0}) {1}_seen <= "
      "{1};\n",
      clock, tick, more.empty() ? "" : " | " + more);
}

}  // namespace

std::vector<std::vector<std::size_t>> islands_among(const std::vector<IslandUnit>& units) {
  std::vector<std::size_t> group(units.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::map<std::string, std::size_t> driver;
  for (std::size_t n = 0; n < units.size(); ++n)
    for (const RtlSyntax::Port& port : units[n].syntax.ports)
      if (drives(port)) driver[wire_name(port.name)] = n;
  for (std::size_t n = 0; n < units.size(); ++n)
    for (const RtlSyntax::Port& port : units[n].syntax.ports) {
      const auto from = driver.find(wire_name(port.name));
      if (from == driver.end() || group[from->second] == group[n]) continue;
      const std::size_t old = group[n], now = group[from->second];
      for (std::size_t& one : group)
        if (one == old) one = now;
    }
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t n = 0; n < units.size(); ++n) members[group[n]].push_back(n);
  std::vector<std::vector<std::size_t>> islands;
  for (auto& [key, all] : members)
    if (all.size() > 1) islands.push_back(std::move(all));
  return islands;
}

std::string island_text(const std::vector<IslandUnit>& units) {
  const Wires wires(units);
  std::string ports = fmt::format("\n  input wire {}", IslandTick) + wires.ports();
  std::string body = pulse(IslandClock, IslandTick, "");
  auto inputs = wires.inputs();
  for (const IslandUnit& unit : units) {
    const std::string tick = OwnTick + unit.instance, own = OwnPins + unit.instance;
    const std::string clock = unit.back_door ? unit.instance + "_clock" : IslandClock;
    if (unit.back_door) {
      ports += fmt::format(",\n  input wire {}", tick);
      inputs.emplace_back(own, 1);
      body += pulse(clock, tick, IslandClock);
    }
    std::string parameters, pins;
    for (const std::string& parameter : unit.parameters) {
      const auto equals = parameter.find('=');
      parameters += fmt::format("{}.{}({})", parameters.empty() ? "" : ", ",
                                parameter.substr(0, equals), parameter.substr(equals + 1));
    }
    for (const RtlSyntax::Port& port : unit.syntax.ports) {
      std::string wire = port.name == unit.syntax.clock ? clock : wires.at(port.name);
      if (unit.back_door && port.name != unit.syntax.clock && !drives(port)) {
        const std::string other = own + "_" + port.name;
        inputs.emplace_back(other, port.bits);
        wire = fmt::format("{} ? {} : {}", Wires::held(own), Wires::held(other), wire);
      }
      pins += fmt::format("{}\n  .{}({})", pins.empty() ? "" : ",", port.name, wire);
    }
    body += fmt::format("{} #({}) {} ({});\n", unit.unit, parameters, unit.instance, pins);
  }
  // Verilator evaluates what hangs on an input each time, and what hangs on a register when that
  // changes: so a clock does not pay for inputs that have not moved.
  std::string declared;
  if (!inputs.empty()) ports += fmt::format(",\n  input wire {}", IslandTake);
  for (const auto& [input, bits] : inputs) {
    ports += fmt::format(",\n  input wire [{}:0] {}", bits - 1, input);
    declared +=
        fmt::format("reg [{1}:0] {2} = 0;\nalways @(posedge {3} or negedge {3}) {2} <= {0};\n",
                    input, bits - 1, Wires::held(input), IslandTake);
  }
  return fmt::format("module {} ({});\n{}{}endmodule\n", IslandTop, ports, declared, body);
}

}  // namespace racebeam
