// The sphere tracer on the bench at any level, as BenchKind wants it.
//
// A picture begins with a frame of the raster and a black store, so that what it counts does not
// depend on those before it: the CPU moves the spheres and sends its words, the tracer draws, and
// the rest of the words goes into the frame store. The picture is what is in it then.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sc/sphere/counters.h"
#include "tb/bench/benches.h"
#include "tb/host/sphere_program.h"

namespace racebeam {

/// BenchKind::make. `setting.scene` is a SphereProgram, or nullptr: the built-in scene.
std::unique_ptr<ChipBench> make_sphere_bench(const std::string& level,
                                             const WiredBench::Setting& setting,
                                             const BenchWishes& wishes);

const SphereProgram& sphere_program_of(const scene_tables* scene);

/// The columns and rows of a picture in the frame store `words`, by address; colour_bits a channel.
VgaFrame sphere_picture(int picture, const std::vector<std::uint64_t>& words, bool narrow,
                        const sphere_knobs& k, const BenchWishes& wishes);

}  // namespace racebeam
