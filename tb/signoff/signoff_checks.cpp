// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/lint.h"
#include "tb/signoff/mutants.h"
#include "tb/signoff/signoff_unit.h"

namespace racebeam {

const std::vector<SignoffCheck>& signoff_checks() {
  static const std::vector<SignoffCheck> table = {
      {"mutants",
       "small mistakes that yosys puts into the RTL: the unit's random traffic and walk find each, "
       "or it is proved equal",
       {"yosys", "yosys-abc", "verilator"},
       sign_off_mutants},
      {"lint", "no warning of verilator -Wall", {"verilator"}, sign_off_lint},
  };
  return table;
}

}  // namespace racebeam
