// Random traffic as it goes into a unit that is alone: it begins with the episodes that
// tb/twin/streams/ENGINE/UNIT.stream keeps, where there is one and no knob is set, since ports of
// other knobs can be others. `racebeam signoff` writes such files: each episode shows a mistake
// that random traffic finds late or not at all.
//
// A unit that counts frames is put to one: no episode is long enough to count there.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sc/base/unit.h"
#include "tb/twin/random_traffic.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

/// The path of a unit's known episodes; there may be no file.
std::string known_streams(const UnitUnderTest& dut);

/// For the model of `dut` on `bench`, before its first clock. Throws UsageError of a file of known
/// episodes that is not for this unit.
std::shared_ptr<RandomTraffic> random_traffic(const UnitUnderTest& dut, UnitBench& bench,
                                              unsigned seed);

/// When an episode of `traffic` begins, a `model` with a back door for it begins some frame of so
/// many, one in four times the last; `beside` is told which.
void seek_at_episodes(RandomTraffic& traffic, sc_core::sc_module& model, int frames,
                      const std::function<void(int frame)>& beside);

}  // namespace racebeam
