// Which inputs of RTL reach which outputs without a register between, as yosys reads it.
//
// Who simulates a unit among others need not evaluate it when an input moves that reaches none: it
// counts at the next edge. And of what ports of one group make, nothing follows from those of
// another. What is not known is taken to reach all outputs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "tb/verilate/rtl_sources.h"
#include "tb/verilate/rtl_syntax.h"

namespace racebeam {

/// Ports by name, each with the number of its group, from 0 on: an input and an output that it
/// reaches are in one group. Inputs that are not there are quiet: they reach no output.
using CombGroups = std::map<std::string, int>;

/// Kept in the cache. One group if there is no yosys, it does not read the RTL, the RTL has several
/// files, or it asks whether yosys or a synthesis reads it, since a simulator has another answer.
/// Throws RtlError, Interrupted.
CombGroups comb_groups(const RtlSources& sources);

/// The same of the JSON that `scripts/netlist --paths` writes; `clock` joins nothing. Throws
/// RtlError if it is no such JSON.
CombGroups comb_groups_in(const std::string& json, const std::string& clock);

/// What holds of any RTL: all ports but the clock are in group 0.
CombGroups one_group(const RtlSyntax& syntax);

/// Names that belong together because some of them were joined.
class JoinedNames {
 public:
  /// A name alone is there too.
  void join(const std::string& a, const std::string& b);
  /// With numbers from 0 on in the order of names.
  CombGroups groups() const;

 private:
  const std::string& first_of(const std::string& name) const;
  std::map<std::string, std::string> above_;
};

}  // namespace racebeam
