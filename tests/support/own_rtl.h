// The own RTL of a unit behind its pins, for tests that run on both twins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/knob_parameters.h"
#include "sc/swap/rtl_twin.h"
#include "tb/twin/beam_twins.h"

namespace racebeam {

template <class Unit>
struct own_rtl : rtl_twin<Unit> {
  explicit own_rtl(const sc_core::sc_module_name& name, const knobs& k = {})
      : rtl_twin<Unit>(name, knob_parameters(k), beam_plugins(k).own(Unit::unit_name)) {}
};

}  // namespace racebeam
