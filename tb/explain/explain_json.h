// An explanation for programs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/explain/explanation.h"

namespace racebeam {

/// Schema "racebeam-explain" version 1: what explain_text says, with the knobs. `repeat` as there.
std::string explain_json(const Explanation& e, const knobs& k, const std::string& repeat);

}  // namespace racebeam
