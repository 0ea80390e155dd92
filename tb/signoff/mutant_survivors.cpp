// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_survivors.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/scene/engines.h"
#include "tb/signoff/shared_work.h"
#include "tb/signoff/unit_stimulus.h"
#include "tb/twin/bare_rtl.h"
#include "tb/twin/random_episodes.h"
#include "tb/twin/twins.h"
#include "tb/verilate/cache_folder.h"

namespace racebeam {

namespace {

PortTraffic ports_in(const UnitUnderTest& dut, const std::string& work) {
  const std::string file = work + "/ports";
  forked([&] {
    write_traffic(ports_of(dut), file);
    return std::string();
  });
  return read_traffic(file);
}

ProofOfMutants proof_of(const SignoffUnit& unit, const SignoffOptions& options,
                        const MutantNetlist& netlist, const PortTraffic& ports,
                        const LegalInputs& legal) {
  ProofOfMutants proof{netlist, ports, legal, std::chrono::seconds(options.proof_seconds)};
  proof.again = options.prove_again;
  if (!proof.again) proof.proved = read_proved(known_proofs(unit.dut), circuit_key(proof));
  return proof;
}

}  // namespace

MutantSurvivors::MutantSurvivors(const SignoffUnit& unit, const SignoffOptions& options,
                                 const MutantNetlist& netlist, const std::string& plugin,
                                 const std::string& work)
    : unit_(unit),
      options_(options),
      netlist_(netlist),
      plugin_(plugin),
      ports_(ports_in(unit.dut, work)),
      legal_(twins_of(engine_of(unit.dut.k)).inputs(unit.dut.k, unit.dut.scene, unit.dut.unit)),
      streams_(plugin, ports_, legal_),
      proof_(proof_of(unit, options, netlist, ports_, legal_)),
      asked_with_(content_key({netlist.asserted, circuit_commands(proof_)})) {}

bool MutantSurvivors::is_open(const MutantFate& fate) const {
  if (fate.state == MutantFate::Undecided)
    return fate.stream != asked_with_ ||
           fate.clock < static_cast<std::uint64_t>(options_.proof_seconds);
  return fate.state == MutantFate::Alive;
}

void MutantSurvivors::decide(const std::vector<MutantFate>& fates, const RecordedStream& random,
                             const std::function<void(const MutantFate&)>& take) const {
  std::vector<int> numbers;
  for (const MutantFate& fate : fates) numbers.push_back(fate.number);
  const MutantProofs proofs(proof_, numbers);
  const PortTraffic traffic = whole_traffic(random);
  share_work(
      options_.jobs,
      [&](int share, const SayLine& say) {
        for (std::size_t n = 0; n < fates.size() && !interrupted(); ++n)
          if (static_cast<int>(n % static_cast<std::size_t>(options_.jobs)) == share)
            say(line_of(fates[n].state == MutantFate::Found ? late(fates[n], traffic, proofs)
                                                            : survivor(fates[n].number, proofs)));
      },
      [&](const std::string& line) { take(fate_of(line)); });
}

std::string MutantSurvivors::write_episodes(const std::map<int, MutantFate>& fates) const {
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
          : stream_head(name, {"For mistakes that random traffic finds late or not at all: "
                               "racebeam signoff " +
                               name});
  for (const std::size_t n : covering_streams(streams_, escaped)) {
    const std::string one = episode_text(escaped[n].stream, mutant(escaped[n].number).name);
    // One that is there finds the mutant only if registers without a reset are 0.
    if (text.find(one) == std::string::npos) text += one;
  }
  const std::string file = fmt::format("{}/{}.stream", options_.folder, name);
  write_text(file, text);
  return file;
}

std::size_t MutantSurvivors::kept_proofs(const std::map<int, MutantFate>& fates) const {
  return static_cast<std::size_t>(std::count_if(fates.begin(), fates.end(), [&](const auto& fate) {
    return fate.second.state == MutantFate::Equal &&
           proof_.proved.count(mutant(fate.first).name) != 0;
  }));
}

void MutantSurvivors::write_proved(const std::map<int, MutantFate>& fates) const {
  const std::string circuit = circuit_key(proof_);
  MutantNames names = read_proved(known_proofs(unit_.dut), circuit);
  for (const auto& [number, fate] : fates)
    if (fate.state == MutantFate::Equal) names.insert(mutant(number).name);
  const std::string& name = unit_.dut.unit;
  write_text(fmt::format("{}/{}.proved", options_.folder, name), proved_text(name, circuit, names));
}

MutantFate MutantSurvivors::survivor(int number, const MutantProofs& proofs) const {
  const MutantProof proof = proofs.prove(number);
  switch (proof.verdict) {
    case MutantProof::Equal: return {number, MutantFate::Equal, "", 0, "", ""};
    case MutantProof::Counterexample: return escaped(number, proof.inputs);
    default: return undecided(number, proof.why);
  }
}

MutantFate MutantSurvivors::late(const MutantFate& fate, const PortTraffic& random,
                                 const MutantProofs& proofs) const {
  const auto is_sooner = [&](const MutantFate& own) {
    return own.state == MutantFate::Escaped &&
           own.clock < static_cast<std::uint64_t>(options_.within);
  };
  const MutantFate small = escaped(fate.number, input_rows(random, fate.clock));
  if (is_sooner(small)) return small;
  const MutantProof proof = proofs.refute(fate.number);
  if (proof.verdict != MutantProof::Counterexample) return fate;
  const MutantFate own = escaped(fate.number, proof.inputs);
  return is_sooner(own) ? own : fate;
}

MutantFate MutantSurvivors::undecided(int number, const std::string& why) const {
  return {number,      MutantFate::Undecided,
          asked_with_, static_cast<std::uint64_t>(options_.proof_seconds),
          "",          why};
}

/// A counterexample counts if the mutant shows it on what the model says, and the unit does not.
MutantFate MutantSurvivors::escaped(int number,
                                    const std::vector<std::vector<std::uint64_t>>& inputs) const {
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
    return undecided(number, "model and RTL differ on the counterexample of yosys-abc, in " + file +
                                 ": registers without reset?");
  return {number, MutantFate::Escaped,
          file,   d.clock,
          d.port, fmt::format("{:#x} instead of {:#x}", d.got, d.expected)};
}

}  // namespace racebeam
