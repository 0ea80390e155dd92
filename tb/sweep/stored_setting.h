// A stored point's setting, read back.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/base/knob_values.h"
#include "tb/sweep/sweep_file.h"

namespace racebeam {

/// The knobs that it names, and what it was compared with; others stay. False: it has values that
/// this program does not know.
bool read_setting(const std::string& text, knob_values& k, SweepReference& reference);

}  // namespace racebeam
