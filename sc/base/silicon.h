// silicon: what an engine is made of beside gates, and how its counters tell what that did.
//
// What `racebeam compare` prints of all engines comes from these tables. A formula is over counters
// of the engine by their names, sums of its lines, bins of its histograms ("shades_by_pass_0"), its
// knobs, the things of a scene, and rows before it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  int roots = 0;     ///< units that find a root
  int dividers = 0;  ///< and a quotient
  std::vector<scene_number> scene;
  std::vector<quantity_row> quantities;

  std::uint64_t bits(memory_row::use used) const {
    std::uint64_t sum = 0;
    for (const memory_row& row : memories) sum += row.used == used ? row.bits : 0;
    return sum;
  }
};

}  // namespace racebeam
