// Random traffic of a unit that counts frames: no episode is long enough to count there, so it is
// put to one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "sc/base/unit.h"
#include "tb/twin/random_traffic.h"

namespace racebeam {

/// When an episode of `traffic` begins, a `model` with a back door for it begins some frame of so
/// many, one in four times the last; `beside` is told which.
void seek_at_episodes(RandomTraffic& traffic, sc_core::sc_module& model, int frames,
                      const std::function<void(int frame)>& beside);

}  // namespace racebeam
