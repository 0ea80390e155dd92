// A mutant beside its unit, as a question for yosys-abc: can any output ever differ?
//
// Both start with all registers at 0 and see one clock of reset, then any inputs that a chip can
// have. Registers without a reset start equal so.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/signoff/mutant_circuits.h"
#include "tb/signoff/state_told.h"

namespace racebeam {

struct MutantProof {
  enum Verdict { Equal, Counterexample, Undecided };
  Verdict verdict = Undecided;
  /// Of a counterexample: a row for each clock, and in it a value for each input of the ports.
  std::vector<std::vector<std::uint64_t>> inputs;
  std::string why;  ///< it is undecided
};

/// Whether that mutant was proved equal before, as the file or the cache tells.
bool is_proved_equal(const ProofOfMutants& proof, int number);

/// The proofs of some mutants: yosys makes circuits with all of them, and yosys-abc is asked with
/// one chosen. What was proved equal once is in the cache.
class MutantProofs {
 public:
  /// Throws RtlError, MissingTool, Interrupted.
  MutantProofs(const ProofOfMutants& proof, const std::vector<int>& numbers);
  MutantProof prove(int number) const;
  /// Only looks for a difference, by fewer clocks first; never Equal.
  MutantProof refute(int number) const;

 private:
  /// Which bit of which input of the ports each input of the circuit is.
  struct InputBit {
    std::size_t input = 0;
    int bit = -1;  // -1: none of them
  };
  using Inputs = std::vector<std::vector<std::uint64_t>>;
  /// Commands of yosys-abc that prepare the circuit, one that decides, and both their share of the
  /// time.
  struct Question {
    const char* prepared;
    const char* command;
    double share;
  };

  void read_map(const std::string& text);
  bool has_equal_steps(int number) const;
  double seconds() const;
  Inputs read_counterexample(const std::string& text) const;
  MutantProof ask(int number, const std::vector<Question>& questions) const;

  const ProofOfMutants proof_;
  std::optional<MutantCircuits> circuits_;  // if a mutant has to be proved
  std::vector<StateTold> ways_;
  StateValues states_;
  std::vector<InputBit> bits_;
};

}  // namespace racebeam
