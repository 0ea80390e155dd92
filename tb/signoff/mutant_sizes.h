// How small a stream gets that finds a mutant: each difference that random traffic shows is shrunk,
// as `racebeam verify` does it, and the sizes are counted.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/signoff/mutant_fate.h"
#include "tb/signoff/mutant_streams.h"
#include "tb/signoff/unit_stimulus.h"

namespace racebeam {

/// Of each shrunk stream; sorted.
struct MutantSizes {
  std::vector<std::uint64_t> clocks;  ///< after the reset
  std::vector<std::uint64_t> moving;  ///< inputs that move
  std::size_t left = 0;  ///< those that do not differ when their last clocks begin anew
};

/// Of the mutants among `fates` that the `random` stream finds by an output. `done` is told how
/// many are. Throws RtlError, Interrupted.
MutantSizes mutant_sizes(const MutantStreams& streams, const RecordedStream& random,
                         const std::map<int, MutantFate>& fates, int jobs,
                         const std::function<void(std::size_t done, std::size_t of)>& told);

/// "median 3 clocks and 2 moving inputs, p99 20 and 5"
std::string text_of(const MutantSizes& sizes);
nlohmann::ordered_json to_json(const MutantSizes& sizes);

/// The least value that `percent` of all do not exceed; 0 of none.
std::uint64_t percentile(const std::vector<std::uint64_t>& sorted, int percent);

}  // namespace racebeam
