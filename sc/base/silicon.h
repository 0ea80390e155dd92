// silicon: what an engine is made of beside gates, and how its counters tell what that did.
//
// What `racebeam compare` prints of all engines comes from these tables. A formula is over counters
// of the engine by their names, sums of its lines, bins of its histograms ("shades_by_pass_0"), its
// knobs, the things of a scene, and rows before it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

struct memory_row {
  enum use {
    Working,  ///< queues, stacks, tables that the tracer fills or empties
    Picture,  ///< the picture store, outside
    Scene     ///< what is to be drawn, if it is not gates or in the above
  };
  std::string name;
  use used;
  std::uint64_t bits;
};

struct multiplier_row {
  std::string name;
  int count, a_bits, b_bits;
  int cut = 0;  ///< its partial products below 2^cut are left out

  /// Of one of them.
  int partial_products() const {
    int kept = 0;
    for (int a = 0; a < a_bits; ++a) kept += std::max(0, b_bits - std::max(0, cut - a));
    return kept;
  }
};

/// The names that all engines have are quantities(); others are steps on the way.
struct quantity_row {
  std::string name, formula;  ///< an empty formula: the engine has no such thing
};

/// A number of the scene: "spheres".
struct scene_number {
  std::string name;
  double value;
};

/// Of a chip with some knobs, that shows some scene.
struct silicon {
  std::vector<memory_row> memories;
  std::vector<multiplier_row> multipliers;
  /// Registers, the sound's not, as each_register() names them; 0: not all of them are named.
  std::uint64_t register_bits = 0;
  int roots = 0;     ///< units that find a root
  int dividers = 0;  ///< and a quotient
  std::vector<scene_number> scene;
  std::vector<quantity_row> quantities;

  /// Of all multipliers.
  std::uint64_t partial_products() const {
    std::uint64_t sum = 0;
    for (const multiplier_row& row : multipliers)
      sum += static_cast<std::uint64_t>(row.count) *
             static_cast<std::uint64_t>(row.partial_products());
    return sum;
  }
  std::uint64_t bits(memory_row::use used) const {
    std::uint64_t sum = 0;
    for (const memory_row& row : memories) sum += row.used == used ? row.bits : 0;
    return sum;
  }
};

}  // namespace racebeam
