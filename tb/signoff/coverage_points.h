// What the RTL of a unit has counted of its own code: lines, branches and toggling bits.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

/// A place in the RTL that a run should pass. All instances of a module, and all rounds of a loop
/// that makes some, count as one.
struct CoveragePoint {
  /// Line: a block of statements. Branch: one way of an `if`, also the way past it. Toggle: a bit
  /// that goes up and down.
  enum Kind { Line, Branch, Toggle };
  static constexpr const char* Kinds[] = {"line", "branch", "toggle"};

  Kind kind;
  std::string module, file;
  int line = 0, column = 0;
  /// "sp_q[2]" of a toggle; else "if", "else", "case", "block", and the text of the line.
  std::string name, text;
  std::uint64_t count = 0;  ///< of a toggle: changes, in the instance and the run with most

  /// A toggle needs two changes: up and down, or down and up.
  bool hit() const { return count > (kind == Toggle ? 1 : 0); }
  std::string place() const { return file + ":" + std::to_string(line); }
  /// What a waiver names: "sp_q[2]", or "else: if (push_en_i) begin".
  std::string title() const { return kind == Toggle ? name : name + ": " + text; }
};

/// The points of a file that write_rtl_coverage() has written, in the order of the source; those of
/// the wrapper that drives the clock are left out. Files are named from the project's folder on, if
/// they lie there. Throws RtlError if the file is not what Verilator writes.
std::vector<CoveragePoint> read_coverage(const std::string& path);

/// Adds the counts of another run of the same RTL.
void add_coverage(std::vector<CoveragePoint>& to, const std::vector<CoveragePoint>& more);

}  // namespace racebeam
