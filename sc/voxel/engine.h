// The voxel tracer as an engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/engine.h"

namespace racebeam {

const engine& voxel_engine();

}  // namespace racebeam
