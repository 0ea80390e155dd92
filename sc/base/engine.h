// engine: a way to trace rays in hardware, as one row of tables. What works with any engine asks
// its row, and names none.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sc/base/frame_counts.h"
#include "sc/base/unit_choices.h"

namespace sc_core {
class sc_module;
}

namespace racebeam {

class wired_chip;
struct knobs;
struct rtl_parameter;

/// What a scene file becomes in the memories of an engine: each has a kind of its own.
struct scene_tables {};

struct unit_row {
  enum use { Always, Demo, SceneFile };  // some show scene files, or the built-in demo, only
  const char* name;
  const char* slot;  ///< its place in the chip: the name of the unit that usually has it
  use shows;
  /// The model; `scene` is not looked at by units that show any chip.
  std::unique_ptr<sc_core::sc_module> (*make)(const char* instance, const knobs& k,
                                              const scene_tables* scene);

  std::string instance() const { return std::string("u_") + slot; }
};

/// The words of a register that holds a state, by value.
struct state_row {
  const char* path;  ///< "u_subdivider.state_q"
  std::vector<std::string> words;
};

struct engine {
  const char* name;
  std::vector<const char*> levels;  ///< "tlm", "signal": the first one if nobody says
  const char* top;                  ///< all units wired in RTL: beside the chip only, in lockstep
  const std::vector<unit_row>& units;  ///< in the order of the datapath
  std::vector<counter_info> counters;
  std::vector<histogram_info> histograms;
  std::vector<line_info> lines;
  std::vector<state_row> states;
  /// `scene`: nullptr is the built-in demo; it outlives the chip and fits the knobs. Throws
  /// RtlError.
  std::unique_ptr<wired_chip> (*make_signal)(const char* name, const knobs& k,
                                             const scene_tables* scene,
                                             const unit_choices& choices);
  /// The knobs as the RTL of its units knows them.
  std::vector<rtl_parameter> (*parameters)(const knobs& k);

  /// The units of a chip that shows the built-in demo, or a scene file.
  std::vector<std::string> unit_names(bool scene_file) const;
  /// nullptr: it has no such unit.
  const unit_row* unit(const std::string& name) const;
};

}  // namespace racebeam
