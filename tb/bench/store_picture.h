// The picture that lies in a frame store.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/store/store_knobs.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// With 8 bits a colour, as large as the knobs say; `words` by address.
VgaFrame rgb888_picture(int picture, const std::vector<std::uint64_t>& words, const store_knobs& k);

}  // namespace racebeam
