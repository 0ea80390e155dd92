// Silicon: which units a point's chip is made of, and what tells their syntheses apart.
//
// The silicon of a chip is the sum over its units, without the sound, which is the same in all: a
// unit is synthesised once for all points in which its own parameters are the same. A whole chip is
// its top module, with the parameters of its units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "sc/swap/rtl_parameters.h"
#include "tb/verilate/yosys.h"

namespace racebeam {

constexpr const char* GenericRecipe = "generic";  ///< that of scripts/netlist --count
constexpr const char* Sound = "pwm_sound";

/// A unit's synthesis: all that its result depends on.
struct UnitParameters {
  std::string unit;
  std::string parameters;  ///< all that are knobs: "IntervalStackDepth=4 FaceStackDepth=9"
  std::string hash;        ///< of sources, parameters, recipe and yosys
  std::vector<std::string> settings{};  ///< the parameters that are not as by default

  /// "stacks", "stacks with IntervalStackDepth=8".
  std::string text() const;
};

/// There is no RTL of a point: says of which knob.
class NoSilicon : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Silicon {
 public:
  /// Reads the RTL of the chip that shows the built-in demo, and asks yosys for its version. Throws
  /// MissingTool if one of them is not there, or yosys does not answer; Interrupted.
  explicit Silicon(const engine& engine);

  /// "Yosys 0.23 (git sha1 7ce5011c24b)".
  const std::string& yosys() const { return yosys_; }

  /// What has to be synthesised for a point, without doing it. Pins change no silicon. Throws
  /// NoSilicon of a knob that differs from the chip and that no unit's RTL has.
  std::vector<UnitParameters> units_of(const knob_values& k) const;
  /// engine::top for a point, the sound in it. Throws NoSilicon if there is none, and of a knob
  /// that it has not.
  UnitParameters chip_of(const knob_values& k) const;
  const engine& of() const { return engine_; }

 private:
  struct Unit {
    std::string name, sources;            ///< sources: their key
    std::vector<std::size_t> parameters;  ///< that are knobs: places in engine::parameters
  };
  Unit unit_named(const std::string& name) const;
  std::vector<rtl_parameter> parameters_of(const knob_values& k) const;
  UnitParameters with(const Unit& unit, const std::vector<rtl_parameter>& wanted) const;

  const engine& engine_;
  std::string yosys_, recipe_;
  std::vector<rtl_parameter> usual_;  ///< of the chip
  std::vector<bool> known_;           ///< of those: a unit has it
  std::vector<Unit> units_;
  Unit top_;
};

}  // namespace racebeam
