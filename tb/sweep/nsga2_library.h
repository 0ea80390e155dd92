// Nsga2Library: what pagmo does for the program, opened when a sweep asks for nsga2.
//
// pagmo brings TBB and Boost.Serialization, and takes long to compile. It is behind
// libracebeam_search.so, a library of the program's own, which knows numbers and no sweeps.
//
// NSGA-II: K. Deb et al., A fast and elitist multiobjective genetic algorithm, 2002.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/sweep/value_indices.h"

namespace racebeam {

/// Points that are asked for at once.
using Generation = std::vector<ValueIndices>;
/// Their goals, by point; the smaller, the better. Finite, and the same whenever it is asked.
using Goals = std::vector<std::vector<double>>;

struct Nsga2Search {
  std::vector<std::size_t> values;  ///< how many a knob has; at least one knob has two
  std::size_t goals = 2;            ///< at least two
  int generations = 1;              ///< beside the first one
  std::uint32_t seed = 1;
};

struct Nsga2Library {
  std::string (*version)();  ///< of pagmo

  /// Asks for the goals of `first`, whose size is a multiple of 4 from 8 on, then for those of one
  /// generation of that size after the other. What `ask` answers decides what is asked next, and
  /// nothing else: who answers the same is asked the same. What `ask` throws ends the search.
  void (*search)(const Nsga2Search& search, const Generation& first,
                 const std::function<Goals(const Generation&)>& ask);
};

/// Opens it at the first call. Throws MissingTool if it or pagmo is not there.
const Nsga2Library& nsga2_library();

}  // namespace racebeam
