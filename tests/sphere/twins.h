// On what the tests of the sphere tracer's units run: the model and the RTL of a unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "sc/sphere/sphere_parameters.h"
#include "sc/swap/rtl_twin.h"
#include "tb/twin/sphere_twins.h"

namespace racebeam {

/// The own RTL of a unit behind its pins; built with what the model's constructor takes.
template <class Unit>
struct own_sphere_rtl : rtl_twin<Unit> {
  explicit own_sphere_rtl(const sc_core::sc_module_name& name, const sphere_knobs& k = {},
                          const sphere_tables& tables = {})
      : rtl_twin<Unit>(name, sphere_parameters(k, tables),
                       sphere_plugins(k, tables).own(Unit::unit_name)) {}
  own_sphere_rtl(const sc_core::sc_module_name& name, const sphere_tables& tables)
      : own_sphere_rtl(name, {}, tables) {}
};

template <class Unit>
using sphere_twins = testing::Types<Unit, own_sphere_rtl<Unit>>;

}  // namespace racebeam
