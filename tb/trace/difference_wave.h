// The clocks around the first difference of a unit in lockstep as a waveform with a save file.
//
// What the model and the chip around it have lies where `racebeam trace` has it, what the RTL has
// under `.rtl`: chip.u_stacks.tag_o, chip.u_stacks.rtl.tag_o. `rtl.differs` is 1 in clocks in which
// some output differs. The save file has the differing port on top, and its marker there.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/monitor/raster.h"
#include "tb/show/show.h"
#include "tb/twin/lockstep.h"

namespace racebeam {

/// The frames of a show that a chip was put through.
struct DrivenFrames {
  const Show& show;
  const Raster& raster;
  const std::vector<int>& numbers;
};

/// Writes FOLDER/<unit>_chip.vcd and .gtkw, on the time axis of the frame: as far as the clocks
/// belong to it or to frames beside it. Returns the name of the waveform. Throws OutputError.
std::string save_chip_window(const LockstepDifference& difference, const DrivenFrames& frames,
                             const knob_values& k, const std::string& folder);

/// The same of a unit alone, FOLDER/<unit>_<traffic>.vcd; time 0 is the first clock of the traffic.
std::string save_unit_window(const LockstepDifference& difference, const std::string& traffic,
                             const knob_values& k, const std::string& folder);

}  // namespace racebeam
