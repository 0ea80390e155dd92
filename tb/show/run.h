// A run of the chip: what the command line says of it, and what that opens.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/unit_choices.h"
#include "tb/show/level.h"
#include "tb/show/show.h"
#include "tb/twin/engine_raster.h"

namespace racebeam {

/// As it was written.
struct RunOptions {
  std::string scene;                     ///< demo, or a scene file
  std::string engine;                    ///< that the scene must be for; empty: any
  std::string level;                     ///< empty: what the run needs
  std::vector<std::string> assignments;  ///< knob=value
  std::vector<std::string> units;        ///< unit=implementation

  /// " --set knob=value" for each knob, for a command that repeats the run.
  std::string set_text() const;
};

struct Run {
  Show show;
  std::string level;
  knob_values k;
  unit_choices units{};

  Raster raster() const { return raster_of(show.engine(), k); }
};

/// The knobs of a show, and of the command line. Throws UsageError, also if they do not go
/// together.
knob_values knobs_of(const Show& show, const std::vector<std::string>& assignments);

/// All but the units. Without a level it is signal if there are units, or if the run is `wired` for
/// another reason, else tlm. Throws UsageError.
Run open_run(const RunOptions& options, bool wired = false);

/// Puts the units of the command line into the run: verilates. `traced`: signals inside the RTL can
/// be read. Throws UsageError, RtlError, MissingTool.
void use_units(Run& run, const std::vector<std::string>& units, bool traced = false,
               bool islands = true);

}  // namespace racebeam
