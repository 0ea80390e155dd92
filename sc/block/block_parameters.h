// The block renderer's knobs as the RTL of its units knows them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/block/knobs.h"
#include "sc/swap/rtl_parameters.h"

namespace racebeam {

std::vector<rtl_parameter> block_parameters(const block_knobs& k);

}  // namespace racebeam
