// Knobs from the command line: "name=value".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/knobs.h"

namespace racebeam {

/// Sets one knob from "name=value". Throws UsageError, which names the nearest knob or the range.
void set_knob(knobs& k, const std::string& assignment);

}  // namespace racebeam
