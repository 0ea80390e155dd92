// What comparisons of model and RTL are told of the units of beam.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/knobs.h"
#include "sc/beam/scene_program.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

/// Plug-ins for chips with the knobs `k` that show `program`, which must outlive the maker;
/// nullptr: the built-in demo. `traced`: signals inside the RTL can be read.
PluginMaker beam_plugins(const knobs& k, const scene_program* program = nullptr,
                         bool traced = false);

/// The widths of a chip with the knobs `k`.
LegalInputs beam_inputs(const knobs& k);

}  // namespace racebeam
