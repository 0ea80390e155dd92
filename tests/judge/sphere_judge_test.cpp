// The sphere tracer's pictures of all scenes are as near to double precision as the design says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/sphere_judge.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "sc/sphere/engine.h"
#include "tb/bench/sphere_bench.h"
#include "tb/host/sphere_picture.h"
#include "tb/judge/goldens.h"
#include "tb/show/open_show.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scene_files() {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(RACEBEAM_SOURCE_DIR "/scenes/sphere"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path().stem().string());
  return files;
}

/// Its program; without checkerboards, whose squares may be smaller than a pixel.
SphereProgram program_of(const std::string& name) {
  const Show show = open_show(RACEBEAM_SOURCE_DIR "/scenes/sphere/" + name + ".toml");
  SphereProgram program = *static_cast<const SphereProgram*>(show.tables());
  for (plane_row& plane : program.planes) plane.checker = 0;
  return program;
}

/// The same with one ray a pixel.
SphereProgram one_ray(SphereProgram program) {
  constexpr int Antialias = 3;  // SW1, SW0
  program.modes &= ~Antialias;
  program.board.sw &= ~Antialias;
  for (SphereInput& input : program.inputs) input.sw &= ~Antialias;
  return program;
}

VgaFrame drawn(const SphereProgram& program, int picture) {
  const auto bench =
      make_sphere_bench("tlm", {sphere_engine(), sphere_knobs(), &program, picture + 1, {}}, {});
  bench->seek(picture);
  return bench->render().picture;
}

/// The same without SystemC, which makes one chip a process.
PackedPicture drawn_by_core(const SphereProgram& program, int picture) {
  const sphere_knobs k;
  const auto core = core_before(program, k, picture);
  core->draw(program.board_in(picture));
  const std::vector<std::uint64_t> store = core->picture();
  PackedPicture picture_of{core->columns(), core->rows(), k.colour_bits, {}};
  for (int y = 0; y < core->rows(); ++y)
    for (int x = 0; x < core->columns(); ++x)
      picture_of.push(static_cast<std::uint32_t>(
          store[static_cast<std::size_t>(core->address(x, y))] & ((1u << 3 * k.colour_bits) - 1)));
  return picture_of;
}

/// `by_more`: the share of pixels that may be off by more than one level.
void expect_near(const SphereProgram& program, int picture, int step, double by_more) {
  SCOPED_TRACE("picture " + std::to_string(picture));
  const PictureErrors e =
      golden_of(sphere_engine())
          ->compare(&program, sphere_knobs(), picture, drawn(program, picture), step);
  ASSERT_GT(e.pixels, 4000u);
  const auto share = [&](std::uint64_t part) { return double(part) / double(e.pixels); };
  EXPECT_LE(share(e.by_more), by_more) << share(e.differing) << " differ, rmse " << e.rmse();
  EXPECT_LE(share(e.wrong_hits), 0.005);  // measured: 0.48 %
  EXPECT_LE(e.rmse(), 1.3);               // 1.27
}

/// One ray a pixel, whole pictures: the bounds of the design, 1 %, and 1.5 % with planes (four:
/// 0.79 % as there). Wider, each by what was measured: the last of gallery, where the balls mirror
/// all planes (2.14 %; why: TwelveBitsOfADirection...); several rays a pixel, each off by less at
/// an edge (gallery 1.04 and 2.78 %, mirrors 1.66 %); every fourth pixel of every fourth row
/// (bounce 1.71 %).
double bound_of(bool planes, bool several_rays, bool balls_mirror_planes, int step) {
  if (balls_mirror_planes) return several_rays ? 0.028 : 0.022;
  if (several_rays) return planes ? 0.017 : 0.011;
  return !planes ? 0.01 : step > 1 ? 0.018 : 0.015;
}

void expect_picture_near(const std::string& name, int picture, int step) {
  const SphereProgram as_it_is = program_of(name), single = one_ray(as_it_is);
  const sphere_inputs_core in = as_it_is.inputs_before(picture);
  const bool worst = name == "gallery" && in.planes_q;
  expect_near(single, picture, step, bound_of(in.planes_q, false, worst, step));
  if (in.alias_q) expect_near(as_it_is, picture, step, bound_of(in.planes_q, true, worst, step));
}

