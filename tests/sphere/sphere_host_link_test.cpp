// Promises of sc/sphere/sphere_host_link.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_host_link.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sc/sphere/sphere_scene.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;
  std::vector<int> written;  // indices, in order
  int loads = 0, faults = 0;

  explicit Dut(const sphere_knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.clock(2);
    bench["rst_ni"].drive(1);
    bench.drive("light", "_i", {1, 2, 3});
    bench.clock();
    host(true);
  }
  void host(bool on) { bench["host_i"].drive(on); }
  /// A clock; the tracer leaves HOST when the table is loaded.
  void clock() {
    bench.clock();
    if (value("table_write_o")) written.push_back(value("table_index_o"));
    faults += value("fault_o");
    if (!value("loaded_o")) return;
    ++loads;
    bench.clock();
    host(false);
  }
  void valid(bool on) {
    bench["valid_i"].drive(on);
    clock();
  }
  void entry(unsigned number, unsigned index) {
    bench["sphere_i"].drive(number << 4 | index);
    bench["x1_i"].drive(index);
    valid(true);
    valid(false);
  }
  int value(const char* port) { return static_cast<int>(bench[port].value()); }
};

template <class Unit>
class SphereHostLinkTest : public testing::Test {};
TYPED_TEST_SUITE(SphereHostLinkTest, sphere_twins<sphere_host_link>);

using Indices = std::vector<int>;

TYPED_TEST(SphereHostLinkTest, LightFollowsTheSpheres) {
  Dut<TypeParam> d;
  for (unsigned n = 0; n < 3; ++n) d.entry(3, n);
  EXPECT_EQ(d.loads, 0);
  d.entry(3, 0);
  EXPECT_EQ(d.written, (Indices{0, 1, 2, 3}));
  EXPECT_EQ(d.loads, 1);
  EXPECT_EQ(d.faults, 0);
  EXPECT_EQ(d.bench.read("table_centre"), (vec3{1, 2, 3}));
  EXPECT_EQ(d.value("table_radius_o"), 2);
  EXPECT_EQ(d.value("table_radius2_o"), 4);
  EXPECT_EQ(d.value("table_inverse_o"), 2048);
  EXPECT_EQ(d.value("table_is_light_o"), 1);
  EXPECT_EQ(d.value("table_green_o"), 31);
  EXPECT_EQ(d.value("table_last_o"), 3);
}

TYPED_TEST(SphereHostLinkTest, FieldsGoToTheTable) {
  Dut<TypeParam> d;
  d.bench["color_i"].drive(0x8000 | 1 << 10 | 2 << 5 | 3);
  d.bench["y1_i"].drive(0xfff000);
  d.bench["z1_i"].drive(0x00f000);
  d.bench["reflect_i"].drive(0x400);
  d.bench["radius_i"].drive(5);
  d.bench["r2_i"].drive(25);
  d.bench["r_inv_i"].drive(819);
  d.entry(4, 2);
  EXPECT_EQ(d.bench.read("table_centre"), (vec3{2, -4096, 15 * 4096}));
  EXPECT_EQ(d.value("table_red_o"), 1);
  EXPECT_EQ(d.value("table_green_o"), 2);
  EXPECT_EQ(d.value("table_blue_o"), 3);
  EXPECT_EQ(d.value("table_is_light_o"), 1);
  EXPECT_EQ(d.value("table_reflect_o"), 0x400);
  EXPECT_EQ(d.value("table_radius_o"), 5);
  EXPECT_EQ(d.value("table_radius2_o"), 25);
  EXPECT_EQ(d.value("table_inverse_o"), 819);
}

TYPED_TEST(SphereHostLinkTest, HeldValidIsTakenOnce) {
  Dut<TypeParam> d;
  d.bench["sphere_i"].drive(0x20);
  d.valid(true);
  for (int n = 0; n < 10; ++n) d.clock();
  EXPECT_EQ(d.written, (Indices{0}));
}

TYPED_TEST(SphereHostLinkTest, ValidBeforeHostIsNeitherLostNorTakenTwice) {
  Dut<TypeParam> d;
  d.host(false);
  d.bench["sphere_i"].drive(0x21);
  d.valid(true);
  for (int n = 0; n < 5; ++n) d.clock();
  EXPECT_TRUE(d.written.empty());
  d.host(true);
  for (int n = 0; n < 5; ++n) d.clock();
  EXPECT_EQ(d.written, (Indices{1}));
  EXPECT_EQ(d.faults, 0);
}

TYPED_TEST(SphereHostLinkTest, ValidTakenBackWhileBusyIsAFault) {
  Dut<TypeParam> d;
  d.host(false);
  d.valid(true);
  d.valid(false);
  d.host(true);
  d.clock();
  EXPECT_TRUE(d.written.empty());
  EXPECT_EQ(d.faults, 1);
}

TYPED_TEST(SphereHostLinkTest, IndexAboveTheNumberIsNotWrittenButCounts) {
  Dut<TypeParam> d;
  d.entry(2, 0);
  d.entry(2, 9);
  EXPECT_EQ(d.faults, 1);
  d.entry(2, 0);
  EXPECT_EQ(d.written, (Indices{0, 2}));
  EXPECT_EQ(d.loads, 1) << "no hang";
}

TYPED_TEST(SphereHostLinkTest, LongerListThanTheTableIsCutAndTold) {
  sphere_knobs k;
  k.table_entries = 5;
  Dut<TypeParam> d(k);
  for (unsigned n = 0; n < 4; ++n) d.entry(9, n);
  EXPECT_EQ(d.faults, 0);
  d.entry(9, 4);
  EXPECT_EQ(d.written, (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(d.faults, 1);
  EXPECT_EQ(d.value("table_last_o"), 4);
}

TYPED_TEST(SphereHostLinkTest, NumberThatShrinksOnTheWayEndsTheList) {
  Dut<TypeParam> d;
  for (unsigned n = 0; n < 5; ++n) d.entry(8, n);
  d.entry(2, 0);
  EXPECT_EQ(d.loads, 1);
  EXPECT_EQ(d.value("table_last_o"), 2);
}

TYPED_TEST(SphereHostLinkTest, NextPictureBeginsAtEntryZero) {
  Dut<TypeParam> d;
  for (int picture = 0; picture < 3; ++picture) {
    d.written.clear();
    for (unsigned n = 0; n < 2; ++n) d.entry(1, 0);
    EXPECT_EQ(d.written, (Indices{0, 1}));
    d.host(true);
  }
  EXPECT_EQ(d.loads, 3);
}

TYPED_TEST(SphereHostLinkTest, WithoutACpuTheBuiltInSceneIsDrawn) {
  Dut<TypeParam> d;
  for (int n = 0; n < HostPatience; ++n) d.clock();
  EXPECT_TRUE(d.written.empty());
  for (int n = 0; n < 5; ++n) d.clock();
  EXPECT_EQ(d.written, (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(d.loads, 1);
  d.written.clear();
  d.bench["scene_i"].drive(1);
  d.host(true);
  d.clock();
  EXPECT_EQ(d.value("table_radius_o"), 10);
  d.clock();
  EXPECT_EQ(d.written, (Indices{0, 1})) << "at once";
  EXPECT_EQ(d.loads, 2);
  d.written.clear();
  d.host(true);
  d.entry(3, 2);
  EXPECT_EQ(d.written, (Indices{2})) << "a CPU that comes late is heard";
  for (int n = 0; n < 20; ++n) d.clock();
  EXPECT_EQ(d.written, (Indices{2}));
}

}  // namespace
}  // namespace racebeam
