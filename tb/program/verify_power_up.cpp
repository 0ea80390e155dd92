// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/verify_power_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "tb/twin/unit_traffic.h"

namespace racebeam {

std::string power_up_story(const std::string& unit, const PowerUpFindings& findings) {
  std::string text;
  for (const UnresetRegister& found : findings.unreset)
    if (!found.port.empty() && found.reason.empty())
      text += fmt::format(
          "{}: the reset misses the register {}: what it has at power-up shows at {} in clock {}\n",
          unit, found.name, found.port, found.clock);
  if (findings.differences.empty()) return text;
  const auto first =
      std::min_element(findings.differences.begin(), findings.differences.end(),
                       [](const auto& a, const auto& b) { return a.clock < b.clock; });
  return text + fmt::format(
                    "{}: from {} of {} values of its registers at power-up an output is not the "
                    "model's after the reset; the first: {}, {} in clock {}, 0x{:x} instead of "
                    "0x{:x}\n",
                    unit, findings.differences.size(), findings.starts, first->start, first->port,
                    first->clock, first->got, first->expected);
}

UnitVerdict verify_power_up(const UnitUnderTest& dut, const PowerUpOptions& options,
                            const std::string& repeat) {
  const auto start = std::chrono::steady_clock::now();
  const PortTraffic traffic = record_from_reset(dut, options.clocks, options.traffic);
  const PowerUpFindings findings = find_power_up(dut.plugin, traffic, options);
  UnitVerdict verdict{dut.unit, "power-up", findings.clocks, 0, findings.differences.size(),
                      0,        {},         findings.fault};
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (findings.differences.empty()) return verdict;
  const auto first =
      std::min_element(findings.differences.begin(), findings.differences.end(),
                       [](const auto& a, const auto& b) { return a.clock < b.clock; });
  verdict.first = FirstDifference{
      first->port, first->clock, first->expected,
      first->got,  {},           power_up_story(dut.unit, findings) + "repeat: " + repeat + "\n"};
  return verdict;
}

}  // namespace racebeam
