// `--use UNIT=IMPLEMENTATION,...`: which units of the chip are models, RTL, or both.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "sc/base/unit_choices.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

/// Instead of a unit: all of them.
constexpr const char* AllUnits = "all";
/// What a unit may be without a file.
const std::vector<std::string>& own_implementations();

/// Reads choices for one chip.
class UseOption {
 public:
  /// A chip of `built` with the knobs `k` that shows `scene`; nullptr: the built-in demo.
  /// `traced`: signals inside the RTL can be read.
  UseOption(const engine& built, const knob_values& k, const scene_tables* scene,
            bool traced = false);

  /// Adds choices such as "subdivider=rtl", "all=lockstep", "stacks=mine.sv", "stacks=a.sv+b.sv",
  /// "stacks=mine.f", "stacks=mine.so", "stacks=gates:osu018", or several with commas between;
  /// later ones replace earlier ones. Gates are made and SystemVerilog is verilated here, but for
  /// units' own RTL, which waits for join(). Throws UsageError, RtlError, MissingTool.
  void use(unit_choices& choices, const std::string& text) const;

  /// All has been said: units' own RTL is verilated; `islands`: together where units touch each
  /// other. Throws RtlError, MissingTool.
  void join(unit_choices& choices, bool islands = true) const;

  /// Adds what `verify` was told: "subdivider", "all", "stacks=mine.sv" or "all=gates", in
  /// lockstep. `all` has the whole chip too, where its RTL is this chip. Throws as use() does.
  void lockstep(unit_choices& choices, const std::string& text) const;

  /// The plug-in of the whole chip's own RTL, in which these registers can be written to. Throws
  /// RtlError, MissingTool.
  std::string whole_chip(const std::vector<std::string>& registers) const {
    return plugins_.with_doors(engine_.top, registers);
  }

  /// The file of a unit's gates that ParallelGates reads; empty if it cannot: the word is another,
  /// or the gates have other registers than on the rising edge of a clock. Throws MissingTool,
  /// Interrupted.
  std::string gate_bits(const std::string& unit, const std::string& how) const;

  /// Says why a unit is none of this chip. Throws UsageError unless it is one.
  void check_unit(const std::string& unit) const;

  /// Says why the RTL of the whole chip is not this chip. Throws UsageError unless it is.
  void check_whole_chip() const;

 private:
  /// `beside`: of verify, which has nothing but lockstep.
  void use_one(unit_choices& choices, const std::string& text, bool beside) const;
  unit_choice choice_of(const std::string& unit, const std::string& text) const;

  void check_use_of_chip(const std::string& how, bool beside) const;

  const engine& engine_;
  const bool scene_file_;
  const bool wired_;  // the whole chip in RTL is this chip
  const PluginMaker plugins_;
};

}  // namespace racebeam
