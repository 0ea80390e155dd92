// A unit that is signed off, and what it is made of.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/signoff/check_result.h"
#include "tb/signoff/waivers.h"
#include "tb/twin/unit_under_test.h"
#include "tb/verilate/rtl_sources.h"

namespace racebeam {

struct SignoffUnit {
  UnitUnderTest dut;   ///< with the plug-in of its RTL
  RtlSources sources;  ///< that RTL
  std::string file{};  ///< a user's RTL as it was named; empty: the unit's own
};

struct SignoffOptions {
  int mutants = 1000;          ///< of each unit, at most
  long long mutant_seed = 1;   ///< of their choice
  long long random = 100'000;  ///< clocks
  long long seed = 1;          ///< of the stimulus
  int proof_seconds = 60;      ///< for each mutant
  bool prove_again = false;    ///< what was proved before, too
  /// Clocks of random traffic; a mutant that is found later gets a stream of its own. 0: none does.
  long long within = 0;
  bool shrink = false;  ///< what random traffic finds of mutants, and tell the sizes
  int jobs = 1;
  std::vector<Waiver> waivers{};
  std::string folder = "racebeam_signoff";  ///< results are kept there
  /// Told what is going on: "642 of 1,000 mutants found".
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// A kind of check, and what it needs: a row of a table.
struct SignoffCheck {
  const char* name;
  const char* meaning;               ///< "yosys puts mistakes into the RTL, ..."
  std::vector<const char*> tools{};  ///< without one of them it is undecided
  bool of_chips;                     ///< whole chips have it, too
  /// Throws RtlError, UsageError, MissingTool, Interrupted.
  CheckResult (*run)(const SignoffUnit& unit, const SignoffOptions& options);
};

/// All of them, in the order of the table.
const std::vector<SignoffCheck>& signoff_checks();

}  // namespace racebeam
