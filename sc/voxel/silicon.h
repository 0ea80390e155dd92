// What the voxel tracer is made of beside gates, and how its counters tell what that did.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/engine.h"
#include "sc/base/silicon.h"

namespace racebeam {

/// `scene`: as engine::standard.
silicon voxel_silicon(const knob_values& k, const scene_tables* scene);

}  // namespace racebeam
