// The CPU beside the sphere tracer, as a process with random delays: over TLM and at the pins of
// sphere_host_link it gives the tables that its program means.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/sphere_cpu.h"

#include <memory>
#include <random>

#include "sc/sphere/sphere_host_link.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/tlm_sphere_platform.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

using Table = std::vector<sphere_row>;

SphereMotion three_spheres() {
  return {{{{-9, 0, 15}, {0.5, 0.125, 0}, 5, {31, 4, 4}, 0x400},
           {{9, 0.5, 15}, {-0.25, 0, 0.0625}, 5, {4, 31, 4}, 0x400},
           {{0, -9, 20}, {0, 0.375, -0.125}, 4, {4, 4, 31}, 0x800}},
          {}};
}

/// Of the pictures, without hardware.
std::vector<Table> wanted(int pictures, int rotz) {
  SphereMotion motion = three_spheres();
  std::vector<Table> tables;
  for (int n = 0; n < pictures; ++n) {
    if (n) motion.picture(rotz);
    tables.push_back(motion.table());
  }
  return tables;
}

void expect_same(const sphere_row& is, const sphere_row& want, int picture) {
  EXPECT_EQ(is.centre, want.centre) << "picture " << picture;
  EXPECT_EQ(is.radius, want.radius);
  EXPECT_EQ(is.radius2, want.radius2);
  EXPECT_EQ(is.inverse, want.inverse);
  EXPECT_EQ(is.reflect, want.reflect);
  EXPECT_EQ(is.colour, want.colour);
}

/// Times of up to so many clocks, never the same.
std::function<sc_core::sc_time()> random_pause(unsigned seed, int most, sc_core::sc_time clock) {
  return [random = std::minstd_rand(seed), most, clock]() mutable {
    return clock * (1 + static_cast<double>(random() % 1000) * most / 1000);
  };
}

class SphereCpuTest : public testing::TestWithParam<unsigned> {};

TEST_P(SphereCpuTest, TablesOverTlmAreTheProgramsWhateverTheDelays) {
  constexpr int Pictures = 6, TurnZ = 3 << 16 | 3 << 14;  // pairs of switches: rotz 0x30
  const sc_core::sc_time clock(clock_period_ps(1), sc_core::SC_PS);
  const sphere_tables tables;
  tlm_sphere tracer("tracer", {}, tables, {TurnZ, 15});
  PictureDisplay shown("shown", VisibleColumns, VisibleRows);
  SphereSocketWires wires("wires");
  SphereCpu cpu("cpu", wires, three_spheres(), random_pause(GetParam(), 90, clock));
  tracer.display_socket.bind(shown.socket);
  wires.socket.bind(tracer.host_socket);
  std::vector<Table> seen;
  shown.on_picture = [&] {
    Table table;
    for (int n = 0; n < tracer.core().table().last_q; ++n)
      table.push_back(tracer.core().table().row(n));
    seen.push_back(table);
    EXPECT_EQ(tracer.core().counters().host_faults, 0u);
  };
  while (tracer.pictures() < Pictures) sc_core::sc_start(1'000'000 * clock);
  // rotz stands from the end of picture 0 on.
  const std::vector<Table> want = wanted(Pictures, 0x30);
  for (int picture = 0; picture < Pictures; ++picture) {
    ASSERT_EQ(seen[static_cast<std::size_t>(picture)].size(), 3u);
    for (std::size_t n = 0; n < 3; ++n)
      expect_same(seen[static_cast<std::size_t>(picture)][n],
                  want[static_cast<std::size_t>(picture)][n], picture);
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, SphereCpuTest, testing::Values(1u, 27u));

/// The pins of the link, by the addresses of the socket.
class Pins : public SphereWires {
 public:
  void bind(UnitBench& bench) { bench_ = &bench; }
  void write(std::uint64_t address, std::uint32_t value) override {
    static constexpr const char* names[] = {"sphere_i",  "color_i",  "x1_i", "y1_i",    "z1_i",
                                            "reflect_i", "radius_i", "r2_i", "r_inv_i", "valid_i"};
    (*bench_)[names[address / 4]].drive(value);
  }
  std::uint32_t read(std::uint64_t address) override {
    return address == SphereHostDone && (*bench_)["host_i"].value();
  }

 private:
  UnitBench* bench_ = nullptr;
};

template <class Unit>
class SpherePinCpu : public testing::Test {};
TYPED_TEST_SUITE(SpherePinCpu, sphere_twins<sphere_host_link>);

TYPED_TEST(SpherePinCpu, TablesOverPinsAreTheProgramsWhateverTheDelays) {
  constexpr int Pictures = 20, Busy = 400;
  const sc_core::sc_time clock(1, sc_core::SC_MS);  // of the bench
  Pins pins;
  SphereCpu cpu("cpu", pins, three_spheres(), random_pause(3, 12, clock));
  TypeParam unit("dut", sphere_knobs());
  UnitBench bench(unit);
  pins.bind(bench);
  bench["rst_ni"].drive(1);
  std::vector<Table> seen;
  Table table(4);
  const auto value = [&](const char* port) { return static_cast<int>(bench[port].value()); };
  int busy = Busy, faults = 0;
  while (static_cast<int>(seen.size()) < Pictures) {
    bench["host_i"].drive(busy == 0);
    if (busy > 0) --busy;
    bench.clock();
    faults += value("fault_o");
    if (value("table_write_o")) {
      sphere_row& row = table.at(bench["table_index_o"].value());
      row = {bench.read("table_centre"),
             value("table_radius_o"),
             value("table_radius2_o"),
             value("table_inverse_o"),
             value("table_reflect_o"),
             {value("table_red_o"), value("table_green_o"), value("table_blue_o")},
             value("table_is_light_o") != 0};
    }
    if (!value("loaded_o")) continue;
    seen.push_back(table);
    bench.clock();
    busy = Busy;
  }
  EXPECT_EQ(faults, 0);
  const std::vector<Table> want = wanted(Pictures, 0);
  for (int picture = 0; picture < Pictures; ++picture)
    for (std::size_t n = 0; n < 3; ++n)
      expect_same(seen[static_cast<std::size_t>(picture)][n],
                  want[static_cast<std::size_t>(picture)][n], picture);
}

}  // namespace
}  // namespace racebeam
