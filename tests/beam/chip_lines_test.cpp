// chip_lines is the chip: all registers at the end of every line, and the pixels, against
// the cores clocked one by one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/tlm/chip_lines.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "tb/scene/scene_reader.h"
#include "tb/show/demo_parts.h"
#include "tb/show/show.h"

namespace racebeam {
namespace {

using Row = std::array<std::uint8_t, VisibleColumns>;

/// The chip in a loop beside the chip in lines.
class Pair {
 public:
  explicit Pair(const knobs& k, int frame = 0, const scene_program* program = nullptr)
      : knobs_(k), chip_(program), lines_({k, program, false, false, nullptr}) {
    chip_.clock_video(false, k);
    seek(frame);
  }
  void seek(int frame) {
    chip_.deposit(frame, knobs_);
    lines_.deposit(frame);
  }
  void reset() {
    chip_.clock_video(false, knobs_);
    lines_.reset();
  }
  const chip_lines& lines() const { return lines_; }

  void expect_equal_lines(int count) {
    for (int i = 0; i < count; ++i) {
      const int y = chip_.vga_timing.v_pos_q;
      const Row row = clock_line();
      lines_.run_line();
      ASSERT_EQ(lines_.y(), y);
      const std::string where =
          "frame " + std::to_string(lines_.frame()) + " line " + std::to_string(y);
      ASSERT_TRUE(chip_.same_video(lines_.registers())) << where;
      ASSERT_EQ(lines_.visible(), y >= -240 && y < 240);
      if (lines_.visible()) {
        ASSERT_TRUE(lines_.pixels() == row) << where;
      }
    }
  }

 private:
  Row clock_line() {
    Row row{};
    int column = 0;
    for (bool last = false; !last;) {
      const auto t = chip_.vga_timing.comb({true, knobs_.speed}, knobs_.clocks_per_pixel);
      const int uo = chip_.clock_video(true, knobs_);
      if (t.consume)
        row[column++] = static_cast<std::uint8_t>(pixel_output_core::colour_of_pins(uo));
      last = t.line_end;
    }
    return row;
  }

  const knobs knobs_;
  chip_core chip_;
  chip_lines lines_;
};

class ChipLinesPart : public testing::TestWithParam<int> {};

TEST_P(ChipLinesPart, HaveTheRegistersOfTheCoresAfterEveryLine) {
  const DemoPart& part = demo_parts()[GetParam()];
  Pair({}, part.first_frame + (part.last_frame - part.first_frame) / 3)
      .expect_equal_lines(FrameLines);
}

INSTANTIATE_TEST_SUITE_P(Demo, ChipLinesPart,
                         testing::Range(0, static_cast<int>(demo_parts().size())));

TEST(LongChipLines, HaveTheRegistersOfTheCoresInManyFrames) {
  Pair pair({});
  for (int i = 0; i < 500; ++i) {
    pair.seek(static_cast<int>((2LL * i + 1) * DemoFrames / 1000));
    ASSERT_NO_FATAL_FAILURE(pair.expect_equal_lines(FrameLines));
  }
}

// The ray pattern depends on every clock: with other pixel clocks it is another picture.
TEST(ChipLines, HaveTheRegistersOfTheCoresWithKnobsWhileThePatternIsShown) {
  for (const int speed : {0, 3, 7})
    for (const int clocks_per_pixel : {1, 2, 5}) {
      knobs k;
      k.speed = speed;
      k.clocks_per_pixel = clocks_per_pixel;
      k.fifo_entries = 4;
      SCOPED_TRACE(speed * 10 + clocks_per_pixel);
      ASSERT_NO_FATAL_FAILURE(Pair(k, 3900).expect_equal_lines(120));
    }
}

/// A row of the knob table, by its number.
class EveryKnob : public testing::TestWithParam<int> {
 protected:
  const knob_info& row = knob_table()[static_cast<std::size_t>(GetParam())];

  /// Both ends of the knob's range, on a chip that a tracer of fixed knobs stands for otherwise.
  void expect_cores_at_both_ends(const knobs& standard, int frame, const scene_program* program,
                                 int max) {
    for (const int value : {row.min, max}) {
      SCOPED_TRACE(value);
      knobs k = standard;
      k.*row.member = value;
      EXPECT_EQ(k == standard, value == standard.*row.member);
      ASSERT_NO_FATAL_FAILURE(Pair(k, frame, program).expect_equal_lines(Lines));
    }
  }
  static constexpr int Lines = 160;  // 127 of them visible
};

// A tracer compiled for some knobs would overlook another one that it does not know.
TEST_P(EveryKnob, IsHonouredByTheChipOfTheDemo) {
  constexpr int CrowdedFrame = 7223;
  int max = row.max;
  if (row.member == &knobs::corner_bits) max = CornerBits;
  if (row.member == &knobs::portals_per_face) max = 1;  // as its rooms are
  expect_cores_at_both_ends({}, CrowdedFrame, nullptr, max);
}

TEST_P(EveryKnob, IsHonouredByTheChipOfASceneFile) {
  const Show show(read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/spiral.toml").scene, "");
  ASSERT_GT(show.program()->portals_per_face, 1);
  expect_cores_at_both_ends(show.standard_knobs(), show.frames() / 3, show.program(), row.max);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryKnob, testing::Range(0, static_cast<int>(knob_table().size())),
                         [](const auto& test) {
                           return knob_table()[static_cast<std::size_t>(test.param)].name;
                         });

TEST(ChipLines, RunOnOverTheEndsOfFrames) {
  Pair pair({}, 2303);
  ASSERT_NO_FATAL_FAILURE(pair.expect_equal_lines(2 * FrameLines + 100));
}

// Frame 12799 lasts one clock.
TEST(ChipLines, RunOnFromTheEndOfTheDemoToItsBeginning) {
  Pair pair({}, DemoFrames - 1);
  ASSERT_NO_FATAL_FAILURE(pair.expect_equal_lines(FrameLines));
  EXPECT_EQ(pair.lines().next_frame(), 0);
  ASSERT_NO_FATAL_FAILURE(pair.expect_equal_lines(2 * FrameLines));
  EXPECT_EQ(pair.lines().next_frame(), 2);
}

TEST(ChipLines, ResetStartsTheDemoAnew) {
  Pair pair({}, 5000);
  for (const int lines : {1, 300, FrameLines + 17}) {
    ASSERT_NO_FATAL_FAILURE(pair.expect_equal_lines(lines));
    pair.reset();
    EXPECT_EQ(pair.lines().next_frame(), 0);
    EXPECT_EQ(pair.lines().next_line(), FirstLine);
  }
  ASSERT_NO_FATAL_FAILURE(pair.expect_equal_lines(FrameLines));
}

}  // namespace
}  // namespace racebeam
