// The sphere tracer on the bench: the design's vectors as rendered pictures, and both levels alike.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/sphere_bench.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "sc/sphere/engine.h"
#include "tb/bench/sphere_signal_bench.h"
#include "tb/bench/sphere_tlm_bench.h"
#include "tb/scene/sphere_scene.h"
#include "tests/sphere/picture_checksum.h"
#include "tests/support/frames_alike.h"

namespace racebeam {
namespace {

constexpr int Key2 = 1 << 2;

std::shared_ptr<const AnyScene> scene_of(const std::string& name) {
  const AnySceneResult result =
      read_any_scene_file(RACEBEAM_SOURCE_DIR "/scenes/sphere/" + name + ".toml");
  EXPECT_TRUE(result.scene) << result.faults.text(name);
  EXPECT_EQ(result.faults.warnings(name), "");
  return result.scene;
}

const SphereProgram& program_of(const AnyScene& scene) {
  return static_cast<const SphereProgram&>(scene.tables());
}

WiredBench::Setting setting_of(const SphereProgram& program, int pictures,
                               const sphere_knobs& k = {}) {
  return {sphere_engine(), k, &program, pictures};
}

std::uint64_t counter(const ChipBench::Frame& frame, const std::string& name) {
  const auto& infos = sphere_engine().counters;
  for (std::size_t n = 0; n < infos.size(); ++n)
    if (infos[n].name == name) return frame.stats->counters[n];
  ADD_FAILURE() << "no counter " << name;
  return 0;
}

struct Sums {
  std::uint64_t clocks, rays, shadow_rays, roots, sphere_tests, passes, overflows;
  std::uint32_t checksum;
};

/// Renders scene four with so many reflections, with planes or without.
template <class Bench>
void expect_four(int reflections, bool planes, const Sums& sums) {
  const auto scene = scene_of("four");
  SphereProgram program = program_of(*scene);
  program.modes = 1 << 5 | reflections << 2;
  program.set_start(planes);
  Bench bench(setting_of(program, 1), {});
  const ChipBench::Frame frame = bench.render();
  EXPECT_EQ(frame.time.clocks, sums.clocks);
  EXPECT_EQ(counter(frame, "clocks"), sums.clocks);
  EXPECT_EQ(counter(frame, "primary_rays") + counter(frame, "reflected_rays"), sums.rays);
  EXPECT_EQ(counter(frame, "shadow_rays"), sums.shadow_rays);
  EXPECT_EQ(counter(frame, "roots"), sums.roots);
  EXPECT_EQ(counter(frame, "sphere_tests"), sums.sphere_tests);
  EXPECT_EQ(counter(frame, "passes"), sums.passes);
  EXPECT_EQ(counter(frame, "overflows"), sums.overflows);
  EXPECT_EQ(counter(frame, "host_clocks"), 90U) << "45 words of 2 clocks; valid falls later";
  EXPECT_EQ(picture_checksum(bench.words(), 512, 480), sums.checksum);
  EXPECT_EQ(frame.picture.width, 512);
  EXPECT_EQ(frame.picture.height, 480);
  EXPECT_EQ(frame.picture.bits, 5);
  EXPECT_TRUE(frame.picture.whole());
}

const Sums Plain{9000673, 245760, 10666, 268240, 1259426, 11814, 0, 0xb8c354c2};
const Sums Reflections{9425850, 257568, 11839, 282412, 1320866, 13003, 0, 0x38209886};
const Sums Planes{79822445, 973420, 966405, 1976130, 8528588, 968255, 24469, 0xb9cbe708};

TEST(SphereBench, PlainPictureOfFour) { expect_four<SphereTlmBench>(0, false, Plain); }
TEST(SphereBench, PictureOfFourWithReflections) {
  expect_four<SphereTlmBench>(3, false, Reflections);
}
TEST(SphereBench, PictureOfFourWithReflectionsAndPlanes) {
  expect_four<SphereTlmBench>(3, true, Planes);
}
TEST(LongSphereBench, PlainPictureOfFourAtSignal) {
  expect_four<SphereSignalBench>(0, false, Plain);
}
TEST(LongSphereBench, PictureOfFourWithReflectionsAtSignal) {
  expect_four<SphereSignalBench>(3, false, Reflections);
}
TEST(LongSphereBench, PictureOfFourWithReflectionsAndPlanesAtSignal) {
  expect_four<SphereSignalBench>(3, true, Planes);
}

TEST(SphereBench, APictureReachedAtOnceIsTheOneAfterAllOthers) {
  const auto scene = scene_of("bounce");
  const auto setting = setting_of(program_of(*scene), scene->frames());
  SphereTlmBench all(setting, {}), some(setting, {});
  std::vector<ChipBench::Frame> pictures;
  for (int n = 0; n < 9; ++n) pictures.push_back(all.render());
  for (const int n : {8, 3, 0}) {
    some.seek(n);
    expect_same(sphere_engine(), some.render(), pictures[static_cast<std::size_t>(n)]);
  }
}

TEST(SphereBench, TheShowStartsAgain) {
  const auto scene = scene_of("bounce");
  SphereTlmBench bench(setting_of(program_of(*scene), 2), {});
  const ChipBench::Frame first = bench.render();
  bench.render();
  expect_same(sphere_engine(), bench.render(), first);
}

TEST(SphereBench, EightPicturesOfTheGalleryDiffer) {
  const auto scene = scene_of("gallery");
  ASSERT_EQ(scene->frames(), 8);
  SphereTlmBench bench(setting_of(program_of(*scene), 8), {true});
  std::set<std::uint32_t> pictures, pins;
  for (int n = 0; n < 8; ++n) {
    const ChipBench::Frame frame = bench.render();
    pictures.insert(frame.picture.image_crc);
    pins.insert(frame.picture.pins_crc);
  }
  EXPECT_EQ(pictures.size(), 8U);
  EXPECT_EQ(pins.size(), 8U);
}

TEST(SphereBench, TheEyeInASphereSeesBlackIn17ClocksAPixel) {
  const auto scene = scene_of("inside");
  SphereTlmBench bench(setting_of(program_of(*scene), scene->frames()), {});
  const ChipBench::Frame inside = bench.render();
  EXPECT_EQ(inside.time.clocks, 320U * 240 * 17);
  EXPECT_EQ(counter(inside, "black_inside"), 320U * 240);
  EXPECT_THAT(inside.picture.colours, testing::Each(0));
  bench.seek(scene->frames() - 1);
  EXPECT_EQ(counter(bench.render(), "black_inside"), 0U) << "the ball has gone by";
}

/// A scene small enough for the signal level: two small balls, and hands at the board.
SphereProgram small_program() {
  SphereProgram program;
  program.modes = 1 << 2;
  MovingSphere ball;
  ball.centre = {-3, 0.5, 10};
  ball.velocity = {0.5, 0.25, -0.125};
  ball.radius = 4;
  ball.colour = {31, 8, 2};
  ball.reflect = 0x800;
  program.moving.push_back(ball);
  program.spheres = 1;
  program.inputs = {{0, 1, 1 << 16 | 1 << 7 | 1 << 6, 1}, {1, 1, 0, Key2 | 1 << 3}};
  program.set_start(false);
  return program;
}

/// Pictures at both levels, the last one reached at once.
void expect_levels_alike(const SphereProgram& program, const std::vector<int>& pictures,
                         const sphere_knobs& k, const BenchWishes& wishes) {
  const auto setting = setting_of(program, 100, k);
  SphereTlmBench tlm(setting, wishes);
  SphereSignalBench signal(setting, wishes);
  for (const int n : pictures) {
    tlm.seek(n);
    signal.seek(n);
    expect_same(sphere_engine(), signal.render(), tlm.render());
  }
}

TEST(SphereBench, BothLevelsGiveTheSame) { expect_levels_alike(small_program(), {0, 1}, {}, {}); }

TEST(SphereBench, BothLevelsShowTheSameAtThePins) {
  expect_levels_alike(small_program(), {3}, {}, {true});
}

TEST(SphereBench, BothLevelsGiveTheSameWithOtherKnobs) {
  sphere_knobs k;
  k.colour_bits = 8;
  k.write_buffer_depth = 8;
  k.when_full = WhenFullDrop;
  k.host_clocks_per_word = 7;
  k.wide = 1;
  expect_levels_alike(small_program(), {2}, k, {true});
}

class LongSphereScenes : public testing::TestWithParam<const char*> {};

// The small picture, a ray a pixel: minutes are enough.
TEST_P(LongSphereScenes, BothLevelsGiveTheSame) {
  const auto scene = scene_of(GetParam());
  SphereProgram program = program_of(*scene);
  program.modes &= 3 << 2;
  program.set_start(true);
  expect_levels_alike(program, {0, 5}, {}, {true});
}

INSTANTIATE_TEST_SUITE_P(Long, LongSphereScenes,
                         testing::Values("four", "mirrors", "gallery", "bounce", "inside"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(SphereBench, EverySceneIsHeldAtBothLevels) {
  std::set<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(RACEBEAM_SOURCE_DIR "/scenes/sphere"))
    if (entry.path().extension() == ".toml") names.insert(entry.path().stem().string());
  EXPECT_EQ(names, (std::set<std::string>{"bounce", "four", "gallery", "inside", "mirrors"}));
}

}  // namespace
}  // namespace racebeam
