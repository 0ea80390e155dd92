// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/verify_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/output_file.h"
#include "tb/base/version.h"
#include "tb/scene/engines.h"
#include "tb/show/set_knob.h"
#include "tb/twin/bare_rtl.h"
#include "tb/twin/power_up.h"
#include "tb/twin/stream_player.h"
#include "tb/twin/verilog_bench.h"

namespace racebeam {

namespace {

/// Without the ports that the RTL does without.
PortTraffic of_rtl(const PortTraffic& model, const rtl_model& rtl) {
  PortTraffic kept;
  kept.unit = model.unit;
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < model.ports.size(); ++n)
    if (has_rtl_port(rtl, model.ports[n].name)) {
      kept.ports.push_back(model.ports[n]);
      numbers.push_back(n);
    }
  for (std::uint64_t clock = 0; clock < model.clocks(); ++clock)
    for (const std::size_t n : numbers) kept.values.push_back(model.row(clock)[n]);
  return kept;
}

/// Those that the chip sets, and the tables of its scene.
std::vector<std::string> parameters_of(const UnitUnderTest& dut, const rtl_model& rtl) {
  std::map<std::string, std::string> built;  // the last one of a name counts
  std::istringstream words(rtl.parameters);
  for (std::string word; words >> word;)
    if (const auto equals = word.find('='); equals != std::string::npos)
      built[word.substr(0, equals)] = word.substr(equals + 1);
  std::vector<std::string> all;
  const bool standard = knobs_text(dut.k) == "default";
  for (const auto& [name, value] : built) {
    const bool is_text = value.find('"') != std::string::npos;
    const auto wanted = engine_of(dut.k).parameters(dut.k);
    const bool of_knob = std::any_of(wanted.begin(), wanted.end(),
                                     [&](const rtl_parameter& one) { return one.name == name; });
    if (of_knob ? !standard
                : dut.scene && (is_text || built.count("RoomFile") + built.count("ShotFile") > 0))
      all.push_back(name + "=" + value);
  }
  return all;
}

/// By clock and port: 1 of outputs that are others when the registers begin otherwise; empty: there
/// are none.
std::vector<bool> unknown_values(const std::string& plugin, const PortTraffic& traffic,
                                 const std::map<std::uint64_t, int>& seeks) {
  constexpr std::uint32_t Beginnings = 32;
  const PortTraffic usual = BareRtl(plugin, traffic).answers(traffic, seeks);
  std::vector<bool> unknown(traffic.values.size(), false);
  for (std::uint32_t seed = 0; seed < Beginnings; ++seed) {
    BareRtl rtl(plugin, traffic);
    rtl.power_up(seed);
    const PortTraffic other = rtl.answers(traffic, seeks);
    for (std::size_t n = traffic.ports.size(); n < unknown.size(); ++n)  // from clock 1 on
      if (usual.values[n] != other.values[n]) unknown[n] = true;
  }
  if (std::find(unknown.begin(), unknown.end(), true) == unknown.end()) unknown.clear();
  return unknown;
}

/// The registers of the unit itself that its contract leaves without reset, from zeros.
std::vector<VerilogBench::Deposit> deposits_of(const std::string& plugin,
                                               const PortTraffic& traffic) {
  std::vector<VerilogBench::Deposit> all;
  for (const OpenRegister& open : open_registers(plugin, traffic))
    if (open.name.find_first_of(".[") == std::string::npos)
      all.push_back({open.name, open.value, open.bits});
  return all;
}

}  // namespace

void write_bench(const UnitUnderTest& dut, const BenchTraffic& of, const std::string& file) {
  const rtl_library library(dut.plugin);
  TwinBench twins(dut);
  const std::uint64_t clocks = std::min(of.clocks, BenchTraffic::MostClocks);
  const PortStream stream =
      of.stream.empty() ? StreamPlayer(twins).record(Stimulus::Random, of.seed, clocks, clocks)
                        : read_stream(of.stream, twins.form());
  const PortTraffic traffic = of_rtl(twins.model_traffic(stream), library.model());
  VerilogBench bench{
      traffic,
      has_rtl_port(library.model(), "clk_i"),
      stream.seeks,
      unknown_values(dut.plugin, traffic, stream.seeks),
      deposits_of(dut.plugin, traffic),
      parameters_of(dut, library.model()),
      {"Test bench of " + dut.unit + ", written by racebeam " + program_version() + ":",
       "  " + of.command,
       fmt::format("{} clocks; clock 0, in reset, is not compared.", traffic.clocks())}};
  write_text(file, verilog_bench_text(bench));
}

}  // namespace racebeam
