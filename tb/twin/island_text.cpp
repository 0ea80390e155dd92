// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/island_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "sc/swap/rtl_island.h"
#include "tb/verilate/clock_wrapper.h"

namespace racebeam {

namespace {

constexpr const char* IslandClock = "racebeam_clock";

bool drives(const RtlSyntax::Port& port) { return port.direction != "input"; }

/// From outside, and held.
struct Input {
  std::string name;
  int bits, group;
};

/// What wire a port is on, by whether one of the units drives it.
class Wires {
 public:
  explicit Wires(const std::vector<IslandUnit>& units) {
    JoinedNames joined;  // wires, and groups as UNIT.N
    for (const IslandUnit& unit : units)
      for (const RtlSyntax::Port& port : unit.syntax.ports) {
        if (port.name == unit.syntax.clock) continue;
        Wire& wire = wires_[wire_name(port.name)];
        (drives(port) ? wire.is_driven : wire.is_read) = true;
        if (const auto at = unit.groups.find(port.name); at != unit.groups.end()) {
          wire.is_late = false;
          joined.join(wire_name(port.name), unit.unit + "." + std::to_string(at->second));
        }
        if (wire.bits != 0 && wire.bits != port.bits)
          throw RtlError(fmt::format("{} of {} is {} bits wide, and others have it with {}",
                                     port.name, unit.unit, port.bits, wire.bits));
        wire.bits = port.bits;
      }
    const CombGroups groups = joined.groups();
    std::map<int, int> numbers;
    for (auto& [name, wire] : wires_)
      if (!wire.is_driven && !wire.is_late)
        wire.group =
            numbers.emplace(groups.at(name), std::min(group_count(), MostGroups - 1)).first->second;
  }
  /// What a unit has at the port.
  std::string at(const std::string& port) const {
    const auto& named = *wires_.find(wire_name(port));
    return named.second.is_driven || named.second.is_late ? text(named) : held(text(named));
  }
  /// As ports, those from outside that are late, and those that are driven, what none of the units
  /// reads apart from the rest: who looks at outputs together finds them side by side.
  std::string ports() const {
    std::string late, shown, inner;
    for (const auto& named : wires_) {
      const Wire& wire = named.second;
      if (!wire.is_driven && !wire.is_late) continue;
      (!wire.is_driven ? late
       : wire.is_read  ? inner
                       : shown) +=
          fmt::format(",\n  {} wire [{}:0] {}", wire.is_driven ? "output" : "input", wire.bits - 1,
                      text(named));
    }
    return late + shown + inner;
  }
  /// Each other wire from outside.
  std::vector<Input> inputs() const {
    std::vector<Input> all;
    for (const auto& named : wires_)
      if (!named.second.is_driven && !named.second.is_late)
        all.push_back({text(named), named.second.bits, named.second.group});
    return all;
  }
  int group_count() const {
    int count = 0;
    for (const auto& [name, wire] : wires_) count = std::max(count, wire.group + 1);
    return count;
  }
  static std::string held(const std::string& input) { return input + "_held"; }

 private:
  struct Wire {
    int bits = 0;
    bool is_driven = false, is_read = false;
    bool is_late = true;  // for all that read it
    int group = -1;       // of one that is held
  };
  static std::string text(const std::pair<const std::string, Wire>& named) {
    if (named.second.is_driven) return named.first + "_o";
    return (named.second.is_late ? IslandLate
                                 : fmt::format("{}{}_", IslandGroup, named.second.group)) +
           named.first + "_i";
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
  const int own_group = wires.group_count();
  for (const IslandUnit& unit : units) {
    const std::string tick = OwnTick + unit.instance, own = OwnPins + unit.instance;
    const std::string clock = unit.back_door ? unit.instance + "_clock" : IslandClock;
    if (unit.back_door) {
      ports += fmt::format(",\n  input wire {}", tick);
      inputs.push_back({own, 1, own_group});
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
        inputs.push_back({other, port.bits, own_group});
        wire = fmt::format("{} ? {} : {}", Wires::held(own), Wires::held(other), wire);
      }
      pins += fmt::format("{}\n  .{}({})", pins.empty() ? "" : ",", port.name, wire);
    }
    body += fmt::format("{} #({}) {} ({});\n", unit.unit, parameters, unit.instance, pins);
  }
  // Verilator evaluates what hangs on an input each time, and what hangs on a register when that
  // changes: so a clock does not pay for inputs that have not moved.
  std::string declared;
  std::set<int> groups;
  for (const Input& input : inputs) {
    if (groups.insert(input.group).second)
      ports += fmt::format(",\n  input wire {}{}", IslandTake, input.group);
    ports += fmt::format(",\n  input wire [{}:0] {}", input.bits - 1, input.name);
    declared += fmt::format(
        "reg [{1}:0] {2} = 0;\nalways @(posedge {3}{4} or negedge {3}{4}) {2} <= {0};\n",
        input.name, input.bits - 1, Wires::held(input.name), IslandTake, input.group);
  }
  return fmt::format("module {} ({});\n{}{}endmodule\n", IslandTop, ports, declared, body);
}

}  // namespace racebeam
