// The voxel tracer on the bench at any level, as BenchKind wants it.
//
// A picture begins with a frame of the raster and a black store: the host sends what has changed,
// the builder builds it, and the picture is drawn. It is what is in the frame store then.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sc/voxel/counters.h"
#include "tb/bench/benches.h"
#include "tb/host/voxel_show.h"

namespace racebeam {

/// BenchKind::make. `setting.scene` is a VoxelProgram, or nullptr: the built-in scene.
std::unique_ptr<ChipBench> make_voxel_bench(const std::string& level,
                                            const WiredBench::Setting& setting,
                                            const BenchWishes& wishes);

/// What a bench makes of a picture in the frame store `words`, by address, and of what was counted.
ChipBench::Frame voxel_frame(int picture, const std::vector<std::uint64_t>& words,
                             const voxel_counters& counters, const voxel_knobs& k,
                             const BenchWishes& wishes);

}  // namespace racebeam
