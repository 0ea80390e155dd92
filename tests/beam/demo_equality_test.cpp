// The demo from its scene file is the built-in demo: every wire, every clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sc/beam/chip_core.h"
#include "tb/monitor/raster.h"
#include "tb/scene/scene_compiler.h"
#include "tb/scene/scene_reader.h"
#include "tb/show/demo_parts.h"

namespace racebeam {
namespace {

const scene_program& demo_program() {
  static const scene_program program =
      compile_scene(read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/demo.toml").scene);
  return program;
}

/// The chip with its logic and the chip with tables, side by side.
class Pair {
 public:
  explicit Pair(int frame) {
    logic_.clock(false, {});
    logic_.deposit(frame, {});
    tables_.clock(false, knobs_);
    tables_.deposit(frame, knobs_);
  }

  void expect_equal_frame(int frame) {
    for (int clock = 0; clock < raster_.frame_clocks(); ++clock) {
      chip_view want, got;
      const auto a = logic_.clock(true, {}, &want), b = tables_.clock(true, knobs_, &got);
      ASSERT_TRUE(a.uo == b.uo && a.pwm == b.pwm && want == got)
          << "frame " << frame << " line " << want.y << " clock " << clock % raster_.line_clocks();
    }
  }

 private:
  const Raster raster_{2, 0};
  const knobs knobs_ = demo_program().fitted({});
  chip_core logic_, tables_{&demo_program()};
};

class DemoPartEquality : public testing::TestWithParam<int> {
 protected:
  const DemoPart& part = demo_parts()[GetParam()];
};
using LongDemoPartEquality = DemoPartEquality;

TEST_P(DemoPartEquality, HoldsInItsMiddle) {
  const int middle = (part.first_frame + part.last_frame) / 2;
  Pair(middle).expect_equal_frame(middle);
}
TEST_P(LongDemoPartEquality, HoldsAtItsBeginning) {
  Pair(part.first_frame).expect_equal_frame(part.first_frame);
}

const auto Parts = testing::Range(0, static_cast<int>(demo_parts().size()));
INSTANTIATE_TEST_SUITE_P(Demo, DemoPartEquality, Parts);
INSTANTIATE_TEST_SUITE_P(LongDemo, LongDemoPartEquality, Parts);

// Over a restart of the flight, and from the end of the demo to its beginning.
TEST(DemoEquality, HoldsFromPartToPart) {
  for (const int first : {2303, 8191, 12798}) {
    Pair pair(first);
    for (int i = 0; i < 2; ++i)
      ASSERT_NO_FATAL_FAILURE(pair.expect_equal_frame((first + i) % DemoFrames));
  }
}

void expect_equal_run(int first, int last) {
  Pair pair(first);
  for (int frame = first; frame <= last; ++frame)
    ASSERT_NO_FATAL_FAILURE(pair.expect_equal_frame(frame));
}

// Minutes each.
TEST(LongDemoEquality, HoldsInEveryFrameOfTheFirstHalf) { expect_equal_run(0, 6399); }
TEST(LongDemoEquality, HoldsInEveryFrameOfTheSecondHalf) { expect_equal_run(6400, 12798); }

}  // namespace
}  // namespace racebeam
