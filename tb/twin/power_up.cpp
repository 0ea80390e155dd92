// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/power_up.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include "sc/swap/rtl_power_up.h"
#include "tb/base/interrupt.h"
#include "tb/base/reset_value.h"
#include "tb/scene/engines.h"
#include "tb/twin/bare_rtl.h"
#include "tb/twin/contract_registers.h"
#include "tb/twin/twins.h"

namespace racebeam {

namespace {

constexpr int Rounds = 24;      // to tell registers from wires of one bit
constexpr int StartsAlone = 6;  // of one register: ones, and random values

/// A register, or all elements of an array.
struct Register {
  std::string name;
  std::vector<const rtl_port*> parts;
};

std::uint64_t value_of(const rtl_port& signal) {
  std::uint64_t value = 0;  // the machine's bytes begin with the lowest
  std::memcpy(&value, signal.data, static_cast<std::size_t>(signal.bytes));
  return value;
}

void put(const rtl_port& signal, std::uint64_t value) {
  const std::uint64_t raw = raw_bits(value, signal.bits);
  std::memcpy(signal.data, &raw, static_cast<std::size_t>(signal.bytes));
}

/// Without the number of an element; those of generate blocks stay.
std::string stem_of(std::string name) {
  while (!name.empty() && name.back() == ']') name.erase(name.rfind('['));
  return name;
}

/// The signals inside, elements of an array together, but for the ports themselves.
std::vector<Register> signals_of(const rtl_model& model) {
  std::set<std::string> ports;
  for (int n = 0; n < model.port_count; ++n) ports.insert(model.ports[n].name);
  std::vector<Register> all;
  std::map<std::string, std::size_t> at;
  std::set<const void*> seen;  // a wire may have several names
  for (int n = 0; n < model.signal_count; ++n) {
    const rtl_port& signal = model.signals[n];
    const std::string stem = stem_of(signal.name);
    if (ports.count(stem) != 0 || !seen.insert(signal.data).second) continue;
    const auto [found, is_new] = at.emplace(stem, all.size());
    if (is_new) all.push_back({stem, {}});
    all[found->second].parts.push_back(&signal);
  }
  return all;
}

/// What the RTL keeps of a value written before its first clock: that is a register.
bool is_kept(const Register& signal, const std::vector<std::uint64_t>& written) {
  for (std::size_t n = 0; n < signal.parts.size(); ++n)
    if (value_of(*signal.parts[n]) != written[n]) return false;
  return true;
}

/// The names of what the RTL itself remembers, of all signals: a wire seldom is what was written.
std::vector<std::string> registers_of(const std::string& plugin) {
  std::mt19937_64 random(1);
  std::set<std::string> kept;
  for (int round = 0; round < Rounds; ++round) {
    rtl_library rtl(plugin);
    const auto signals = signals_of(rtl.model());
    std::vector<std::vector<std::uint64_t>> written;
    for (const Register& signal : signals) {
      written.emplace_back();
      for (const rtl_port* part : signal.parts) {
        put(*part, random());
        written.back().push_back(value_of(*part));
      }
    }
    rtl.eval();
    for (std::size_t n = 0; n < signals.size(); ++n)
      if (!is_kept(signals[n], written[n])) kept.erase(signals[n].name);
      else if (round == 0) kept.insert(signals[n].name);
  }
  return {kept.begin(), kept.end()};
}

Register find(const rtl_model& model, const std::string& name) {
  for (Register& signal : signals_of(model))
    if (signal.name == name) return std::move(signal);
  return {name, {}};
}

/// The signals that the contract leaves without reset.
std::vector<const rtl_port*> left_open(const rtl_model& model, const std::string& unit) {
  const std::vector<Unreset> rows = contract_registers(unit);
  std::vector<const rtl_port*> all;
  for (const Register& signal : signals_of(model))
    if (std::any_of(rows.begin(), rows.end(),
                    [&](const Unreset& row) { return is_named(row, signal.name); }))
      all.insert(all.end(), signal.parts.begin(), signal.parts.end());
  return all;
}

/// The first difference of RTL that powers up so. What the contract leaves without reset is 0, and
/// after the clock in reset what it is from zeros: there it may have taken over what others had.
std::optional<TrafficDifference> first_from(const rtl_power_up& start, const std::string& plugin,
                                            const PortTraffic& traffic,
                                            const std::vector<OpenRegister>& open) {
  const RtlPowerUp now(start);
  BareRtl rtl(plugin, traffic);
  const auto signals = left_open(rtl.model(), traffic.unit);
  for (const rtl_port* signal : signals) put(*signal, 0);
  rtl.run(traffic, 0, 1);
  for (std::size_t n = 0; n < signals.size(); ++n) put(*signals[n], open[n].value);
  rtl.unsettle();
  return rtl.run(traffic, 1, traffic.clocks());
}

/// What the named registers have after the clock in reset.
std::vector<std::uint64_t> after_reset(const std::string& plugin, const PortTraffic& traffic,
                                       const std::vector<std::string>& names,
                                       const rtl_power_up& start, std::vector<std::size_t>& from) {
  const RtlPowerUp now(start);
  BareRtl rtl(plugin, traffic);
  rtl.run(traffic, 0, 1);
  std::map<std::string, Register> signals;
  for (Register& signal : signals_of(rtl.model())) signals.emplace(signal.name, signal);
  std::vector<std::uint64_t> values;
  from.clear();
  for (const std::string& name : names) {
    from.push_back(values.size());
    for (const rtl_port* part : signals.at(name).parts) values.push_back(value_of(*part));
  }
  from.push_back(values.size());
  return values;
}

/// Those of `names` that after the reset are not the same from every start.
std::vector<std::string> without_reset(const std::string& plugin, const PortTraffic& traffic,
                                       const std::vector<std::string>& names) {
  std::vector<std::size_t> from;
  const auto zeros = after_reset(plugin, traffic, names, {RtlZeros, 0}, from);
  std::set<std::size_t> open;
  for (int seed = 0; seed <= StartsAlone; ++seed) {
    const auto other =
        after_reset(plugin, traffic, names, {seed == 0 ? RtlOnes : RtlRandom, seed}, from);
    for (std::size_t n = 0; n < names.size(); ++n)
      if (!std::equal(zeros.begin() + static_cast<std::ptrdiff_t>(from[n]),
                      zeros.begin() + static_cast<std::ptrdiff_t>(from[n + 1]),
                      other.begin() + static_cast<std::ptrdiff_t>(from[n])))
        open.insert(n);
  }
  std::vector<std::string> found;
  for (const std::size_t n : open) found.push_back(names[n]);
  return found;
}

/// The same inputs, and what the RTL says to them whose registers are 0 at power-up.
PortTraffic of_zeros(const std::string& plugin, PortTraffic traffic) {
  rtl_library rtl(plugin);
  std::vector<const rtl_port*> ports;
  for (const PortTraffic::Port& port : traffic.ports)
    ports.push_back(&rtl_port_of(rtl.model(), port.name));
  for (std::size_t row = 0; row < traffic.values.size(); row += ports.size()) {
    for (std::size_t n = 0; n < ports.size(); ++n)
      if (traffic.ports[n].input) put(*ports[n], traffic.values[row + n]);
    rtl.eval();
    for (std::size_t n = 0; n < ports.size(); ++n)
      if (!traffic.ports[n].input) traffic.values[row + n] = value_of(*ports[n]);
    rtl.rise();
  }
  return traffic;
}

int bits_of(const std::string& plugin, const std::string& name) {
  const rtl_library rtl(plugin);
  int bits = 0;
  for (const rtl_port* part : find(rtl.model(), name).parts) bits += part->bits;
  return bits;
}

/// The first port that a register reaches which alone is not 0 at power-up.
UnresetRegister alone(const std::string& plugin, const PortTraffic& traffic,
                      const std::string& name) {
  UnresetRegister found;
  found.name = name;
  std::mt19937_64 random(1);
  for (int n = 0; n < StartsAlone; ++n) {
    BareRtl rtl(plugin, traffic);
    const Register signal = find(rtl.model(), name);
    found.bits = 0;
    for (const rtl_port* part : signal.parts) {
      put(*part, n == 0 ? ~std::uint64_t{0} : random());
      found.bits += part->bits;
    }
    const auto difference = rtl.run(traffic, 0, traffic.clocks());
    if (!difference || (!found.port.empty() && found.clock <= difference->clock)) continue;
    found.port = traffic.ports[difference->port].name;
    found.clock = difference->clock;
  }
  return found;
}

/// The traffic without the outputs that the contract leaves open.
PortTraffic compared(const PortTraffic& traffic) {
  std::vector<bool> left_out;
  PortTraffic rest;
  rest.unit = traffic.unit;
  const auto open = contract_ports(traffic.unit);
  for (const PortTraffic::Port& port : traffic.ports) {
    left_out.push_back(std::any_of(open.begin(), open.end(),
                                   [&](const Unreset& row) { return port.name == row.name; }));
    if (!left_out.back()) rest.ports.push_back(port);
  }
  for (std::size_t n = 0; n < traffic.values.size(); ++n)
    if (!left_out[n % left_out.size()]) rest.values.push_back(traffic.values[n]);
  return rest;
}

/// Where a register shows: at an output that is compared, else at one that the contract leaves
/// open.
UnresetRegister shown(const std::string& plugin, const PortTraffic& all,
                      const PortTraffic& compared, const std::string& name) {
  UnresetRegister found = alone(plugin, compared, name);
  if (!found.port.empty()) {
    found.reason = contract_reason(all.unit, name);
    return found;
  }
  found = alone(plugin, all, name);
  if (!found.port.empty()) found.reason = contract_reason(all.unit, found.port);
  return found;
}

std::vector<rtl_power_up> starts(int seeds) {
  std::vector<rtl_power_up> all = {{RtlZeros, 0}, {RtlOnes, 0}};
  for (int seed = 1; seed <= seeds; ++seed) all.push_back({RtlRandom, seed});
  return all;
}

}  // namespace

std::vector<OpenRegister> open_registers(const std::string& plugin, const PortTraffic& traffic) {
  BareRtl rtl(plugin, traffic);
  rtl.run(traffic, 0, 1);
  std::vector<OpenRegister> all;
  for (const rtl_port* signal : left_open(rtl.model(), traffic.unit))
    all.push_back({signal->name, signal->bits, value_of(*signal)});
  return all;
}

PowerUpFindings find_power_up(const std::string& plugin, const PortTraffic& traffic,
                              const PowerUpOptions& options) {
  PowerUpFindings findings;
  for (const PortTraffic::Port& port : traffic.ports)
    findings.has_reset |= port.input && reset_value(port.name) >= 0 &&
                          contract_reason(traffic.unit, port.name).empty();
  const PortTraffic model = compared(traffic);
  try {
    const std::vector<OpenRegister> open = open_registers(plugin, model);
    for (const rtl_power_up& start : starts(options.seeds)) {
      if (interrupted() || !findings.has_reset) break;
      const auto first = first_from(start, plugin, model, open);
      findings.clocks += first ? first->clock : traffic.clocks();
      ++findings.starts;
      if (first)
        findings.differences.push_back({power_up_text(start), model.ports[first->port].name,
                                        first->clock, first->expected, first->got});
    }
    const std::vector<std::string> registers = registers_of(plugin);
    findings.registers = static_cast<int>(registers.size());
    if (!findings.has_reset) return findings;
    const PortTraffic zeros = of_zeros(plugin, traffic), rest = compared(zeros);
    for (const std::string& name : without_reset(plugin, traffic, registers))
      if (!interrupted())
        findings.unreset.push_back(options.one_by_one || !findings.differences.empty()
                                       ? shown(plugin, zeros, rest, name)
                                       : UnresetRegister{name, bits_of(plugin, name), {}, 0, {}});
  } catch (const RtlFault& fault) {
    findings.fault = fault.what();
  }
  return findings;
}

nlohmann::ordered_json to_json(const PowerUpFindings& findings) {
  nlohmann::ordered_json json = {{"has_reset", findings.has_reset},
                                 {"starts", findings.starts},
                                 {"clocks", findings.clocks},
                                 {"registers", findings.registers},
                                 {"fault", findings.fault},
                                 {"differences", nlohmann::ordered_json::array()},
                                 {"unreset", nlohmann::ordered_json::array()}};
  for (const PowerUpDifference& d : findings.differences)
    json["differences"].push_back({{"start", d.start},
                                   {"port", d.port},
                                   {"clock", d.clock},
                                   {"expected", d.expected},
                                   {"got", d.got}});
  for (const UnresetRegister& r : findings.unreset)
    json["unreset"].push_back({{"name", r.name},
                               {"bits", r.bits},
                               {"port", r.port},
                               {"clock", r.clock},
                               {"reason", r.reason}});
  return json;
}

PowerUpFindings power_up_findings_of(const nlohmann::ordered_json& json) {
  PowerUpFindings findings;
  findings.has_reset = json.at("has_reset");
  findings.starts = json.at("starts");
  findings.clocks = json.at("clocks");
  findings.registers = json.at("registers");
  findings.fault = json.at("fault");
  for (const auto& d : json.at("differences"))
    findings.differences.push_back(
        {d.at("start"), d.at("port"), d.at("clock"), d.at("expected"), d.at("got")});
  for (const auto& r : json.at("unreset"))
    findings.unreset.push_back(
        {r.at("name"), r.at("bits"), r.at("port"), r.at("clock"), r.at("reason")});
  return findings;
}

}  // namespace racebeam
