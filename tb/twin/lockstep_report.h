// What came out of a run with units in lockstep.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/monitor/raster.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/register_history.h"

namespace racebeam {

/// Where a compared clock lies in a run of whole frames; in that of a picture that took several,
/// the lines go on.
struct BeamPlace {
  int frame, line, clock;
};

/// `clock` counts from the one in reset that precedes the first of `frames`. A frame that is there
/// several times in a row is a picture of so many frames.
BeamPlace place_of(std::uint64_t clock, const std::vector<int>& frames, const Raster& raster);

/// "frame 7, line -3, clock 400, pixel 40"; a pixel only where one is shown.
std::string place_text(const BeamPlace& place, const Raster& raster);
/// The same, "picture 7, clock 223400": clocks from the frame with which it begins.
std::string picture_text(const BeamPlace& place, const Raster& raster);

/// What goes with a difference.
struct DifferenceContext {
  std::string where;   ///< "in frame 7, ...", or "of random traffic"
  std::string repeat;  ///< the command that shows it again
  std::string closer;  ///< the command that traces all signals around it; empty: none
  std::string window;  ///< file of the waveform; empty: none
  std::string knobs;   ///< "default", or those that are not
  const RegisterHistory* registers = nullptr;  ///< of both sides, if they were taken
};

/// A command that traces all signals around a difference, looked for from `from` on. `rest`: --use
/// and --set as they were given.
std::string trace_command(const std::string& scene, const std::string& from,
                          const std::string& unit, const std::string& rest);

/// The first difference explained: unit, port, place, values, the clocks of both sides, knobs,
/// and for racebeam_top whether a unit or the wiring is at fault.
std::string explain(const LockstepDifference& difference, const DifferenceContext& context);
/// That on stderr, in colours if it is to have them.
void tell_difference(const std::string& explanation);

}  // namespace racebeam
