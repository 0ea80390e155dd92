// Engines without their chips, for readers that ask for knobs, names and units alone.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

/// What has been read is as it was promised; else the fuzzer has found something.
inline void check(bool good) {
  if (!good) std::abort();
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// With a name and knobs, and nothing to run.
inline engine stand_in_engine(const char* name, const std::vector<knob_row>& knobs,
                              std::vector<state_row> states = {}) {
  static const std::vector<unit_row> no_units;
  return {name,   "", {"tlm"},           "",      true,    no_units, knobs,   {},
          {},     {}, std::move(states), nullptr, nullptr, nullptr,  nullptr, nullptr,
          nullptr};
}

}  // namespace racebeam
