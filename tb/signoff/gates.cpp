// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/gates.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/scene/engines.h"
#include "tb/signoff/from_reset.h"
#include "tb/twin/bare_rtl.h"
#include "tb/twin/twins.h"
#include "tb/verilate/gate_timing.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t Batch = 10'000;  // clocks, then it looks

std::optional<TrafficDifference> run(const std::string& plugin, const PortTraffic& traffic) {
  BareRtl gates(plugin, traffic);
  std::optional<TrafficDifference> found;
  for (std::uint64_t clock = 0; clock < traffic.clocks() && !found; clock += Batch) {
    if (interrupted()) throw Interrupted();
    found = gates.run(traffic, clock, std::min(clock + Batch, traffic.clocks()));
  }
  return found;
}

/// A wrong bit of each output, put into traffic that the gates have passed, is found in its clock.
bool tells_a_wrong_bit(const std::string& plugin, PortTraffic traffic) {
  const std::uint64_t clock = std::min<std::uint64_t>(500, traffic.clocks() - 1);
  traffic.values.resize((clock + 1) * traffic.ports.size());
  for (std::size_t port = 0; port < traffic.ports.size(); ++port) {
    if (traffic.ports[port].input) continue;
    std::uint64_t& value = traffic.values[clock * traffic.ports.size() + port];
    value ^= 1;
    const auto found = run(plugin, traffic);
    value ^= 1;
    if (!found || found->clock != clock || found->port != port) return false;
  }
  return true;
}

class GatesCheck {
 public:
  GatesCheck(const UnitUnderTest& dut, const GatesOptions& options)
      : dut_(dut),
        options_(options),
        maker_(twins_of(engine_of(dut.k)).plugins(dut.k, dut.scene, false)) {
    result_.unit = dut.unit;
    result_.check = "gates";
    result_.detail = Json::object();
  }

  CheckResult run_all() {
    const auto start = std::chrono::steady_clock::now();
    try {
      compare();
      for (const std::string& kind : options_.kinds)
        if (kind == Osu018Gates) measure();
    } catch (const MissingTool& error) {
      end(CheckResult::Undecided, error.what());
    } catch (const Interrupted& error) {
      end(CheckResult::Undecided, error.what());
    } catch (const RtlError& error) {
      end(CheckResult::Bad, error.what());
    }
    result_.summary = result_.faults.empty() ? said_ : result_.faults.front();
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result_;
  }

 private:
  void end(CheckResult::Verdict verdict, const std::string& fault) {
    if (result_.verdict != CheckResult::Bad) result_.verdict = verdict;
    result_.faults.push_back(fault);
  }
  void say(const std::string& what) { said_ += (said_.empty() ? "" : "; ") + what; }
  GateWord word(const std::string& kind) const { return {kind, options_.file}; }

  void compare() {
    const PortTraffic traffic = traffic_from_reset(dut_, options_.clocks, options_.seed);
    result_.detail["clocks"] = traffic.clocks();
    for (const std::string& kind : options_.kinds) compare(kind, traffic);
  }

  void compare(const std::string& kind, const PortTraffic& traffic) {
    const std::string plugin = maker_.gates(dut_.unit, word(kind));
    const auto found = run(plugin, traffic);
    Json& detail = result_.detail[kind];
    detail["same"] = !found;
    if (found) {
      const PortTraffic::Port& port = traffic.ports[found->port];
      detail["first"] = {{"port", port.name}, {"clock", found->clock}};
      return end(CheckResult::Bad,
                 fmt::format("gates of {}: port {} is {:#x} instead of {:#x} in clock {}; "
                             "racebeam verify {}=gates:{}{} shows it",
                             kind, port.name, found->got, found->expected, found->clock, dut_.unit,
                             kind, options_.file.empty() ? "" : ":" + options_.file));
    }
    if (!tells_a_wrong_bit(plugin, traffic))
      return end(CheckResult::Bad, "gates of " + kind +
                                       ": the comparison has missed a wrong bit "
                                       "that was put in; report this");
    say(fmt::format("{} same for {} clocks", kind, traffic.clocks()));
  }

  void measure() {
    const GateNetlist netlist = maker_.netlist(dut_.unit, word(Osu018Gates));
    Json& detail = result_.detail[Osu018Gates];
    detail["flip_flops"] = netlist.flip_flops;
    detail["cells"] = netlist.cells;
    detail["area"] = netlist.area;
    const GateTiming timing = gate_timing(engine_of(dut_.k), dut_.unit, netlist);
    detail["longest_path"] = timing.ns;
    detail["slack"] = timing.slack();
    detail["from"] = timing.from;
    detail["to"] = timing.to;
    if (timing.slack() < options_.least_slack)
      end(CheckResult::Bad,
          fmt::format("slack {:.2f} ns at {:.1f} MHz from {} to {}, less than {:g}", timing.slack(),
                      timing.megahertz(), timing.from, timing.to, options_.least_slack));
    detail["excepted"] = timing.excepted;
    say(fmt::format("{} flip-flops, {} cells, {:g} um2, slack {:.2f} ns", netlist.flip_flops,
                    netlist.cells, netlist.area, timing.slack()));
    for (const std::string& module : timing.excepted)
      said_ += fmt::format(" with the exceptions in {}.sdc", module);
  }

  const UnitUnderTest& dut_;
  const GatesOptions& options_;
  const PluginMaker maker_;
  CheckResult result_;
  std::string said_;
};

}  // namespace

CheckResult sign_off_gates(const UnitUnderTest& dut, const GatesOptions& options) {
  return GatesCheck(dut, options).run_all();
}

}  // namespace racebeam
