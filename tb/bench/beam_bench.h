// The interval tracer on the bench at any level, as BenchKind wants it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/bench/benches.h"

namespace racebeam {

/// BenchKind::make.
std::unique_ptr<ChipBench> make_beam_bench(const std::string& level,
                                           const WiredBench::Setting& setting,
                                           const BenchWishes& wishes);

}  // namespace racebeam
