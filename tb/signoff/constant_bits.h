// Bits of the RTL that no legal input can move: yosys finds them constant.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/twin/legal_inputs.h"
#include "tb/verilate/rtl_sources.h"
#include "tb/verilate/rtl_syntax.h"

namespace racebeam {

/// Bits of inputs that have the same value whatever a port is driven with, by port: masks of the
/// bits that are always 0 and always 1. The rules of `legal` are tried with all single bits, their
/// complements, and some thousand values at random.
struct TiedBits {
  std::uint64_t zeros = 0, ones = 0;
};
std::map<std::string, TiedBits> tied_inputs(const LegalInputs& legal,
                                            const std::vector<RtlSyntax::Port>& ports);

/// The bits of RTL that are constant, each named by where its signal is declared: "FILE:LINE
/// sp_q[3]", with the whole path of the file. A bit of a module with several instances is among
/// them only if it is so in all.
class ConstantBits {
 public:
  /// Elaborates with yosys, inputs tied as `tied` has them. The answer is kept in the cache. Throws
  /// MissingTool; RtlError if yosys cannot read the sources; Interrupted.
  ConstantBits(const RtlSources& sources, const std::map<std::string, TiedBits>& tied);

  /// `file` as a whole path; `bit` as Verilator names it, such as "sp_q[3]".
  bool has(const std::string& file, int line, const std::string& bit) const;

 private:
  std::set<std::string> bits_;
};

}  // namespace racebeam
