// What comparisons of model and RTL are told of the units of voxel.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/voxel/knobs.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

/// Plug-ins for voxel tracers with the knobs `k`. `traced`: signals inside the RTL can be read.
PluginMaker voxel_plugins(const voxel_knobs& k, bool traced = false);

/// What can come to the units of a voxel tracer.
LegalInputs voxel_inputs_of(const voxel_knobs& k);

}  // namespace racebeam
