// The block renderer on the bench at any level, as BenchKind wants it.
//
// A picture begins with a frame of the raster and a black store, so that what it counts does not
// depend on those before it: the host sends the scene and starts, the cores draw, and the rest of
// the words goes into the frame store. The picture is what is in it then; the load bar is the
// host's, drawn over it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sc/block/counters.h"
#include "tb/bench/benches.h"
#include "tb/host/block_program.h"
#include "tb/host/load_bar.h"

namespace racebeam {

/// BenchKind::make. `setting.scene` is a BlockProgram, or nullptr: the built-in scene.
std::unique_ptr<ChipBench> make_block_bench(const std::string& level,
                                            const WiredBench::Setting& setting,
                                            const BenchWishes& wishes);

/// What a bench makes of a picture in the frame store `words`, by address, and of what was counted.
ChipBench::Frame block_frame(int picture, const std::vector<std::uint64_t>& words,
                             const block_counters& counters, const block_knobs& k, LoadBar& bar,
                             const BenchWishes& wishes);

}  // namespace racebeam