class SphereJudge : public testing::TestWithParam<std::string> {};
TEST_P(SphereJudge, FirstPictureIsWithinTheBounds) { expect_picture_near(GetParam(), 0, 4); }
INSTANTIATE_TEST_SUITE_P(Scenes, SphereJudge, testing::ValuesIn(scene_files()),
                         [](const auto& info) { return info.param; });

class LongSphereJudge : public testing::TestWithParam<std::string> {};
TEST_P(LongSphereJudge, WholePicturesAreWithinTheBounds) {
  const Show show = open_show(RACEBEAM_SOURCE_DIR "/scenes/sphere/" + GetParam() + ".toml");
  const int last = show.frames() - 1;
  for (const int picture : std::set<int>{0, last / 3, last})
    expect_picture_near(GetParam(), picture, 1);
}
INSTANTIATE_TEST_SUITE_P(LongScenes, LongSphereJudge, testing::ValuesIn(scene_files()),
                         [](const auto& info) { return info.param; });

// Three mirrors, two of them balls, magnify what a direction lacks behind 12 bits, and edges lie
// elsewhere. A golden tracer with such directions, exact in all else, is off in 0.73 % of the
// pixels instead of 2.14, with nine rays a pixel in 0.82 % instead of 2.78. Of that 0.44 % is the
// endless floor: where it is more than 2048 units away the tracer's numbers end.
void expect_directions_to_blame(SphereProgram program, double off, double cut, double near) {
  constexpr int Picture = 7;
  const sphere_knobs k;
  const auto share = [&](int direction_bits) {
    SphereGoldenScene scene = golden_scene(program, k, Picture);
    scene.direction_bits = direction_bits;
    const PictureErrors e =
        sphere_errors(scene, program, k, Picture, drawn_by_core(program, Picture), 1);
    return double(e.by_more) / double(e.pixels);
  };
  EXPECT_GT(share(0), off);
  EXPECT_LE(share(k.fraction_bits), cut) << "the bound of the design";
  for (plane_row& plane : program.planes) {
    plane.limited = true;
    plane.limit = {500, 500, 500};
  }
  EXPECT_LE(share(k.fraction_bits), near) << "with a floor that ends";
}

TEST(SphereDirections, TwelveBitsOfThemAreWhyTheGalleryIsOffInItsMirrors) {
  expect_directions_to_blame(one_ray(program_of("gallery")), 0.02, 0.01, 0.004);
}

TEST(LongSphereDirections, TwelveBitsOfThemAreWhyTheGalleryIsOffWithNineRays) {
  expect_directions_to_blame(program_of("gallery"), 0.025, 0.01, 0.005);
}

TEST(SphereErrors, AreCountedAsTheyAre) {
  const SphereProgram& program = builtin_sphere_program();
  const sphere_knobs k;
  VgaFrame ideal = sphere_golden_picture(&program, k, 0);
  PictureErrors e = sphere_golden_errors(&program, k, 0, ideal, 4);
  EXPECT_EQ(e.pixels, 128u * 120);
  EXPECT_EQ(e.differing, 0u);
  EXPECT_EQ(e.rmse(), 0);
  // A pixel's red is off by two, another's blue by one.
  const std::size_t first = 0, second = 4;
  ASSERT_EQ(ideal.colour(first), 0u);
  ASSERT_EQ(ideal.colour(second), 0u);
  ideal.colours[2 * first + 1] = 2 << 2;
  ideal.colours[2 * second] = 1;
  e = sphere_golden_errors(&program, k, 0, ideal, 4);
  EXPECT_EQ(e.differing, 2u);
  EXPECT_EQ(e.by_more, 1u);
  EXPECT_EQ(e.squares, 5u);
  EXPECT_EQ(e.most, 31);
  EXPECT_NEAR(e.rmse(), 0.01042, 1e-5);
  EXPECT_NEAR(e.psnr(), 69.47, 0.01);
}

}  // namespace
}  // namespace racebeam
