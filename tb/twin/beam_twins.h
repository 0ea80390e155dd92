// What comparisons of model and RTL are told of the units of beam.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/engine.h"
#include "sc/beam/knobs.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

/// Plug-ins for chips with the knobs `k` that show `scene`, which must outlive the maker;
/// nullptr: the built-in demo. `traced`: signals inside the RTL can be read.
PluginMaker beam_plugins(const knobs& k, const scene_tables* scene = nullptr, bool traced = false);

/// The widths of a chip with the knobs `k`.
LegalInputs beam_inputs(const knobs& k);

/// Of scene_rom with the table of `scene`: mostly rooms that it has, and the one behind the last.
LegalInputs room_table_inputs(const knobs& k, const scene_tables* scene);

}  // namespace racebeam
