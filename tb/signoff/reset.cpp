// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/reset.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/scene/engines.h"
#include "tb/signoff/four_state.h"
#include "tb/signoff/from_reset.h"
#include "tb/twin/contract_registers.h"
#include "tb/twin/twins.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

void judge_starts(const UnitUnderTest& dut, const PowerUpFindings& found, CheckResult& result) {
  if (!found.fault.empty()) result.faults.push_back(found.fault);
  bool named = false;
  std::vector<Unreset> open = contract_registers(dut.unit);
  for (const UnresetRegister& one : found.unreset) {
    if (one.port.empty()) continue;
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](const Unreset& row) { return is_named(row, one.name); }),
               open.end());
    if (!one.reason.empty()) continue;
    named = true;
    result.faults.push_back(fmt::format(
        "the reset misses the register {}: what it has at power-up shows at {} in clock "
        "{}; reset it, or load it before it is shown",
        one.name, one.port, one.clock));
  }
  if (!found.differences.empty() && !named) {
    const PowerUpDifference& first = found.differences.front();
    result.faults.push_back(
        fmt::format("from {} of {} values of the registers at power-up an output differs after the "
                    "reset, first {} in clock {} ({}); look for a register without reset",
                    found.differences.size(), found.starts, first.port, first.clock, first.start));
  }
  // Not every register that a unit shows reaches a pin of the chip.
  if (found.fault.empty() && !is_whole_chip(dut))
    for (const Unreset& row : open)
      result.faults.push_back(
          fmt::format("contract_registers.cpp names {}, which no output shows after the reset; "
                      "take it out there",
                      row.name));
}

Json to_json(const FourStateFindings& found) {
  Json pins = Json::array();
  for (const FourStateFindings::Pin& pin : found.pins)
    pins.push_back({{"port", pin.port}, {"clock", pin.clock}});
  return {{"registers", found.registers}, {"pins", pins}};
}

CheckResult check(const UnitUnderTest& dut, const ResetOptions& options) {
  CheckResult result;
  result.unit = dut.unit;
  result.check = "reset";
  const std::string plugin =
      dut.plugin.empty() ? twins_of(engine_of(dut.k)).plugins(dut.k, dut.scene, true).own(dut.unit)
                         : dut.plugin;
  PortTraffic traffic = traffic_from_reset(dut, options.starts.clocks, options.starts.traffic);
  const PowerUpFindings found = find_power_up(plugin, traffic, options.starts);
  result.detail = racebeam::to_json(found);
  if (!found.has_reset) {
    result.summary = fmt::format("no reset, {} registers", found.registers);
    return result;
  }
  judge_starts(dut, found, result);
  const bool bad = !result.faults.empty();
  const auto shown = std::count_if(found.unreset.begin(), found.unreset.end(),
                                   [](const UnresetRegister& one) { return !one.port.empty(); });
  result.summary = fmt::format(
      "{} of {} registers not reset{}; {} power-ups", found.unreset.size(), found.registers,
      options.starts.one_by_one ? fmt::format(", {} of them shown", shown) : "", found.starts);
  std::optional<FourStateFindings> unknown;
  if (options.four_state_clocks > 0 && !interrupted()) try {
      const auto clocks = std::min(options.four_state_clocks, traffic.clocks());
      traffic.values.resize(clocks * traffic.ports.size());
      std::vector<std::string> known;
      for (const Unreset& row : contract_registers(dut.unit)) known.push_back(row.name);
      unknown = run_in_four_states(plugin, traffic, known, open_registers(plugin, traffic));
      unknown->pins.erase(std::remove_if(unknown->pins.begin(), unknown->pins.end(),
                                         [&](const FourStateFindings::Pin& pin) {
                                           return !contract_reason(dut.unit, pin.port).empty();
                                         }),
                          unknown->pins.end());
      result.detail["four_state"] = to_json(*unknown);
    } catch (const MissingTool& missing) {
      result.verdict = CheckResult::Undecided;
      result.faults.emplace_back(missing.what());
    }
  if (unknown && result.faults.empty())
    for (const FourStateFindings::Pin& pin : unknown->pins) {
      result.verdict = CheckResult::Undecided;
      result.faults.push_back(
          fmt::format("{} is unknown in clock {} of the netlist in four states, though no value at "
                      "power-up was found that shows there",
                      pin.port, pin.clock));
    }
  if (bad) result.verdict = CheckResult::Bad;
  else if (interrupted()) result.verdict = CheckResult::Undecided;
  return result;
}

}  // namespace

CheckResult sign_off_reset(const UnitUnderTest& dut, const ResetOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  CheckResult result =
      check_result_of(Json::parse(forked([&] { return to_json(check(dut, options)).dump(); })));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace racebeam
