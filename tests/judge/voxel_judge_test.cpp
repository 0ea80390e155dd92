// Pictures of the voxel tracer beside exact columns.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/voxel_judge.h"

#include <gtest/gtest.h>

#include "sc/voxel/engine.h"
#include "tb/bench/voxel_tlm_bench.h"
#include "tb/golden/voxel_golden.h"
#include "tb/host/voxel_pinhole.h"
#include "tb/scene/voxel_terrain.h"

namespace racebeam {
namespace {

constexpr int Step = 4;

VoxelProgram seen_from_above(const std::vector<std::uint32_t>& columns) {
  VoxelProgram program;
  program.size = {256, 256, 128};
  program.columns = columns;
  program.width = 160;
  program.height = 120;
  for (std::size_t n = 0; n < program.palette.size(); ++n)
    program.palette[n] = static_cast<int>(n) * 0x010203;
  VoxelPinhole pinhole;
  pinhole.position = {128, 0, 150};
  pinhole.pitch = 114;
  pinhole.focal_length = 80;
  program.views = {pinhole_view(pinhole, program.width, program.height, program.size)};
  return program;
}

std::vector<VoxelProgram> terrains() {
  return {seen_from_above(hills_terrain({256, 256, 128}, {2, 5, 900, true})),
          seen_from_above(hills_terrain({256, 256, 128}, {3, 7, 300, false})),
          seen_from_above(canyon_terrain({256, 256, 128}, {}))};
}

voxel_knobs unlimited(const VoxelProgram& program) {
  voxel_knobs k = voxel_engine().standard(&program);
  k.max_outer = k.max_inner = 1023;
  return k;
}

VgaFrame drawn(const VoxelProgram& program, const voxel_knobs& k) {
  VoxelTlmBench bench({voxel_engine(), k, &program, 1}, {});
  return bench.render().picture;
}

double wrong(const VoxelProgram& program, const voxel_knobs& k) {
  const PictureErrors errors = voxel_golden_errors(&program, k, 0, drawn(program, k), Step);
  return static_cast<double>(errors.wrong_hits) / static_cast<double>(errors.pixels);
}

TEST(VoxelJudge, VoxelsThatAreHitsShowTheExactColumns) {
  for (const VoxelProgram& program : terrains()) {
    voxel_knobs k = unlimited(program);
    k.voxel_y = 1;
    k.leaf = VoxelLeafVoxel;
    EXPECT_LE(wrong(program, k), 0.002);
  }
}

TEST(VoxelJudge, MoreSamplesAreNearerToTheExactColumns) {
  for (const VoxelProgram& program : terrains()) {
    voxel_knobs k = unlimited(program);
    const double one = wrong(program, k);
    k.leaf_steps = 2;
    const double two = wrong(program, k);
    std::printf("%f %f\n", one, two);
    k.leaf_steps = 8;
    EXPECT_LT(wrong(program, k), two);
    EXPECT_LT(two, one);
    EXPECT_LT(two, 0.10);
  }
}

TEST(VoxelJudge, GroupsOfBitsChangeNoPixel) {
  for (const VoxelProgram& program : terrains()) {
    voxel_knobs k = unlimited(program);
    const VgaFrame all = drawn(program, k);
    k.group_fetch = 1;
    EXPECT_TRUE(drawn(program, k).colours == all.colours);
  }
}

TEST(VoxelJudge, NoRayThatMeetsSomethingPassesToTheSky) {
  for (const VoxelProgram& program : terrains()) {
    const voxel_knobs k = unlimited(program);
    VoxelShow show(program, k);
    show.go_to(0);
    show.next();
    const std::vector<int> hits = voxel_first_hits(show, k), exact = voxel_golden_hits(show, k);
    int passed = 0;
    for (std::size_t n = 0; n < hits.size(); ++n) passed += hits[n] < 0 && exact[n] >= 0;
    EXPECT_EQ(passed, 0);
  }
}

TEST(VoxelJudge, ColoursAreTheGoldenOnesWhereTheColumnIs) {
  VoxelProgram program = terrains().front();
  voxel_knobs k = unlimited(program);
  k.voxel_y = 1;
  k.leaf = VoxelLeafVoxel;
  k.sky = VoxelSkyGradient;
  for (const int shading : {VoxelShadingHeight, VoxelShadingSlope}) {
    k.shading = shading;
    const PictureErrors errors = voxel_golden_errors(&program, k, 0, drawn(program, k), 1);
    EXPECT_LE(errors.differing, errors.pixels / 100);
  }
}

TEST(VoxelJudge, LimitsAreMagenta) {
  const VoxelProgram program = terrains().front();
  voxel_knobs k = voxel_engine().standard(&program);
  k.max_outer = 12;
  k.debug_limits = 1;
  const VgaFrame picture = drawn(program, k);
  int magenta = 0;
  for (std::size_t n = 0; n < picture.pixels(); ++n) magenta += picture.colour(n) == 0xff00ff;
  EXPECT_GT(magenta, static_cast<int>(picture.pixels()) / 20);
}

}  // namespace
}  // namespace racebeam
