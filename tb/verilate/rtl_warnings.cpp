// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/rtl_warnings.h"

#include <string>

#include "sc/swap/rtl_remarks.h"
#include "tb/base/console.h"

namespace racebeam {

void warn_of_falling_edges(const rtl_model& model) {
  for (const std::string& place : remarks_of(model, "falling"))
    tell("warning: " + place +
         " changes on the falling edge of the clock; half a clock is not the contract");
}

void warn_of_circular_logic(const rtl_model& model) {
  const std::string places = remarks_text(model, "circular");
  if (!places.empty())
    tell(
        "warning: " + places +
        ": depends on itself without a register between, perhaps bit by bit; Verilator may compute "
        "it wrongly: break the vector into wires");
}

}  // namespace racebeam
