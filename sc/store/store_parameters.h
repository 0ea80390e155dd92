// The frame store's knobs as the RTL of its units knows them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/store/store_knobs.h"
#include "sc/swap/rtl_parameters.h"

namespace racebeam {

/// One for each parameter that a unit of the frame store may have: WriteBufferDepth, WritePolicy,
/// WhenFull, WrapRight, StoreFormat, ColourBits, PictureWidth, PictureHeight, AddressBits,
/// DataBits.
std::vector<rtl_parameter> store_parameters(const store_knobs& k);

}  // namespace racebeam
