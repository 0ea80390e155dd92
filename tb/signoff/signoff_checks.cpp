// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/forked.h"
#include "tb/signoff/comparator.h"
#include "tb/signoff/coverage.h"
#include "tb/signoff/from_reset.h"
#include "tb/signoff/gates.h"
#include "tb/signoff/lint.h"
#include "tb/signoff/mutants.h"
#include "tb/signoff/reset.h"
#include "tb/signoff/signoff_unit.h"
#include "tb/verilate/rtl_plugin.h"

namespace racebeam {

namespace {

unsigned seed_of(const SignoffOptions& options) { return static_cast<unsigned>(options.seed); }

CheckResult coverage(const SignoffUnit& unit, const SignoffOptions& options) {
  return sign_off_coverage(
      unit.dut, {static_cast<std::uint64_t>(options.random), seed_of(options), unit.file, ""});
}

CheckResult comparator(const SignoffUnit& unit, const SignoffOptions& options) {
  return sign_off_comparator(unit.dut, {seed_of(options)});
}

// Registers are told by their names.
CheckResult reset(const SignoffUnit& unit, const SignoffOptions& options) {
  UnitUnderTest open = unit.dut;
  RtlSources sources = unit.sources;
  sources.signals = true;
  open.plugin = rtl_plugin(sources);
  ResetOptions wanted;
  wanted.starts.traffic = seed_of(options);
  wanted.starts.clocks = clocks_from_reset(unit.dut, wanted.starts.clocks);
  wanted.starts.one_by_one = !is_whole_chip(unit.dut);
  return sign_off_reset(open, wanted);
}

CheckResult gates(const SignoffUnit& unit, const SignoffOptions& options) {
  GatesOptions wanted;
  wanted.seed = seed_of(options);
  wanted.clocks = clocks_from_reset(unit.dut, wanted.clocks);
  wanted.file = unit.file;
  return check_result_of(nlohmann::ordered_json::parse(
      forked([&] { return to_json(sign_off_gates(unit.dut, wanted)).dump(); })));
}

}  // namespace

const std::vector<SignoffCheck>& signoff_checks() {
  static const std::vector<SignoffCheck> table = {
      {"mutants",
       "small mistakes that yosys puts into the RTL: the unit's random traffic and walk find each, "
       "or it is proved equal",
       {"yosys", "yosys-abc", "verilator"},
       false,
       sign_off_mutants},
      {"coverage",
       "the same traffic reaches all lines, branches, toggling bits and crosses of states",
       {"yosys", "verilator"},
       false,
       coverage},
      {"comparator",
       "every bit of every output is compared: one inverted in one clock is found",
       {"verilator"},
       true,
       comparator},
      {"reset",
       "whatever registers have at power-up, no pin shows it after the reset",
       {"yosys", "iverilog", "verilator"},
       true,
       reset},
      {"gates",
       "generic gates and osu018 cells are the unit, and have slack",
       {"yosys", "verilator"},
       true,
       gates},
      {"lint", "no warning of verilator -Wall", {"verilator"}, true, sign_off_lint},
  };
  return table;
}

}  // namespace racebeam
