// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/comparator.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/bench/wired_bench.h"
#include "tb/scene/engines.h"
#include "tb/signoff/from_reset.h"
#include "tb/signoff/unit_drive.h"
#include "tb/twin/bare_rtl.h"
#include "tb/twin/port_traffic.h"
#include "tb/twin/traffic_tap.h"

namespace racebeam {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t MostBits = 10'000;  // of outputs; each takes a clock of traffic

struct Found {
  std::size_t bits = 0;  ///< inverted
  std::vector<std::string> faults;
};

std::vector<ComparedPort> outputs_of(const UnitBench& bench) {
  std::vector<ComparedPort> outputs;
  for (const UnitBench::Pin* pin : bench.pins())
    if (!pin->input) outputs.push_back({pin->name, pin->bits});
  return outputs;
}

Found found_by(
    const std::vector<ComparedPort>& outputs,
    const std::function<ComparatorAnswer(const std::string&, int, std::uint64_t&)>& how) {
  Found found;
  for (const ComparedPort& port : outputs) found.bits += static_cast<std::size_t>(port.bits);
  found.faults = comparator_faults(outputs, how);
  return found;
}

/// The comparison of `verify`.
Found try_lockstep(const UnitUnderTest& dut, const std::string& plugin,
                   const ComparatorOptions& options) {
  UnitDrive drive(dut, plugin, UnitDrive::Random, options.seed);
  Lockstep& lockstep = drive.lockstep();
  drive.run(options.warm_up);
  if (lockstep.fault()) throw RtlError(*lockstep.fault());
  if (lockstep.first())
    throw RtlError("model and RTL differ by themselves, at " + lockstep.first()->port);
  return found_by(outputs_of(drive.bench()),
                  [&](const std::string& port, int bit, std::uint64_t& clock) {
                    clock = lockstep.clocks();
                    lockstep.invert(port, bit, clock);
                    drive.run(2);
                    ComparatorAnswer answer;
                    if (const auto& first = lockstep.first())
                      answer = {first->port, first->clock, first->expected, first->got};
                    return answer;
                  });
}

/// The same of a whole chip.
Found try_chip(const UnitUnderTest& dut, const std::string& plugin,
               const ComparatorOptions& options) {
  WiredBench::Setting setting{engine_of(dut.k), dut.k, dut.scene, dut.frames};
  setting.units.by_unit[dut.unit] = {unit_choice::Model, true, plugin};
  WiredBench bench(setting);
  bench.advance(static_cast<int>(options.warm_up));
  const Lockstep& lockstep = *bench.locksteps().at(0);
  if (lockstep.first())
    throw RtlError("model and RTL differ by themselves, at " + lockstep.first()->port);
  std::vector<ComparedPort> outputs;
  for (const PortTraffic::Port& port : traffic_ports(bench.dut()))
    if (!port.input) outputs.push_back({port.name, port.bits});
  return found_by(outputs, [&](const std::string& port, int bit, std::uint64_t& clock) {
    clock = bench.invert(dut.unit, port, bit);
    bench.advance(2);
    ComparatorAnswer answer;
    if (const auto& first = lockstep.first())
      answer = {first->port, first->clock, first->expected, first->got};
    return answer;
  });
}

/// The comparison of recorded traffic.
Found try_bare(const UnitUnderTest& dut, const std::string& plugin,
               const ComparatorOptions& options) {
  std::uint64_t now = options.warm_up;
  PortTraffic traffic = traffic_from_reset(dut, now + MostBits, options.seed);
  BareRtl rtl(plugin, traffic);
  const auto differs = [](const PortTraffic& of, const TrafficDifference& at) {
    return RtlError("model and RTL differ by themselves, at " + of.ports[at.port].name);
  };
  if (const auto found = rtl.run(traffic, 0, now)) throw differs(traffic, *found);
  std::vector<ComparedPort> outputs;
  for (const PortTraffic::Port& port : traffic.ports)
    if (!port.input) outputs.push_back({port.name, port.bits});
  return found_by(outputs, [&](const std::string& port, int bit, std::uint64_t& clock) {
    if (now == traffic.clocks())
      throw RtlError(fmt::format("it has more than {} bits of outputs", MostBits));
    clock = now++;
    const auto at = std::find_if(traffic.ports.begin(), traffic.ports.end(),
                                 [&](const auto& one) { return one.name == port; });
    std::uint64_t& value = traffic.values[clock * traffic.ports.size() +
                                          static_cast<std::size_t>(at - traffic.ports.begin())];
    ComparatorAnswer answer;
    value ^= std::uint64_t{1} << bit;
    const auto found = rtl.run(traffic, clock, now);
    value ^= std::uint64_t{1} << bit;
    if (!found) return answer;
    if (const auto own = rtl.run(traffic, clock, now)) throw differs(traffic, *own);
    return ComparatorAnswer{traffic.ports[found->port].name, found->clock, found->expected,
                            found->got};
  });
}

/// In a process of its own.
Found tried(const std::function<Found()>& work) {
  const Json answer = Json::parse(forked([&] {
    const Found found = work();
    return Json{{"bits", found.bits}, {"faults", found.faults}}.dump();
  }));
  return {answer.at("bits"), answer.at("faults").get<std::vector<std::string>>()};
}

}  // namespace

