// The row of the interval tracer in sources().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/view/sources.h"

namespace racebeam {

SourceKind beam_sources();

}  // namespace racebeam
