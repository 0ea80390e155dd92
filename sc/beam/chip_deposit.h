// What the registers of the whole chip in RTL have at the start of a frame (back door).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sc/beam/navigator.h"

namespace racebeam {

/// By the names of signals inside racebeam_top; `place`: the navigator in that frame. The other
/// registers carry nothing from frame to frame.
std::vector<std::pair<std::string, std::uint64_t>> chip_deposits(int frame,
                                                                 const navigator_core& place);

}  // namespace racebeam
