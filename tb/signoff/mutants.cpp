// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutants.h"

#include <fmt/format.h>

#include <optional>

#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/scene/engines.h"
#include "tb/signoff/mutant_judgement.h"
#include "tb/signoff/mutant_netlist.h"
#include "tb/signoff/mutant_run.h"
#include "tb/signoff/mutant_sizes.h"
#include "tb/signoff/mutant_survivors.h"
#include "tb/twin/bare_rtl.h"
#include "tb/twin/random_episodes.h"
#include "tb/twin/twins.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/rtl_plugin.h"

namespace racebeam {

namespace {

/// The plug-in of a text. It has a place of its own in the cache: a plug-in is known by the paths
/// of its files, too.
std::string plugin_of(const std::string& unit, const std::string& verilog) {
  const std::string file = cached(content_key({verilog}) + ".v",
                                  [&](const std::string& out) { write_text(out, verilog); });
  return rtl_plugin({unit, {file}, {}, {}, {}, {}, RtlSources::Unit, false});
}

std::string key_of(const MutantNetlist& netlist, const std::vector<RecordedStream>& streams,
                   const SignoffOptions& options) {
  std::vector<std::string> parts = {netlist.verilog, std::to_string(options.within),
                                    std::to_string(options.prove_again)};
  for (const RecordedStream& stream : streams)
    for (const std::string& file : stream.parts) parts.push_back(file_key(file));
  return content_key(parts);
}

CheckResult broken(const SignoffUnit& unit, const std::string& summary, const std::string& fault) {
  CheckResult result;
  result.unit = unit.dut.unit;
  result.check = "mutants";
  result.verdict = CheckResult::Bad;
  result.summary = summary;
  result.faults = {fault};
  return result;
}

}  // namespace

CheckResult sign_off_mutants(const SignoffUnit& unit, const SignoffOptions& options) {
  const std::string& name = unit.dut.unit;
  options.progress("stimulus");
  const WorkFolder work;
  const std::vector<RecordedStream> streams =
      record_stimulus(unit.dut, static_cast<std::uint64_t>(options.random),
                      static_cast<unsigned>(options.seed), work.path());
  if (const auto difference = first_difference(unit.dut.plugin, streams))
    return broken(
        unit, "model and RTL differ",
        "model and RTL differ in " + *difference + "; racebeam verify " + name + " shows it");
  options.progress("netlist");
  const MutantNetlist netlist =
      mutant_netlist(unit.sources, options.mutants, static_cast<unsigned>(options.mutant_seed));
  const std::string plugin = plugin_of(name, netlist.verilog);
  if (const auto difference = first_difference(plugin, streams))
    return broken(unit, "yosys reads other RTL",
                  "the netlist of yosys is not the RTL: they differ in " + *difference +
                      "; look for what yosys reads in another way than Verilator");

  FateFile file(fmt::format("{}/{}.mutants", options.folder, name),
                key_of(netlist, streams, options));
  const MutantSurvivors survivors(unit, options, netlist, plugin, work.path());
  std::vector<int> left;
  for (const Mutant& mutant : netlist.mutants) {
    const int number = mutant.number;
    if (file.fates().count(number) != 0) continue;
    if (survivors.is_known_equal(number)) file.add({number, MutantFate::Equal, "", 0, "", ""});
    else left.push_back(number);
  }
  std::size_t done = file.fates().size();
  run_mutants(plugin, left, streams, options.jobs, [&](const MutantFate& fate) {
    file.add(fate);
    options.progress(fmt::format("{} of {} mutants", ++done, netlist.mutants.size()));
  });
  const auto late = [&](const MutantFate& fate) {
    return options.within > 0 && options.proof_seconds > 0 && fate.stream == RandomStream &&
           fate.clock >= static_cast<std::uint64_t>(options.within);
  };
  std::vector<MutantFate> open;
  for (const auto& [number, fate] : file.fates())
    if (survivors.is_open(fate) || (fate.state == MutantFate::Found && late(fate)))
      open.push_back(fate);
  if (!open.empty()) {
    done = 0;
    survivors.decide(open, streams.front(), [&](const MutantFate& fate) {
      file.add(fate);
      options.progress(fmt::format("{} of {} survivors", ++done, open.size()));
    });
  }
  survivors.write_proved(file.fates());
  const std::string episodes = survivors.write_episodes(file.fates());
  CheckResult result =
      judge_mutants(name, netlist, file.fates(), options, {episodes, known_streams(unit.dut)});
  if (const std::size_t kept = survivors.kept_proofs(file.fates()); kept > 0)
    result.summary += fmt::format("; {} of the proofs are kept ones", kept);
  result.detail["kept_proofs"] = survivors.kept_proofs(file.fates());
  if (options.shrink && streams.front().name == RandomStream) {
    const MutantSizes sizes =
        mutant_sizes(survivors.streams(), streams.front(), file.fates(), options.jobs,
                     [&](std::size_t shrunk, std::size_t of) {
                       options.progress(fmt::format("{} of {} shrunk", shrunk, of));
                     });
    result.summary += "; shrunk: " + text_of(sizes);
    result.detail["shrunk"] = to_json(sizes);
  }
  return result;
}

}  // namespace racebeam
