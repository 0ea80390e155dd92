// On what the tests of the block renderer's units run: the model and the RTL of a unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "sc/block/block_parameters.h"
#include "sc/swap/rtl_twin.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

/// The own RTL of a unit behind its pins; built with what the model's constructor takes.
template <class Unit>
struct own_block_rtl : rtl_twin<Unit> {
  explicit own_block_rtl(const sc_core::sc_module_name& name, const block_knobs& k = {})
      : rtl_twin<Unit>(name, block_parameters(k),
                       PluginMaker(block_parameters(k)).own(Unit::unit_name)) {}
};

template <class Unit>
using block_twins = testing::Types<Unit, own_block_rtl<Unit>>;

}  // namespace racebeam
