// What came out of a run with units in lockstep.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/lockstep.h"
#include "tb/raster.h"

namespace racebeam {

/// Where a compared clock lies in a run of whole frames.
struct BeamPlace {
  int frame, line, clock;
};

/// `clock` counts from the one in reset that precedes the first of `frames`.
BeamPlace place_of(std::uint64_t clock, const std::vector<int>& frames, const Raster& raster);

/// The first difference explained: unit, port, place, values, the last clocks of both sides.
/// `repeat` is the command that shows it again.
std::string explain(const LockstepDifference& difference, const std::vector<int>& frames,
                    const Raster& raster, const std::string& repeat);

}  // namespace racebeam
