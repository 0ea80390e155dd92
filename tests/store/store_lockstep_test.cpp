// The RTL of the frame store's units beside their models, on random traffic, for all their knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "sc/store/frame_scanout.h"
#include "sc/store/store_arbiter.h"
#include "sc/store/write_buffer.h"
#include "sc/video/vga_timing.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/random_traffic.h"
#include "tests/store/store_twins.h"

namespace racebeam {
namespace {

struct Pair {
  std::string unit, name;
  store_knobs k;
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.unit << ", " << pair.name; }

/// Of one unit, or of all.
std::vector<Pair> pairs(const std::string& unit = "") {
  const std::pair<const char*, store_knobs> settings[] = {
      {"light", rgb_light()}, {"rgb888", rgb888()},
      {"planar", planar()},   {"wrapped", wrapped()},
      {"wide", wide_light()}, {"narrow", narrow_planar()},
      {"one", entries(1)},    {"drops", entries(4, WhenFullDrop)}};
  std::vector<Pair> all;
  for (const auto& [name, k] : settings)
    for (const char* own : {"write_buffer", "store_arbiter", "frame_scanout"})
      if (unit.empty() || unit == own) all.push_back({own, name, k});
  return all;
}

std::unique_ptr<sc_core::sc_module> model(const Pair& pair) {
  if (pair.unit == "write_buffer") return std::make_unique<write_buffer>("model", pair.k);
  if (pair.unit == "store_arbiter") return std::make_unique<store_arbiter>("model", pair.k);
  return std::make_unique<frame_scanout>("model", pair.k);
}

constexpr unsigned Seed = 16;

/// The RTL beside the model.
struct Beside {
  explicit Beside(const Pair& pair)
      : unit(model(pair)),
        lockstep("lockstep", pair.unit, *unit, store_parameters(pair.k),
                 store_plugin(pair.unit, pair.k)),
        bench(*unit, &lockstep.clk_i) {}

  void expect_agreement(int clocks) {
    bench.clock(clocks);
    EXPECT_EQ(lockstep.clocks(), static_cast<std::uint64_t>(clocks));
    EXPECT_EQ(lockstep.differences(), 0u)
        << "seed " << Seed << "\n"
        << (lockstep.first() ? difference_table(*lockstep.first()) : "");
  }

  const std::unique_ptr<sc_core::sc_module> unit;
  Lockstep lockstep;
  UnitBench bench;
};

std::string name_of(const testing::TestParamInfo<Pair>& info) {
  return info.param.unit + "_" + info.param.name;
}

class StoreLockstep : public testing::TestWithParam<Pair> {};
INSTANTIATE_TEST_SUITE_P(Pairs, StoreLockstep, testing::ValuesIn(pairs()), name_of);

TEST_P(StoreLockstep, AgreesOnRandomTraffic) {
  Beside beside(GetParam());
  RandomTraffic traffic(beside.bench, LegalInputs({}), Seed);
  beside.bench.between_edges([&] { traffic.next(); });
  beside.expect_agreement(20'000);
}

// Whole lines, the first visible ones too, which random traffic has not.
class ScanoutLockstep : public testing::TestWithParam<Pair> {};
INSTANTIATE_TEST_SUITE_P(Pairs, ScanoutLockstep, testing::ValuesIn(pairs("frame_scanout")),
                         name_of);

TEST_P(ScanoutLockstep, AgreesBehindTheBeam) {
  constexpr int ClocksPerPixel = 1, Lines = 36;
  Beside beside(GetParam());
  vga_timing_core beam;
  std::mt19937_64 random(Seed);
  beside.bench.between_edges([&] {
    const auto now = beam.comb({true, 0}, ClocksPerPixel);
    auto& bench = beside.bench;
    bench["rst_ni"].drive(1);
    bench["consume_i"].drive(now.consume);
    bench["active_i"].drive(now.active);
    bench["line_end_i"].drive(now.line_end);
    bench["y_i"].drive(static_cast<std::uint64_t>(now.y));
    bench["hsync_ni"].drive(now.hsync_n);
    bench["vsync_ni"].drive(now.vsync_n);
    bench["mem_data_i"].drive(random());
    beam.clock({true, 0}, ClocksPerPixel);
  });
  beside.expect_agreement(Lines * LinePixels);
}

}  // namespace
}  // namespace racebeam
