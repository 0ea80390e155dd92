// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/benches.h"

#include <stdexcept>

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/bench/beam_bench.h"
#include "tb/bench/block_bench.h"
#include "tb/bench/block_hands.h"
#include "tb/bench/block_tlm_bench.h"
#include "tb/bench/sphere_bench.h"
#include "tb/bench/sphere_hands.h"
#include "tb/bench/sphere_tlm_bench.h"
#include "tb/bench/voxel_bench.h"
#include "tb/bench/voxel_hands.h"
#include "tb/bench/voxel_tlm_bench.h"

namespace racebeam {

const std::vector<BenchKind>& benches() {
  static const std::vector<BenchKind> table = {
      {beam_engine(), true, true, make_beam_bench, nullptr, nullptr},
      {sphere_engine(), false, false, make_sphere_bench, make_sphere_hands, sphere_pixels},
      {block_engine(), false, false, make_block_bench, make_block_hands, block_pixels},
      {voxel_engine(), false, false, make_voxel_bench, make_voxel_hands, voxel_pixels}};
  return table;
}

const BenchKind& bench_of(const engine& built) {
  for (const BenchKind& kind : benches())
    if (&kind.engine == &built) return kind;
  throw std::out_of_range(std::string("no bench for ") + built.name);
}

}  // namespace racebeam
