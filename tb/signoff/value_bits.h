// What the bits of several values have in common.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <utility>

namespace racebeam {

/// The bits that are 1 in all of them, and those that are in any.
inline std::pair<unsigned, unsigned> bits_of(const std::set<unsigned>& values) {
  unsigned all = ~0u, any = 0;
  for (const unsigned value : values) all &= value, any |= value;
  return {all, any};
}

}  // namespace racebeam
