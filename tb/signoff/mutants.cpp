// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutants.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>

#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/scene/engines.h"
#include "tb/signoff/mutant_judgement.h"
#include "tb/signoff/mutant_netlist.h"
#include "tb/signoff/mutant_proof.h"
#include "tb/signoff/mutant_run.h"
#include "tb/signoff/mutant_sizes.h"
#include "tb/signoff/mutant_streams.h"
#include "tb/signoff/shared_work.h"
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
  std::vector<std::string> parts = {netlist.verilog, std::to_string(options.within)};
  for (const RecordedStream& stream : streams)
    for (const std::string& file : stream.parts) parts.push_back(file_key(file));
  return content_key(parts);
}

/// Looks at mutants that no stream finds, or late.
class Survivors {
 public:
  Survivors(const SignoffUnit& unit, const SignoffOptions& options, const MutantNetlist& netlist,
            const std::string& plugin, const std::string& work)
      : unit_(unit),
        options_(options),
        netlist_(netlist),
        plugin_(plugin),
        ports_(ports_in(work)),
        legal_(twins_of(engine_of(unit.dut.k)).inputs(unit.dut.k)),
        streams_(plugin, ports_, legal_),
        proof_{netlist, ports_, legal_, std::chrono::seconds(options.proof_seconds)} {}
  Survivors(const Survivors&) = delete;
  Survivors& operator=(const Survivors&) = delete;

  /// `fates`: of each what is known. One that is found late stays so, unless a stream of its own
  /// finds it.
  void decide(const std::vector<MutantFate>& fates,
              const std::function<void(const MutantFate&)>& take) const {
    std::vector<int> numbers;
    for (const MutantFate& fate : fates) numbers.push_back(fate.number);
    const MutantProofs proofs(proof_, numbers);
    share_work(
        options_.jobs,
        [&](int share, const SayLine& say) {
          for (std::size_t n = 0; n < fates.size() && !interrupted(); ++n)
            if (static_cast<int>(n % static_cast<std::size_t>(options_.jobs)) == share)
              say(line_of(fates[n].state == MutantFate::Found ? late(fates[n], proofs)
                                                              : survivor(fates[n].number, proofs)));
        },
        [&](const std::string& line) { take(fate_of(line)); });
  }

  const MutantStreams& streams() const { return streams_; }
  /// The file with few episodes that find all mutants which have a stream of their own, behind
  /// those that are known already; "" of none.
  std::string write_episodes(const std::map<int, MutantFate>& fates) const {
    std::vector<EscapedMutant> escaped;
    for (const auto& [number, fate] : fates)
      if (fate.state == MutantFate::Escaped)
        escaped.push_back({number, read_stream(fate.stream, streams_.form())});
    if (escaped.empty()) return "";
    const std::string& name = unit_.dut.unit;
    const std::string known = known_streams(unit_.dut);
    std::string text =
        std::filesystem::exists(known)
            ? whole_file(known)
            : stream_head(name, {"Found by yosys-abc for mistakes that random traffic finds late "
                                 "or not at all: racebeam signoff " +
                                 name});
    for (const std::size_t n : covering_streams(streams_, escaped))
      text += episode_text(escaped[n].stream, mutant(escaped[n].number).name);
    const std::string file = fmt::format("{}/{}.stream", options_.folder, name);
    write_text(file, text);
    return file;
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
  const Mutant& mutant(int number) const {
    return netlist_.mutants.at(static_cast<std::size_t>(number) - 1);
  }

  MutantFate survivor(int number, const MutantProofs& proofs) const {
    const MutantProof proof = proofs.prove(number);
    switch (proof.verdict) {
      case MutantProof::Equal: return {number, MutantFate::Equal, "", 0, "", ""};
      case MutantProof::Counterexample: return escaped(number, proof.inputs);
      default: return undecided(number, proof.why);
    }
  }
  MutantFate late(const MutantFate& fate, const MutantProofs& proofs) const {
    const MutantProof proof = proofs.refute(fate.number);
    if (proof.verdict != MutantProof::Counterexample) return fate;
    const MutantFate own = escaped(fate.number, proof.inputs);
    return own.state == MutantFate::Escaped ? own : fate;
  }
  MutantFate undecided(int number, const std::string& why) const {
    return {number, MutantFate::Undecided,
            "",     static_cast<std::uint64_t>(options_.proof_seconds),
            "",     why};
  }
  /// A counterexample counts if the mutant shows it on what the model says, and the unit does not.
  MutantFate escaped(int number, const std::vector<std::vector<std::uint64_t>>& inputs) const {
    const auto small = streams_.smallest(number, inputs);
    if (!small) return undecided(number, "the counterexample of yosys-abc shows no difference");
    const std::string file =
        fmt::format("{}/{}.mutant-{}.stream", options_.folder, unit_.dut.unit, number);
    const StreamDifference& d = small->difference;
    write_text(file,
               stream_text(small->stream,
                           {fmt::format("{}: {} differs in clock {}: {:#x} instead of {:#x}",
                                        mutant(number).name, d.port, d.clock, d.got, d.expected)}));
    forked([&] {
      write_traffic(model_answers(unit_.dut, small->stream), file + ".traffic");
      return std::string();
    });
    const PortTraffic traffic = read_traffic(file + ".traffic");
    std::filesystem::remove(file + ".traffic");
    if (BareRtl(plugin_, traffic).run(traffic, 0, traffic.clocks()))
      return undecided(number, "model and RTL differ on the counterexample of yosys-abc, in " +
                                   file + ": registers without reset?");
    return {number, MutantFate::Escaped,
            file,   d.clock,
            d.port, fmt::format("{:#x} instead of {:#x}", d.got, d.expected)};
  }

  const SignoffUnit& unit_;
  const SignoffOptions& options_;
  const MutantNetlist& netlist_;
  const std::string plugin_;
  const PortTraffic ports_;
  const LegalInputs legal_;
  const MutantStreams streams_;
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

  FateFile file(fmt::format("{}/{}.mutants", options.folder, name),
                key_of(netlist, streams, options));
  std::vector<int> left;
  for (const Mutant& mutant : netlist.mutants)
    if (file.fates().count(mutant.number) == 0) left.push_back(mutant.number);
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
    if (fate.state == MutantFate::Alive || (fate.state == MutantFate::Found && late(fate)) ||
        (fate.state == MutantFate::Undecided &&
         fate.clock < static_cast<std::uint64_t>(options.proof_seconds)))
      open.push_back(fate);
  const Survivors survivors(unit, options, netlist, plugin, work.path());
  if (!open.empty()) {
    done = 0;
    survivors.decide(open, [&](const MutantFate& fate) {
      file.add(fate);
      options.progress(fmt::format("{} of {} survivors", ++done, open.size()));
    });
  }
  const std::string episodes = survivors.write_episodes(file.fates());
  CheckResult result =
      judge_mutants(name, netlist, file.fates(), options, {episodes, known_streams(unit.dut)});
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
