// What comparisons of model and RTL are told of the units of block.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/block/knobs.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

/// Plug-ins for block renderers with the knobs `k`. `traced`: signals inside the RTL can be read.
PluginMaker block_plugins(const block_knobs& k, bool traced = false);

/// What can come to the units of a block renderer.
LegalInputs block_inputs_of(const block_knobs& k);

}  // namespace racebeam
