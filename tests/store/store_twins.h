// The own RTL of the frame store's units behind their pins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/store/store_parameters.h"
#include "sc/swap/rtl_twin.h"
#include "tb/twin/plugin_maker.h"

namespace racebeam {

inline std::string store_plugin(const std::string& unit, const store_knobs& k) {
  return PluginMaker(store_parameters(k)).own(unit);
}

template <class Unit>
struct own_store_rtl : rtl_twin<Unit> {
  explicit own_store_rtl(const sc_core::sc_module_name& name, const store_knobs& k = {})
      : rtl_twin<Unit>(name, store_parameters(k), store_plugin(Unit::unit_name, k)) {}
};

// The settings that the tests share: each is verilated once.

/// The formats as engines use them; 64, 31 and 64 entries.
inline store_knobs rgb_light() { return {}; }
inline store_knobs rgb888() {
  store_knobs k;
  k.store_format = StoreRgb888;
  k.picture_width = 640;
  k.write_buffer_depth = 31;
  k.write_policy = WritePolicyFree;
  return k;
}
inline store_knobs planar() {
  store_knobs k;
  k.store_format = StorePlanar;
  k.picture_width = 640;
  k.write_policy = WritePolicyBlanking;
  return k;
}

inline store_knobs wrapped() {
  store_knobs k;
  k.wrap_right = 1;
  k.colour_bits = 8;
  return k;
}
inline store_knobs wide_light() {
  store_knobs k;
  k.picture_width = 640;
  return k;
}
inline store_knobs narrow_planar() {
  store_knobs k = planar();
  k.picture_width = 512;
  k.write_buffer_depth = 128;
  k.when_full = WhenFullDrop;
  return k;
}
inline store_knobs entries(int depth, int when_full = WhenFullStall) {
  store_knobs k;
  k.write_buffer_depth = depth;
  k.when_full = when_full;
  return k;
}

}  // namespace racebeam
