// The block renderer's pictures of scenes are as near to double precision as the design says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/block_judge.h"

#include <gtest/gtest.h>

#include "sc/block/engine.h"
#include "tb/bench/block_bench.h"
#include "tb/judge/goldens.h"
#include "tb/show/open_show.h"
#include "tests/support/block_scenes.h"

namespace racebeam {
namespace {

BlockProgram program_of(const std::string& name) {
  const Show show = open_show(RACEBEAM_SOURCE_DIR "/scenes/block/" + name + ".toml");
  return block_program_of(show.tables());
}

VgaFrame drawn(const BlockProgram& program, const block_knobs& k, int picture) {
  const auto bench =
      make_block_bench("tlm", {block_engine(), k, &program, picture + 1, {}}, BenchWishes{});
  bench->seek(picture);
  return bench->render().picture;
}

double percent(std::uint64_t part, const BlockErrors& e) {
  return 100 * static_cast<double>(part) / static_cast<double>(e.all.pixels);
}

BlockErrors errors(const std::string& name, const block_knobs& k, int picture) {
  const BlockProgram program = program_of(name);
  return block_errors(tables_of(program, k, picture), k, drawn(program, k, picture), 2);
}

TEST(BlockJudge, FilesOfTheVectorsAreTheirScenes) {
  for (const auto& [name, meant] :
       {std::pair{"quad", quad_tables()}, std::pair{"forty", forty_tables()}}) {
    SCOPED_TRACE(name);
    const BlockProgram is = program_of(name);
    EXPECT_EQ(is.eye, meant.eye);
    EXPECT_EQ(is.light, meant.light);
    EXPECT_EQ(is.screen, meant.screen);
    ASSERT_EQ(is.balls.size(), meant.balls.size());
    for (std::size_t n = 0; n < is.balls.size(); ++n) {
      EXPECT_EQ(is.balls[n].centre, meant.balls[n].centre) << n;
      EXPECT_EQ(is.balls[n].radius, meant.balls[n].radius) << n;
      EXPECT_EQ(is.balls[n].colour, meant.balls[n].colour) << n;
    }
  }
}

TEST(BlockJudge, OnePassIsWithinTheBoundsOfTheDesign) {
  block_knobs k;
  k.max_passes = 1;
  for (const char* name : {"quad", "forty", "bounce"}) {
    SCOPED_TRACE(name);
    const BlockErrors e = errors(name, k, 0);
    EXPECT_EQ(e.all.pixels, 320u * 240);
    EXPECT_LE(percent(e.by_more_than_2, e), 8);
    EXPECT_LE(percent(e.by_more_than_16, e), 0.5);
    EXPECT_LE(e.all.rmse(), 4);
    EXPECT_LE(percent(e.all.wrong_hits, e), 0.3);
  }
}

TEST(BlockJudge, AStepOfHeronsTakesMostOfTheErrorAway) {
  block_knobs k;
  k.max_passes = 1;
  k.root = BlockRootHeron;
  const BlockErrors e = errors("forty", k, 0);
  EXPECT_LE(percent(e.by_more_than_2, e), 1);
  EXPECT_LE(percent(e.by_more_than_16, e), 0.2);
}

// A mirror multiplies what the roots are too long by; measured: 15.2, 14.4 % and 4.76 %.
TEST(BlockJudge, ReflectionsOfFortyAreOffByWhatTheDesignSays) {
  const BlockErrors e = errors("forty", {}, 0);
  EXPECT_NEAR(e.all.rmse(), 15.2, 1);
  EXPECT_NEAR(percent(e.by_more_than_2, e), 14.4, 1);
  EXPECT_NEAR(percent(e.by_more_than_16, e), 4.76, 0.5);
}

// The ball is 13 pixels wide, a block 16: in picture 0 it lies between the corner rays of one.
TEST(BlockJudge, CornersLoseATinySphereThatAConeKeeps) {
  block_knobs k;
  k.max_passes = 1;
  const BlockErrors corners = errors("tiny", k, 0);
  EXPECT_NEAR(static_cast<double>(corners.all.wrong_hits), 44, 8);
  k.cull = BlockCullCone;
  const BlockErrors cone = errors("tiny", k, 0);
  EXPECT_LE(cone.all.wrong_hits, 16u);
  EXPECT_LE(percent(cone.by_more_than_16, cone), 0.5);
}

TEST(BlockErrors, AreCountedAsTheyAre) {
  const BlockProgram& program = builtin_block_program();
  block_knobs k;
  VgaFrame ideal = golden_of(block_engine())->picture(&program, k, 0);
  const auto judged = [&] { return block_errors(program, k, ideal, 1); };
  EXPECT_EQ(judged().all.pixels, 640u * 480);
  EXPECT_EQ(judged().all.differing, 0u);
  EXPECT_EQ(judged().all.rmse(), 0);
  // In the lowest row, which is black: blue, green and red, by one, three and 17 levels.
  const std::size_t row = std::size_t{479} * 640;
  ASSERT_EQ(ideal.colour(row), 0u);
  ideal.colours[4 * row] = 1;
  ideal.colours[4 * (row + 1) + 1] = 3;
  ideal.colours[4 * (row + 2) + 2] = 17;
  const BlockErrors e = judged();
  EXPECT_EQ(e.all.differing, 3u);
  EXPECT_EQ(e.all.by_more, 2u);
  EXPECT_EQ(e.by_more_than_2, 2u);
  EXPECT_EQ(e.by_more_than_16, 1u);
  EXPECT_EQ(e.all.squares, 1u + 9 + 289);
  EXPECT_EQ(e.all.most, 255);
  k.load_bar = 1;
  EXPECT_EQ(judged().all.differing, 0u) << "the load bar lies over them";
  EXPECT_EQ(judged().all.pixels, 640u * 480 - 4 * 16);
}

}  // namespace
}  // namespace racebeam
