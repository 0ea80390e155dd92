// Gates: what yosys makes of a unit's RTL, as Verilog in the cache.
//
// Generic gates are one-bit operators and flip-flops, module by module; those of osu018 are its
// standard cells, all modules flattened, simulated as the functions that the library's file gives
// them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

constexpr const char* GenericGates = "generic";
constexpr const char* Osu018Gates = "osu018";
const std::vector<std::string>& gate_kinds();

/// What is to become gates, as it is written: "gates", "gates:osu018", "gates:mine.sv",
/// "gates:osu018:mine.sv".
struct GateWord {
  std::string kind;
  std::string file;  ///< empty: the unit's own RTL
};
/// Nothing if `text` is no such word. Throws UsageError for a kind or file that there is not.
std::optional<GateWord> gate_word(const std::string& text);

struct GateNetlist {
  std::string file;  ///< in the cache
  /// Of osu018; of generic gates 0, as their modules are apart.
  std::int64_t flip_flops = 0, cells = 0;
  double area = 0;  ///< square micrometres, without wires
};

/// A file in the cache with the generic gates of a module, as ParallelGates reads them. Throws
/// RtlError, also if they have other registers than on the rising edge of a clock; MissingTool,
/// Interrupted.
std::string gate_bits(const RtlSources& rtl);

/// Gates of a module in one file, with the project's packages and modules at hand, and with its
/// parameters; made when first needed, again whenever a file that it reads, a parameter, a table,
/// yosys, the recipe or the cells are others. A line on stderr says what takes the time. Throws
/// RtlError with what yosys says, MissingTool, Interrupted.
GateNetlist gate_netlist(const RtlSources& rtl, const std::string& kind);

/// The gates as RTL that stands in the unit's place: with its ports, and made with its parameters;
/// `signals`: its registers can be read. Throws as gate_netlist() does.
RtlSources simulated_gates(const RtlSources& rtl, const std::string& kind, bool signals);

}  // namespace racebeam
