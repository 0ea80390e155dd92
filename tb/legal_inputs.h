// Input values that the chip's widths hold: ports are wider than the chip where a knob or a scene
// file may ask for more.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// `raw`, at least 0, or the value made of it that the chip can hold at the input `port`.
int legal_input(const std::string& port, int raw);

}  // namespace racebeam
