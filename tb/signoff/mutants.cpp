// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/scene/engines.h"
#include "tb/signoff/mutant_judgement.h"
#include "tb/signoff/mutant_netlist.h"
#include "tb/signoff/mutant_proof.h"
#include "tb/signoff/mutant_run.h"
#include "tb/signoff/shared_work.h"
#include "tb/twin/bare_rtl.h"
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

std::string key_of(const MutantNetlist& netlist, const std::vector<RecordedStream>& streams) {
  std::vector<std::string> parts = {netlist.verilog};
  for (const RecordedStream& stream : streams)
    for (const std::string& file : stream.parts) parts.push_back(file_key(file));
  return content_key(parts);
}

/// Looks at mutants that no stream finds.
class Survivors {
 public:
  Survivors(const SignoffUnit& unit, const SignoffOptions& options, const MutantNetlist& netlist,
            const std::string& plugin, const std::string& work)
      : unit_(unit),
        options_(options),
        plugin_(plugin),
        ports_(ports_in(work)),
        legal_(twins_of(engine_of(unit.dut.k)).inputs(unit.dut.k)),
        proof_{netlist, ports_, legal_, std::chrono::seconds(options.proof_seconds)} {}
  Survivors(const Survivors&) = delete;
  Survivors& operator=(const Survivors&) = delete;

  void decide(const std::vector<int>& numbers,
              const std::function<void(const MutantFate&)>& take) const {
    const MutantProofs proofs(proof_, numbers);
    share_work(
        options_.jobs,
        [&](int share, const SayLine& say) {
          for (std::size_t n = 0; n < numbers.size() && !interrupted(); ++n)
            if (static_cast<int>(n % static_cast<std::size_t>(options_.jobs)) == share)
              say(line_of(fate_of_survivor(numbers[n], proofs)));
        },
        [&](const std::string& line) { take(fate_of(line)); });
  }

 private:
  PortTraffic ports_in(const std::string& work) const {
    const std::string file = work + "/ports";
    forked([&] {
      write_traffic(ports_of(unit_.dut), file);
      return std::string();
    });
    return read_traffic(file);
  }

  MutantFate fate_of_survivor(int number, const MutantProofs& proofs) const {
    const MutantProof proof = proofs.prove(number);
    switch (proof.verdict) {
      case MutantProof::Equal: return {number, MutantFate::Equal, "", 0, "", ""};
      case MutantProof::Counterexample: return replayed(number, proof.inputs);
      default: return undecided(number, proof.why);
    }
  }
  MutantFate undecided(int number, const std::string& why) const {
    return {number, MutantFate::Undecided,
            "",     static_cast<std::uint64_t>(options_.proof_seconds),
            "",     why};
  }
  /// A counterexample counts if the mutant shows it on what the model says, and the unit does not.
  MutantFate replayed(int number, const std::vector<std::vector<std::uint64_t>>& inputs) const {
    const std::string file =
        fmt::format("{}/{}.mutant-{}.traffic", options_.folder, unit_.dut.unit, number);
    forked([&] {
      write_traffic(model_answers(unit_.dut, inputs), file);
      return std::string();
    });
    const PortTraffic traffic = read_traffic(file);
    BareRtl sound(plugin_, traffic), mutant(plugin_, traffic);
    mutant.hold(MutantInput, static_cast<std::uint64_t>(number));
    if (sound.run(traffic, 0, traffic.clocks()))
      return undecided(number, "model and RTL differ on the counterexample of yosys-abc, in " +
                                   file + ": registers without reset?");
    const auto found = mutant.run(traffic, 0, traffic.clocks());
    if (!found) return undecided(number, "the counterexample of yosys-abc shows no difference");
    const std::string port = traffic.ports[found->port].name;
    return {number, MutantFate::Escaped,
            file,   found->clock,
            port,   fmt::format("{:#x} instead of {:#x}", found->got, found->expected)};
  }

  const SignoffUnit& unit_;
  const SignoffOptions& options_;
  const std::string plugin_;
  const PortTraffic ports_;
  const LegalInputs legal_;
  const ProofOfMutants proof_;
};

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

  FateFile file(fmt::format("{}/{}.mutants", options.folder, name), key_of(netlist, streams));
  std::vector<int> left;
  for (const Mutant& mutant : netlist.mutants)
    if (file.fates().count(mutant.number) == 0) left.push_back(mutant.number);
  std::size_t done = file.fates().size();
  run_mutants(plugin, left, streams, options.jobs, [&](const MutantFate& fate) {
    file.add(fate);
    options.progress(fmt::format("{} of {} mutants", ++done, netlist.mutants.size()));
  });
  left.clear();
  for (const auto& [number, fate] : file.fates())
    if (fate.state == MutantFate::Alive ||
        (fate.state == MutantFate::Undecided &&
         fate.clock < static_cast<std::uint64_t>(options.proof_seconds)))
      left.push_back(number);
  if (!left.empty()) {
    const Survivors survivors(unit, options, netlist, plugin, work.path());
    done = 0;
    survivors.decide(left, [&](const MutantFate& fate) {
      file.add(fate);
      options.progress(fmt::format("{} of {} survivors", ++done, left.size()));
    });
  }
  return judge_mutants(name, netlist, file.fates(), options);
}

}  // namespace racebeam
