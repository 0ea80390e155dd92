// An explanation for people.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/explain/explanation.h"

namespace racebeam {

/// Some aligned lines, and a table of all steps at the end. `repeat` is the command line's scene
/// and knobs, for the command that traces the pixel.
std::string explain_text(const Explanation& e, const std::string& repeat);

}  // namespace racebeam
