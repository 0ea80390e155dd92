// The voxel tracer on the bench: both levels alike.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/voxel_bench.h"

#include <gtest/gtest.h>

#include <vector>

#include "sc/voxel/engine.h"
#include "sc/voxel/voxel_world.h"
#include "tb/bench/voxel_signal_bench.h"
#include "tb/bench/voxel_tlm_bench.h"
#include "tests/support/frames_alike.h"

namespace racebeam {
namespace {

/// `tiny`, of 16 x 12 pixels, with craters.
VoxelProgram small_program() {
  VoxelProgram program = builtin_voxel_program();
  program.width = 16;
  program.height = 12;
  for (voxel_view& view : program.views)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      view.dx[axis] *= 4;
      view.dy[axis] *= 4;
    }
  program.views.push_back(program.views.front());
  program.views.back().origin[0] += 300;
  program.craters = {{1, 33, 20, 5, 3}, {2, 40, 22, 3, 6}, {2, 62, 63, 4, 2}};
  return program;
}

/// The same with roofs over every fourth column.
VoxelProgram roofed_program() {
  VoxelProgram program = small_program();
  for (std::size_t n = 0; n < program.columns.size(); n += 4) {
    voxel_column column = unpacked_column(program.columns[n]);
    column.middle = column.low + 6;
    column.high = column.low + 8;
    column.high_material = 3;
    program.columns[n] = packed(column);
  }
  return program;
}

voxel_knobs knobs_of(const VoxelProgram& program) { return voxel_engine().standard(&program); }

/// Pictures at both levels, those that do not follow reached at once.
void expect_levels_alike(const VoxelProgram& program, const std::vector<int>& pictures,
                         const voxel_knobs& k, const BenchWishes& wishes) {
  const WiredBench::Setting setting{voxel_engine(), k, &program, 100};
  VoxelTlmBench tlm(setting, wishes);
  VoxelSignalBench signal(setting, wishes);
  for (const int n : pictures) {
    tlm.seek(n);
    signal.seek(n);
    expect_same(voxel_engine(), signal.render(), tlm.render());
  }
}

TEST(VoxelBench, BothLevelsGiveTheSame) {
  const VoxelProgram program = small_program();
  expect_levels_alike(program, {0, 1}, knobs_of(program), {});
}

TEST(VoxelBench, BothLevelsShowTheSameAtThePinsOfAPictureReachedAtOnce) {
  const VoxelProgram program = small_program();
  expect_levels_alike(program, {2}, knobs_of(program), {true});
}

TEST(VoxelBench, BothLevelsGiveTheSameWithShadowsAndSlopes) {
  const VoxelProgram program = roofed_program();
  voxel_knobs k = knobs_of(program);
  k.shadows = 1;
  k.shading = VoxelShadingSlope;
  k.sky = VoxelSkyGradient;
  k.memory_clocks = 2;
  k.leaf_steps = 2;
  expect_levels_alike(program, {1, 2}, k, {});
}

TEST(VoxelBench, BothLevelsGiveTheSameWithGroupsAndSmallBuffers) {
  const VoxelProgram program = roofed_program();
  voxel_knobs k = knobs_of(program);
  k.group_fetch = 1;
  k.raise = VoxelRaiseAll;
  k.max_outer = k.max_inner = 12;
  k.debug_limits = 1;
  k.write_buffer_depth = 1;
  k.write_policy = WritePolicySync;
  expect_levels_alike(program, {1}, k, {true});
}

TEST(VoxelBench, BothLevelsGiveTheSameWithVoxelsThatAreHits) {
  const VoxelProgram program = roofed_program();
  voxel_knobs k = knobs_of(program);
  k.voxel_y = 1;
  k.leaf = VoxelLeafVoxel;
  k.levels = 3;
  expect_levels_alike(program, {1}, k, {});
}

TEST(VoxelBench, BothLevelsBuildChunksFrameByFrame) {
  const VoxelProgram program = small_program();
  voxel_knobs k = knobs_of(program);
  k.build_chunk = 1024;
  expect_levels_alike(program, {0}, k, {});
}

TEST(VoxelBench, APictureReachedAtOnceIsTheOneAfterAllOthers) {
  const VoxelProgram program = small_program();
  const WiredBench::Setting setting{voxel_engine(), knobs_of(program), &program, 100};
  VoxelTlmBench all(setting, {}), some(setting, {});
  std::vector<ChipBench::Frame> pictures;
  for (int n = 0; n < 4; ++n) pictures.push_back(all.render());
  for (const int n : {2, 1, 3, 0}) {
    some.seek(n);
    expect_same(voxel_engine(), some.render(), pictures[static_cast<std::size_t>(n)]);
  }
}

TEST(VoxelBench, TinyTakesTheClocksOfTheVectors) {
  const VoxelProgram& program = builtin_voxel_program();
  VoxelTlmBench bench({voxel_engine(), knobs_of(program), nullptr, 1}, {});
  const ChipBench::Frame frame = bench.render();
  const auto& infos = voxel_engine().counters;
  for (std::size_t n = 0; n < infos.size(); ++n) {
    if (infos[n].name == std::string("walk_clocks")) {
      EXPECT_EQ(frame.stats->counters[n], 312737u);
    }
  }
}

}  // namespace
}  // namespace racebeam
