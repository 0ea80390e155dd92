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
#include "sc/base/knob_values.h"
#include "sc/base/unit_choices.h"

namespace sc_core {
class sc_module;
}

namespace racebeam {

class wired_chip;
struct rtl_parameter;

/// What a scene file becomes in the memories of an engine: each has a kind of its own.
struct scene_tables {};

struct unit_row {
  enum use { Always, Demo, SceneFile };  // some show scene files, or the built-in demo, only
  const char* name;
  const char* slot;  ///< its place in the chip: the name of the unit that usually has it
  use shows;
  /// The model; `scene` is not looked at by units that show any chip.
  std::unique_ptr<sc_core::sc_module> (*make)(const char* instance, const knob_values& k,
                                              const scene_tables* scene);
  const char* place = "";  ///< modules around it in the chip: "g_core[0]."; of many, the first

  std::string instance() const { return std::string("u_") + slot; }
  std::string path() const { return place + instance(); }
};

/// The words of a register that holds a state, by value.
struct state_row {
  const char* path;  ///< "u_subdivider.state_q"
  std::vector<std::string> words;
};

/// How a chip clocks the VGA raster.
struct video_clocks {
  int clocks_per_pixel;
  int speed = 0;  ///< input pins that make pixels shorter
};

struct engine {
  const char* name;
  const char* meaning;              ///< "interval tracer that races the beam"
  std::vector<const char*> levels;  ///< "tlm", "signal": the first one if nobody says
  const char* top;                  ///< all units wired in RTL: beside the chip only, in lockstep
  /// A picture is a frame of the raster. Else it takes as many clocks as it takes, and frames show
  /// what is in a store.
  bool races_beam;
  const std::vector<unit_row>& units;  ///< in the order of the datapath
  const std::vector<knob_row>& knobs;
  std::vector<counter_info> counters;
  std::vector<histogram_info> histograms;
  std::vector<line_info> lines;
  std::vector<state_row> states;
  /// The knobs of the chip as it was built, with what a scene asks for. Here and below: `scene`
  /// nullptr is the built-in demo.
  knob_values (*standard)(const scene_tables* scene);
  /// Knobs that others bound get the value that counts; what is to be told of it, or "".
  std::string (*settle)(knob_values& k);
  /// Knobs that a scene cannot be run with: what is wrong and what to do; or "".
  std::string (*objection)(const knob_values& k, const scene_tables* scene);
  video_clocks (*video)(const knob_values& k);
  /// `scene` outlives the chip and fits the knobs. Throws RtlError.
  std::unique_ptr<wired_chip> (*make_signal)(const char* name, const knob_values& k,
                                             const scene_tables* scene,
                                             const unit_choices& choices);
  /// The knobs as the RTL of its units knows them.
  std::vector<rtl_parameter> (*parameters)(const knob_values& k);

  /// The units of a chip that shows the built-in demo, or a scene file.
  std::vector<std::string> unit_names(bool scene_file) const;
  /// nullptr: it has no such unit.
  const unit_row* unit(const std::string& name) const;
};

}  // namespace racebeam