std::vector<std::string> comparator_faults(
    const std::vector<ComparedPort>& outputs,
    const std::function<ComparatorAnswer(const std::string&, int, std::uint64_t&)>& invert) {
  std::vector<std::string> faults;
  for (const ComparedPort& port : outputs)
    for (int bit = 0; bit < port.bits; ++bit) {
      const std::string name = fmt::format("{}[{}]", port.name, bit);
      try {
        std::uint64_t clock = 0;
        const ComparatorAnswer answer = invert(port.name, bit, clock);
        if (answer.port.empty())
          faults.push_back(name + " is not compared: its inversion is not seen");
        else if (answer.port != port.name || answer.clock != clock ||
                 (answer.expected ^ answer.got) != std::uint64_t{1} << bit)
          faults.push_back(fmt::format(
              "{} inverted in clock {} is told as {} in clock {}, 0x{:x} instead of 0x{:x}", name,
              clock, answer.port, answer.clock, answer.got, answer.expected));
      } catch (const RtlFault&) {
        throw;
      } catch (const RtlError& error) {
        faults.push_back(name + " is not compared: " + error.what());
        break;
      }
    }
  return faults;
}

CheckResult sign_off_comparator(const UnitUnderTest& dut, const ComparatorOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  CheckResult result;
  result.unit = dut.unit;
  result.check = "comparator";
  try {
    const bool whole = is_whole_chip(dut);
    const std::string plugin =
        dut.plugin.empty()
            ? twins_of(engine_of(dut.k)).plugins(dut.k, dut.scene, false).own(dut.unit, whole)
            : dut.plugin;
    std::size_t bits = 0, missed = 0;
    const auto add = [&](const char* comparison, const Found& found) {
      bits += found.bits;
      missed += found.faults.size();
      for (const std::string& fault : found.faults)
        result.faults.push_back(std::string(comparison) + ": " + fault);
      result.detail[comparison] = {{"bits", found.bits}, {"missed", found.faults.size()}};
    };
    add("lockstep", tried([&] { return (whole ? try_chip : try_lockstep)(dut, plugin, options); }));
    add("recorded traffic", tried([&] { return try_bare(dut, plugin, options); }));
    if (bits == 0) result.faults.push_back("no output of " + dut.unit + " is compared");
    result.verdict = result.faults.empty() ? CheckResult::Good : CheckResult::Bad;
    result.summary = fmt::format("{} of {} inversions of an output bit found", bits - missed, bits);
  } catch (const MissingTool& missing) {
    result.verdict = CheckResult::Undecided;
    result.faults = {result.summary = missing.what()};
  } catch (const Interrupted&) {
    result.verdict = CheckResult::Undecided;
    result.faults = {result.summary = "interrupted"};
  } catch (const RtlError& fault) {
    result.verdict = CheckResult::Bad;
    result.summary = "the comparison cannot be tried";
    result.faults = {fault.what()};
  } catch (const ChildDied& death) {
    result.verdict = CheckResult::Bad;
    result.summary = "the comparison cannot be tried";
    result.faults = {death.what()};
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace racebeam
