// Promises of sc/beam/camera_unit.h: one line clock by clock, contract sections 7.3, 7.4 and 7.7.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <optional>

#include "tests/beam/camera_unit_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using CameraUnitClocksTest = CameraUnitTest<Unit>;
TYPED_TEST_SUITE(CameraUnitClocksTest, Twins);

// Contract 7.7: frame 2, y = -240.
TYPED_TEST(CameraUnitClocksTest, LineRunsAsInTheContract) {
  struct Row {
    int c, idx2, i2;
    std::optional<vec3> dr2, dr1, ddr;  // ddr is on the delta pins from pstage 1 on
  };
  using V = vec3;
  const std::optional<vec3> _;
  const Row rows[] = {
      {0, 0, 0, V{0, 0, 0}, _, _},
      {1, 0, 0, V{0, 0, 0}, _, _},
      {2, 0, 0, V{0, 0, 511}, _, _},
      {3, 0, 0, V{0, 511, 511}, _, _},
      {4, 0, 0, V{0, 0, 0}, _, V{0, 511, 511}},
      {5, 0, 1, V{0, 0, 511}, _, V{0, 511, 511}},
      {6, 1, 1, V{0, 1, -512}, _, V{0, 511, 511}},  // 512 in 10 bits
      {7, 0, 0, V{0, 0, 0}, _, V{0, 1, 512}},
      {8, 0, 510, V{0, 1, 0}, _, _},
      {9, 512, 510, V{0, 2, -512}, _, _},
      {10, 510, 510, V{0, 2, 510}, _, _},
      {11, 0, 0, V{0, 0, 0}, _, V{0, 2, 510}},
      {12, 0, 510, V{0, -2, 510}, _, V{0, 2, 510}},
      {13, 512, 510, V{0, -4, -4}, _, V{0, -2, 510}},
      {14, 510, 510, _, _, V{0, -2, 510}},
      {15, 0, 96, V{0, 0, 0}, _, _},
      {16, 128, 96, V{0, 0, 128}, _, _},
      {17, 96, 96, V{0, 0, 96}, _, _},
      {18, 96, 96, V{0, 0, 96}, _, _},
      {19, 0, 0, V{0, 0, 0}, V{0, 0, 96}, _},
      {30, 0, 0, V{0, 0, 0}, V{0, 0, 96}, V{0, 510, 2}},
      {34, 256, 16, V{0, 0, 96}, V{0, 0, 96}, V{0, 510, 2}},
      {35, 0, 16, V{0, -255, 95}, _, _},
      {36, 16, 16, V{0, -239, 95}, _, _},
      {38, 0, 0, V{0, 0, 0}, V{0, -239, 95}, _},
      {42, 0, 0, V{0, 0, 0}, _, V{511, 0, 0}},
      {46, 512, 192, V{0, -239, 95}, V{0, -239, 95}, V{511, 0, 0}},
      {47, 256, 192, V{-255, -239, 95}, _, _},
      {48, 192, 192, V{-319, -239, 95}, _, _},
      {49, 192, 192, V{-319, -239, 95}, _, _},
      {50, 0, 639, V{-319, -239, 95}, V{-319, -239, 95}, V{511, 0, 0}},
  };
  this->start_line(view_of(2, 0, -240), -240);
  int c = 0;
  for (const Row& row : rows) {
    for (; c < row.c; ++c) {
      ASSERT_EQ(this->out("run_o"), 0);
      this->clock();
    }
    SCOPED_TRACE(c);
    EXPECT_EQ(this->idx2, row.idx2);
    EXPECT_EQ(this->i2, row.i2);
    EXPECT_EQ(this->dr2, row.dr2.value_or(this->dr2));
    EXPECT_EQ(this->dr1, row.dr1.value_or(this->dr1));
    const vec3 delta = this->bench->read("delta");
    EXPECT_EQ(delta, row.ddr.value_or(delta));
  }
  EXPECT_EQ(this->out("run_o"), 1);
}

// Contract 7.3 and 7.4: the controls of the first pass of that line, worked out by hand.
TYPED_TEST(CameraUnitClocksTest, ControlsFollowTheTablesOfTheProductAndThePhases) {
  struct Row {
    int src, load, ext, ext_sign, axis_mask, copy, idx_load, i2_init;
  };
  const Row rows[] = {
      {0, 0, 1, 0, 1, 0, 0, 0},  // c = 0: + frac for sine axes
      {0, 0, 1, 0, 4, 0, 0, 0},  // + inv for cosine axes
      {0, 0, 1, 0, 2, 0, 0, 0},  // + 511 for ONE
      {0, 1, 0, 0, 5, 0, 1, 0},  // frac = 0: done at once
      {1, 0, 1, 0, 5, 0, 0, 1},  // pitch: + ddr for sine axes
      {1, 0, 0, 0, 7, 0, 0, 1},   {1, 1, 0, 0, 7, 0, 1, 0},
      {1, 0, 1, 0, 2, 0, 0, 510},  // + ddr for cosine axes
      {1, 0, 0, 0, 7, 0, 0, 510}, {1, 0, 0, 0, 7, 0, 0, 510},
      {1, 1, 0, 0, 7, 0, 1, 0},   {1, 0, 1, 2, 7, 0, 0, 510},  // sign: y is negative
      {1, 0, 1, 2, 7, 0, 0, 510}, {1, 0, 1, 2, 7, 0, 0, 510},
      {2, 1, 0, 0, 7, 0, 1, 96},  // LOAD
      {2, 0, 0, 0, 7, 0, 0, 96},  // SCALE
      {2, 0, 0, 0, 7, 0, 0, 96},  {2, 0, 0, 0, 7, 0, 0, 96},
      {1, 1, 1, 2, 7, 1, 1, 0},  // finish: preset of the next pass
      {0, 0, 1, 0, 1, 0, 0, 0},  // pass 1: yaw offsets 2, -, 3: x is sine
  };
  this->start_line(view_of(2, 0, -240), -240);
  int c = 0;
  for (const Row& row : rows) {
    SCOPED_TRACE(c++);
    EXPECT_EQ(this->out("src_o"), row.src);
    EXPECT_EQ(this->out("load_o"), row.load);
    EXPECT_EQ(this->out("copy_ext_o"), row.copy);
    EXPECT_EQ(this->out("idx_load_o"), row.idx_load);
    EXPECT_EQ(this->out("i2_init_o"), row.i2_init);
    if (row.load) {  // what the stepper does not look at in this clock is free
      EXPECT_EQ(this->out("load_zero_o"), 1);
      EXPECT_EQ(this->out("idx_start_o"), 0);
    } else {
      EXPECT_EQ(this->out("ext_o"), row.ext);
      EXPECT_EQ(this->out("axis_mask_o"), row.axis_mask);
      EXPECT_EQ(row.ext ? this->out("ext_sign_o") : 0, row.ext_sign);
    }
    this->clock();
  }
  while (!(this->out("copy_ext_o") && this->out("i2_init_o") == 639) && c++ < 100) this->clock();
  EXPECT_EQ(this->out("load_o"), 0);  // the last finish keeps dr2
  EXPECT_EQ(this->out("idx_load_o"), 1);
  EXPECT_EQ(this->out("idx_start_o"), 0);
  EXPECT_EQ(this->out("run_o"), 0);
  this->clock();
  EXPECT_EQ(this->out("run_o"), 1);
}

}  // namespace
}  // namespace racebeam
