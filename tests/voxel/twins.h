// On what the tests of the voxel tracer's units run: the model and the RTL of a unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "sc/swap/rtl_twin.h"
#include "sc/voxel/voxel_parameters.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

/// The own RTL of a unit behind its pins; built with what the model's constructor takes.
template <class Unit>
struct own_voxel_rtl : rtl_twin<Unit> {
  explicit own_voxel_rtl(const sc_core::sc_module_name& name, const voxel_knobs& k = {})
      : rtl_twin<Unit>(name, voxel_parameters(k),
                       PluginMaker(voxel_parameters(k)).own(Unit::unit_name)) {}
};

template <class Unit>
using voxel_twins = testing::Types<Unit, own_voxel_rtl<Unit>>;

}  // namespace racebeam
