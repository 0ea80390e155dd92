// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_judgement.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "tb/signoff/mutant_sizes.h"
#include "tb/signoff/mutant_totals.h"
#include "tb/signoff/unit_stimulus.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t MostWaived = 100;  // one of so many
constexpr std::size_t Told = 25;         // faults

struct Judgement {
  std::map<MutantFate::State, int> count{};
  int waived = 0, walked = 0;           // walked: found by the walk only
  std::vector<std::uint64_t> clocks{};  // of those that random traffic finds, sorted
  std::vector<std::string> faults{};
  Json survivors = Json::array();
};

std::string text_of(const Mutant& mutant) {
  return mutant.source.empty() ? mutant.name : mutant.name + " (" + mutant.source + ")";
}

std::string fault_of(const Mutant& mutant, const MutantFate& fate) {
  if (fate.state == MutantFate::Escaped)
    return fmt::format(
        "not found: {}; in {} it differs at clock {}, {}: the stimulus has to reach that",
        text_of(mutant), fate.stream, fate.clock, fate.port);
  return fmt::format(
      "undecided: {}: {}; give it longer with --prove, or find out and write a waiver",
      text_of(mutant), fate.note);
}

/// Whether the netlist has the cell of a mutant's name at all: other seeds choose other mutants.
bool has_cell(const MutantNetlist& netlist, const std::string& name) {
  std::istringstream words(name);
  std::string mode, cell;
  words >> mode >> cell;
  return !cell.empty() && (netlist.rtlil.find(" " + cell + "\n") != std::string::npos ||
                           netlist.rtlil.find(" \\" + cell + "\n") != std::string::npos);
}

/// Which mutants are waived; what is wrong with waivers.
std::map<std::string, const Waiver*> waivers_of(const std::string& unit,
                                                const MutantNetlist& netlist,
                                                const std::map<int, MutantFate>& fates,
                                                const std::vector<Waiver>& waivers,
                                                std::vector<std::string>& faults) {
  std::map<std::string, const Waiver*> good;
  for (const Waiver& waiver : waivers) {
    if (waiver.unit != unit) continue;
    if (!waiver.fault.empty()) {
      faults.push_back(waiver.place + ": the waiver of " + waiver.mutant + " " + waiver.fault);
      continue;
    }
    const auto mutant = std::find_if(netlist.mutants.begin(), netlist.mutants.end(),
                                     [&](const Mutant& one) { return one.name == waiver.mutant; });
    if (mutant == netlist.mutants.end()) {
      if (!has_cell(netlist, waiver.mutant))
        faults.push_back(waiver.place + ": there is no such mutant as " + waiver.mutant +
                         "; take the waiver away");
      continue;
    }
    const MutantFate& fate = fates.at(mutant->number);
    if (fate.state == MutantFate::Undecided) good[waiver.mutant] = &waiver;
    else
      faults.push_back(
          fmt::format("{}: {} is {}; take the waiver away", waiver.place, waiver.mutant,
                      fate.state == MutantFate::Equal ? "proved equal" : word_of(fate.state)));
  }
  return good;
}

Judgement judge(const std::string& unit, const MutantNetlist& netlist,
                const std::map<int, MutantFate>& fates, const SignoffOptions& options) {
  Judgement all;
  const auto waivers = waivers_of(unit, netlist, fates, options.waivers, all.faults);
  for (const Mutant& mutant : netlist.mutants) {
    const MutantFate& fate = fates.at(mutant.number);
    ++all.count[fate.state];
    if (fate.state == MutantFate::Found) {
      if (fate.stream == RandomStream) all.clocks.push_back(fate.clock);
      else ++all.walked;
      continue;
    }
    const auto waiver = waivers.find(mutant.name);
    const bool waived = waiver != waivers.end();
    if (waived) ++all.waived;
    else if (fate.state != MutantFate::Equal) all.faults.push_back(fault_of(mutant, fate));
    Json json = {
        {"mutant", mutant.name}, {"source", mutant.source}, {"state", word_of(fate.state)}};
    if (fate.state == MutantFate::Escaped)
      json.update({{"stream", fate.stream}, {"clock", fate.clock}, {"port", fate.port}});
    if (!fate.note.empty()) json["note"] = fate.note;
    if (waived)
      json["waiver"] = {{"reason", waiver->second->reason},
                        {"reviewer", waiver->second->reviewer},
                        {"date", waiver->second->date}};
    all.survivors.push_back(json);
  }
  std::sort(all.clocks.begin(), all.clocks.end());
  if (static_cast<std::size_t>(all.waived) * MostWaived > netlist.mutants.size())
    all.faults.push_back(fmt::format("{} of {} mutants are waived, and 1 % may be", all.waived,
                                     netlist.mutants.size()));
  return all;
}

}  // namespace

CheckResult judge_mutants(const std::string& unit, const MutantNetlist& netlist,
                          const std::map<int, MutantFate>& fates, const SignoffOptions& options,
                          const Episodes& episodes) {
  Judgement all = judge(unit, netlist, fates, options);
  CheckResult result;
  result.unit = unit;
  result.check = "mutants";
  result.verdict = all.faults.empty() ? CheckResult::Good : CheckResult::Bad;
  const auto clocks = [&](int percent) { return percentile(all.clocks, percent); };
  const int found = all.count[MutantFate::Found], equal = all.count[MutantFate::Equal];
  result.summary =
      fmt::format("{} of {} found, {} proved equal", found, netlist.mutants.size(), equal);
  if (all.count[MutantFate::Escaped] > 0)
    result.summary += fmt::format(", {} not found", all.count[MutantFate::Escaped]);
  if (all.count[MutantFate::Undecided] > 0)
    result.summary += fmt::format(", {} undecided", all.count[MutantFate::Undecided]);
  if (all.waived > 0) result.summary += fmt::format(", {} of them waived", all.waived);
  if (all.walked > 0) result.summary += fmt::format(", {} by the walk alone", all.walked);
  if (!all.clocks.empty())
    result.summary += fmt::format("; clocks: median {}, p90 {}, p99 {}, most {}", clocks(50),
                                  clocks(90), clocks(99), clocks(100));
  result.detail = {
      {"mutants", netlist.mutants.size()},
      {"asked", options.mutants},
      {"mutant_seed", options.mutant_seed},
      {"random", options.random},
      {"seed", options.seed},
      {"found", found},
      {"equal", equal},
      {"not_found", all.count[MutantFate::Escaped]},
      {"undecided", all.count[MutantFate::Undecided]},
      {"waived", all.waived},
      {"by_walk", all.walked},
      {"clocks",
       {{"median", clocks(50)}, {"p90", clocks(90)}, {"p99", clocks(99)}, {"most", clocks(100)}}},
      {"found_within", found_within(all.clocks)},
      {"survivors", all.survivors}};
  if (all.faults.size() > Told) {
    const std::size_t more = all.faults.size() - Told;
    all.faults.resize(Told);
    all.faults.push_back(fmt::format("and {} more; --json has all", more));
  }
  if (!episodes.file.empty()) {
    result.detail["episodes"] = episodes.file;
    all.faults.push_back(
        fmt::format("{} has episodes that find those; as {} they are part of the stimulus",
                    episodes.file, episodes.place));
  }
  result.faults = all.faults;
  return result;
}

}  // namespace racebeam
