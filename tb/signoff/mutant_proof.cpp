// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/base/reset_value.h"
#include "tb/base/whole_file.h"
#include "tb/base/work_clock.h"
#include "tb/signoff/aiger.h"
#include "tb/signoff/equal_steps.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

// How a circuit is prepared. Where there are multipliers, scorr alone takes minutes, and a short
// search without it finds most differences; &scorr and lcorr merge most of the rest in seconds.
constexpr const char* AsItIs = "strash";
constexpr const char* Swept = "strash; &get; &scorr -C 10; &put; lcorr -C 100";
constexpr const char* SweptLong = "strash; scorr";
constexpr std::chrono::seconds StateTime{60};  // at least, to find out which states there are

using Raw = std::uint64_t;

const Mutant& mutant_of(const ProofOfMutants& proof, int number) {
  return proof.netlist.mutants.at(static_cast<std::size_t>(number) - 1);
}

std::string key_of(const ProofOfMutants& proof, int number) {
  return content_key({circuit_key(proof), mutant_of(proof, number).command}) + ".equal";
}

}  // namespace

bool is_proved_equal(const ProofOfMutants& proof, int number) {
  if (proof.again) return false;
  return proof.proved.count(mutant_of(proof, number).name) != 0 ||
         !in_cache(key_of(proof, number)).empty();
}

MutantProofs::MutantProofs(const ProofOfMutants& proof, const std::vector<int>& numbers)
    : proof_(proof) {
  if (!has_tool("yosys-abc"))
    throw MissingTool("yosys-abc is not installed; it comes with the package yosys");
  std::vector<Mutant> mutants;
  for (const int number : numbers)
    if (!is_proved_equal(proof, number)) mutants.push_back(mutant_of(proof, number));
  if (mutants.empty() || proof.limit.count() == 0) return;
  circuits_ = mutant_circuits(proof, mutants);
  read_map(circuits_->miter_map);
  const AndCircuit unit = circuits_->step.with(0);
  const auto time = std::max<std::chrono::milliseconds>(StateTime, proof.limit);
  ways_ = ways_to_tell(unit, circuits_->words);
  states_ = StateValues(unit, circuits_->words,
                        std::chrono::duration_cast<std::chrono::seconds>(time), circuits_->claims);
}

void MutantProofs::read_map(const std::string& text) {
  std::map<std::string, std::size_t> numbers;
  for (const PortTraffic::Port& port : proof_.ports.ports)
    if (port.input) numbers.emplace(port.name, numbers.size());
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind, name;
    std::size_t at;
    int bit;
    if (!(words >> kind >> at >> bit >> name) || kind != "input") continue;
    bits_.resize(std::max(bits_.size(), at + 1));
    if (const auto found = numbers.find(name); found != numbers.end())
      bits_[at] = {found->second, bit};
  }
}

// As abc writes it: the registers, then a row of bits for each clock.
MutantProofs::Inputs MutantProofs::read_counterexample(const std::string& text) const {
  const auto& ports = proof_.ports.ports;
  const auto inputs = std::count_if(ports.begin(), ports.end(),
                                    [](const PortTraffic::Port& port) { return port.input; });
  Inputs rows;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    line = line.substr(0, line.find('#'));
    if (line.size() < bits_.size() || line.find_first_not_of("01x") != std::string::npos) continue;
    std::vector<std::uint64_t> row(static_cast<std::size_t>(inputs));
    for (std::size_t n = 0; n < bits_.size(); ++n)
      if (bits_[n].bit >= 0 && line[n] == '1') row[bits_[n].input] |= Raw{1} << bits_[n].bit;
    rows.push_back(row);
  }
  std::size_t n = 0;  // the first clock is in reset, whatever the inputs say
  if (!rows.empty())
    for (const PortTraffic::Port& port : ports) {
      if (!port.input) continue;
      if (const int value = reset_value(port.name); value >= 0)
        rows.front()[n] = static_cast<Raw>(value);
      ++n;
    }
  return rows;
}

MutantProof MutantProofs::prove(int number) const {
  if (is_proved_equal(proof_, number)) return {MutantProof::Equal, {}, ""};
  MutantProof proof;
  if (has_equal_steps(number)) proof.verdict = MutantProof::Equal;
  else
    proof = ask(number, {{AsItIs, "bmc3 -F 4", 0.1},
                         {Swept, "pdr", 0.2},
                         {SweptLong, "pdr", 0.3},
                         {Swept, "bmc3 -F 1000", 0.2}});
  if (proof.verdict == MutantProof::Equal)
    cached(key_of(proof_, number), [&](const std::string& out) { write_text(out, "equal\n"); });
  return proof;
}

/// Takes a third of the time, or all of it if that is the only way; in the first half only what is
/// found at once, so that nothing hard is in its way.
bool MutantProofs::has_equal_steps(int number) const {
  if (!circuits_) return false;
  const auto time = proof_.limit / (circuits_->miter ? 3 : 1);
  const AndCircuit unit = circuits_->step.with(0), mutant = circuits_->step.with(number);
  const auto any_holds = [&](EqualSteps::Effort effort) {
    const auto end = WorkClock::now() + time / 2;
    return std::any_of(ways_.begin(), ways_.end(), [&](const StateTold& told) {
      return WorkClock::now() < end &&
             EqualSteps(unit, mutant, states_, told.word, told.wide).hold(end, effort);
    });
  };
  return any_holds(EqualSteps::AtOnce) || any_holds(EqualSteps::Thorough);
}

double MutantProofs::seconds() const { return std::chrono::duration<double>(proof_.limit).count(); }

MutantProof MutantProofs::refute(int number) const {
  return ask(number, {{AsItIs, "bmc3 -F 4", 0.1}, {Swept, "bmc3 -F 1000", 0.9}});
}

MutantProof MutantProofs::ask(int number, const std::vector<Question>& questions) const {
  if (!circuits_) return {MutantProof::Undecided, {}, "no proof was asked for"};
  if (!circuits_->miter)
    return {MutantProof::Undecided,
            {},
            fmt::format("clock by clock it was not proved equal within {:g} seconds, and for more "
                        "there is too much memory",
                        seconds())};
  const WorkFolder work;
  work.write("miter.aig", aiger_of(circuits_->miter->with(number)));
  std::string said;
  const auto says = [&](const char* status) { return said.find(status) != std::string::npos; };
  for (const Question& question : questions) {
    const auto share = static_cast<int>(std::max(1.0, seconds() * question.share));
    said = run_tool({{"yosys-abc", "-q",
                      fmt::format("read_aiger miter.aig; {}; {}; print_status; write_cex -a "
                                  "counterexample",
                                  question.prepared, question.command)},
                     work.path(),
                     {},
                     {},
                     std::chrono::seconds(share + 1)})
               .said;
    if (says("Status = 1")) return {MutantProof::Equal, {}, ""};
    if (says("Status = 0")) break;
  }
  if (!says("Status = 0"))
    return {MutantProof::Undecided,
            {},
            fmt::format("yosys-abc neither proved it equal nor found a difference within {:g} "
                        "seconds",
                        seconds())};
  const Inputs rows = read_counterexample(whole_file(work.file("counterexample")));
  if (rows.empty()) throw RtlError("yosys-abc has written no counterexample:\n" + said);
  if (!is_legal(proof_, rows))
    return {MutantProof::Undecided, rows,
            "it differs on inputs only that a chip does not have, as far as yosys-abc can tell"};
  return {MutantProof::Counterexample, rows, ""};
}

}  // namespace racebeam
