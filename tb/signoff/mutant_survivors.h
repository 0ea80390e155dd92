// Mutants that no stream finds, or that are found late: proved equal, or given a stream of their
// own.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tb/signoff/mutant_fate.h"
#include "tb/signoff/mutant_netlist.h"
#include "tb/signoff/mutant_proof.h"
#include "tb/signoff/mutant_streams.h"
#include "tb/signoff/signoff_unit.h"
#include "tb/signoff/unit_stimulus.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/port_traffic.h"

namespace racebeam {

class MutantSurvivors {
 public:
  /// `plugin`: the netlist of all mutants; `work`: a folder for what is soon gone. All of them must
  /// live as long as this does.
  MutantSurvivors(const SignoffUnit& unit, const SignoffOptions& options,
                  const MutantNetlist& netlist, const std::string& plugin, const std::string& work);
  MutantSurvivors(const MutantSurvivors&) = delete;
  MutantSurvivors& operator=(const MutantSurvivors&) = delete;

  /// Whether it was proved equal once, whatever the stimulus was then: it need not be run.
  bool is_known_equal(int number) const { return is_proved_equal(proof_, number); }
  /// Whether it has not been asked yet for so long, and with these assertions.
  bool is_open(const MutantFate& fate) const;
  /// `fates`: of each what is known. One that `random` finds late stays so, unless a stream of its
  /// own finds it. Throws RtlError, MissingTool, Interrupted, OutputError.
  void decide(const std::vector<MutantFate>& fates, const RecordedStream& random,
              const std::function<void(const MutantFate&)>& take) const;
  const MutantStreams& streams() const { return streams_; }
  /// The file with few episodes that find all mutants which have a stream of their own, behind
  /// those that are known already; "" of none. Throws UsageError, OutputError.
  std::string write_episodes(const std::map<int, MutantFate>& fates) const;
  /// How many of those that are equal were proved so before, as a file in the tree tells.
  std::size_t kept_proofs(const std::map<int, MutantFate>& fates) const;
  /// The file with the names of all that are proved equal, behind those that were known of this
  /// circuit. Throws OutputError.
  void write_proved(const std::map<int, MutantFate>& fates) const;

 private:
  const Mutant& mutant(int number) const {
    return netlist_.mutants.at(static_cast<std::size_t>(number) - 1);
  }
  MutantFate survivor(int number, const MutantProofs& proofs) const;
  MutantFate late(const MutantFate& fate, const PortTraffic& random,
                  const MutantProofs& proofs) const;
  MutantFate undecided(int number, const std::string& why) const;
  MutantFate escaped(int number, const std::vector<std::vector<std::uint64_t>>& inputs) const;

  const SignoffUnit& unit_;
  const SignoffOptions& options_;
  const MutantNetlist& netlist_;
  const std::string& plugin_;
  const PortTraffic ports_;
  const LegalInputs legal_;
  const MutantStreams streams_;
  const ProofOfMutants proof_;
  const std::string asked_with_;  // beside the netlist
};

}  // namespace racebeam
