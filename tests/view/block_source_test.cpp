// The block renderer as a source of pictures for the viewer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/block_source.h"

#include <gtest/gtest.h>

#include "sc/store/frame_scanout.h"
#include "tb/view/view_control.h"

namespace racebeam {
namespace {

constexpr int Pictures = 5;

BlockProgram moving() {
  BlockProgram program = builtin_block_program();
  std::vector<BlockBody> bodies = program.bodies;
  for (BlockBody& body : bodies) body.velocity = {0.25, 0.125, 0};
  program.set_bodies(bodies);
  return program;
}

block_knobs with(int cores, int load_bar) {
  block_knobs k;
  k.cores = cores;
  k.load_bar = load_bar;
  return k;
}

/// What the viewer shows is the machine's own picture, but for the load bar's rows.
void expect_picture(const BlockSource& source, const BlockProgram& program, const block_knobs& k,
                    int picture) {
  block_machine machine(k);
  machine.draw(tables_of(program, k, picture));
  const std::vector<std::uint64_t> words = machine.picture();
  ASSERT_EQ(source.watch().frame(), picture);
  for (int y = 0; y < 480 - LoadBar::Side; y += 3)
    for (int x = 0; x < 640; x += 3) {
      const auto dac = frame_scanout_core::pixel(words, y, x, k.store());
      const int wanted = dac.red >> 2 << 16 | dac.green >> 2 << 8 | dac.blue >> 2;
      const auto shown = source.picture()->colour(static_cast<std::size_t>(y) * 640 + x);
      ASSERT_EQ(static_cast<int>(shown), x < k.columns() ? wanted : 0) << x << "," << y;
    }
}

TEST(BlockSource, ShowsPictureAfterPicture) {
  const BlockProgram program = moving();
  const block_knobs k = with(4, 0);
  BlockSource source(program, k, Pictures);
  for (int picture = 0; picture < 3; ++picture) {
    source.advance(source.clocks_left());
    expect_picture(source, program, k, picture);
  }
  source.seek(1);
  source.advance(source.clocks_left());
  expect_picture(source, program, k, 1);
}

TEST(BlockSource, AFrameOfTheViewerLastsAsLongAsThePicture) {
  const BlockProgram program = moving();
  const auto seconds = [&](int cores) {
    BlockSource source(program, with(cores, 0), Pictures);
    source.advance(source.clocks_left());
    return source.watch().raster().frame_clocks() / source.clock_hz();
  };
  EXPECT_NEAR(seconds(1), 3173801 / 50.4e6, 1e-5);
  EXPECT_LT(seconds(8) * 7, seconds(1));
}

TEST(BlockSource, LoadBarHasASquareACore) {
  const BlockProgram program = moving();
  BlockSource source(program, with(6, 1), Pictures);
  source.advance(source.clocks_left());
  for (int core = 0; core < 6; ++core) {
    const auto grey = source.picture()->colour(476u * 640 + 4u * static_cast<unsigned>(core));
    EXPECT_GT(grey & 255, 200u) << "busy";
    EXPECT_EQ(grey, (grey & 255) * 0x10101u);
  }
  EXPECT_EQ(source.picture()->colour(476u * 640 + 24), 0u) << "no seventh core";
}

TEST(BlockSource, KeysOfTheModelAreToldToBeNone) {
  ViewControl control;
  control.state.plain = true;
  for (const KeyHelp& row : ViewControl::help(KeyHelp::Plain)) EXPECT_EQ(row.chip, KeyHelp::Any);
  EXPECT_TRUE(control.press("1"));
  EXPECT_EQ(control.take_action(), ViewAction::ModelOnly);
  EXPECT_TRUE(control.press("t"));
  EXPECT_TRUE(control.state.text);
}

}  // namespace
}  // namespace racebeam
