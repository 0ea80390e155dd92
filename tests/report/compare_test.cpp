// The tables behind `racebeam compare`, held to what they are about.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <numeric>

#include "sc/beam/engine.h"
#include "sc/beam/interval_fifo.h"
#include "sc/beam/silicon.h"
#include "sc/beam/stacks.h"
#include "sc/block/block_core_core.h"
#include "sc/block/block_pack_core.h"
#include "sc/block/block_spheres_core.h"
#include "sc/block/engine.h"
#include "sc/block/silicon.h"
#include "sc/sphere/engine.h"
#include "sc/sphere/plane_table.h"
#include "sc/sphere/silicon.h"
#include "sc/sphere/sphere_shader_core.h"
#include "sc/sphere/sphere_table_core.h"
#include "sc/store/write_buffer.h"
#include "sc/voxel/knobs.h"
#include "tb/base/errors.h"
#include "tb/report/area_figures.h"
#include "tb/report/compare_kinds.h"
#include "tb/report/compare_metrics.h"
#include "tb/scene/engines.h"
#include "tb/show/open_show.h"
#include "tb/sweep/sweep_kinds.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

/// Bits of registers whose name begins so.
std::uint64_t bits_of(const std::vector<probe>& registers, const std::string& begin) {
  std::uint64_t sum = 0;
  for (const probe& one : registers)
    if (one.name.compare(0, begin.size(), begin) == 0) sum += static_cast<unsigned>(one.bits);
  return sum;
}

std::uint64_t bits_of(const silicon& made, const std::string& memory) {
  for (const memory_row& row : made.memories)
    if (row.name == memory) return row.bits;
  ADD_FAILURE() << "no memory " << memory;
  return 0;
}

TEST(CompareMemories, OfTheIntervalTracerAreItsArrays) {
  for (const int entries : {4, 9, 20}) {
    knobs k;
    k.interval_stack_depth = k.fifo_entries = entries;
    const silicon made = beam_silicon(k, nullptr);
    const auto stack = registers_of(stacks_core(), k);
    const auto fifo = registers_of(interval_fifo_core(), k);
    EXPECT_EQ(bits_of(made, "interval stack"), bits_of(stack, "tags_q") + bits_of(stack, "i2s_q"));
    EXPECT_EQ(bits_of(made, "face stack"), bits_of(stack, "faces_q"));
    EXPECT_EQ(bits_of(made, "interval FIFO"), bits_of(fifo, "") - bits_of(fifo, "tail_ptr_q"));
  }
}

TEST(CompareMemories, OfTheSphereTracerAreItsArrays) {
  for (const int entries : {16, 8}) {
    sphere_knobs k;
    k.table_entries = entries;
    k.write_buffer_depth = 2 * entries;
    const silicon made = sphere_silicon(k, nullptr);
    const auto table = registers_of(sphere_table_core(), k);
    EXPECT_EQ(bits_of(made, "sphere table"), bits_of(table, "") - bits_of(table, "last_q"));
    EXPECT_EQ(bits_of(made, "alias buffer"),
              bits_of(registers_of(sphere_shader_core()), "buffer_q"));
    const auto buffer = registers_of(write_buffer_core(), k.store());
    EXPECT_EQ(bits_of(made, "write buffer"),
              bits_of(buffer, "addresses_q") + bits_of(buffer, "datas_q"));
  }
  const silicon made = sphere_silicon(sphere_knobs(), nullptr);
  EXPECT_EQ(bits_of(made, "plane table"), 8 * 164) << "of one row: what plane_table puts out";
  EXPECT_EQ(bits_of(made, "frame store"), 4'194'304);
}

TEST(CompareMemories, OfTheBlockRendererAreItsCoresArrays) {
  for (const int cores : {1, 5})
    for (const int lanes : {4, 8}) {
      block_knobs k;
      k.cores = cores;
      k.lanes = lanes;
      const silicon made = block_silicon(k, nullptr);
      const std::uint64_t spheres =
          bits_of(registers_of(block_spheres_core(), k), "") * static_cast<unsigned>(k.lanes);
      EXPECT_EQ(bits_of(made, "spheres of the cores"), spheres * static_cast<unsigned>(cores));
      const auto pack = registers_of(block_pack_core());
      EXPECT_EQ(bits_of(made, "pixels on their way to words"),
                (bits_of(pack, "") - bits_of(pack, "count_q")) * static_cast<unsigned>(cores));
      const auto buffer = registers_of(write_buffer_core(), k.store());
      EXPECT_EQ(bits_of(made, "write buffer"),
                bits_of(buffer, "addresses_q") + bits_of(buffer, "datas_q"));
      EXPECT_EQ(bits_of(made, "frame store"), 7'372'800);
    }
}

TEST(CompareTables, EveryEngineHasARowAndAFormulaForEachQuantity) {
  for (const engine* built : engines()) {
    const silicon made = sweep_kind(*built).made_of(built->standard(nullptr), nullptr);
    for (const CompareName& wanted : compare_quantities())
      EXPECT_EQ(std::count_if(made.quantities.begin(), made.quantities.end(),
                              [&](const quantity_row& row) { return row.name == wanted.name; }),
                1)
          << built->name << " " << wanted.name;
    EXPECT_STREQ(hits_of(*built).engine.name, built->name);
  }
}

TEST(CompareTables, FormulasAreOverNumbersThatThereAre) {
  for (const engine* built : engines()) {
    Numbers numbers;
    for (const CompareName& row : compare_numbers()) numbers[row.name] = 1;
    for (const counter_info& row : built->counters) numbers[row.name] = 1;
    for (const line_info& row : built->lines) numbers[row.name] = 1;
    const knob_values k = built->standard(nullptr);
    for (std::size_t n = 0; n < k.rows().size(); ++n) numbers[k.rows()[n].name] = k[n];
    for (const histogram_info& row : built->histograms)
      for (int value = 0; value <= row.largest(k); ++value)
        numbers[std::string(row.name) + "_" + std::to_string(value)] = 1;
    const silicon made = sweep_kind(*built).made_of(k, nullptr);
    for (const scene_number& row : made.scene) numbers[row.name] = row.value;
    for (const quantity_row& row : made.quantities) {
      EXPECT_EQ(formula_value(row.formula, numbers).has_value(), !row.formula.empty())
          << built->name << " " << row.name << ": " << row.formula;
      numbers[row.name] = 1;
    }
    for (const CompareMetric& metric : compare_metrics())
      EXPECT_TRUE(formula_value(metric.formula, numbers)) << metric.name;
  }
}

TEST(CompareTables, AFormulaOfWhatIsNotThereHasNoValue) {
  EXPECT_FALSE(formula_value("", {}));
  EXPECT_FALSE(formula_value("a / b", {{"a", 1}}));
  EXPECT_EQ(formula_value("7", {}), 7);
  EXPECT_EQ(formula_value("ceil(a / 2) + log10(b)", {{"a", 3}, {"b", 100}}), 4);
}

TEST(CompareTables, AreaIsOfTheChipWithItsOwnParameters) {
  block_knobs one_core;
  one_core.cores = 1;
  voxel_knobs hills;
  hills.size_x = hills.size_y = 512;
  hills.size_z = 128;
  for (const knob_values& k : {knob_values(knobs()), knob_values(sphere_knobs()),
                               knob_values(one_core), knob_values(hills)}) {
    const engine* const built = &engine_of(k);
    const AreaFigures* const area = area_of(k);
    ASSERT_NE(area, nullptr) << built->name;
    EXPECT_GT(area->registers, 0);
    EXPECT_GT(area->cells, area->registers);
    EXPECT_TRUE(std::filesystem::exists(std::string(RACEBEAM_SOURCE_DIR "/rtl/") + built->name +
                                        "/" + area->top + ".sv"));
  }
  sphere_knobs k;
  k.root_bits_per_clock = 2;
  EXPECT_EQ(area_of(k), nullptr);
}

TEST(CompareTables, ThePageHasThem) {
  const std::string text = page("docs/compare.md");
  for (const CompareMetric& metric : compare_metrics())
    EXPECT_THAT(text, HasSubstr("\n" + metric_row(metric) + "\n"));
  for (const auto* names : {&compare_numbers(), &compare_quantities()})
    for (const CompareName& row : *names)
      EXPECT_THAT(text, HasSubstr("\n| `" + std::string(row.name) + "` | " + row.meaning + " |\n"));
}

TEST(CompareCosts, OfPixelsAddUpToThePicture) {
  const Show show = open_show("block/quad");
  block_knobs k;
  k.cores = 1;
  ChipBench::Frame frame{};
  Spread costs;
  compare_kind_of(block_engine()).add_costs(show, k, frame, costs);
  EXPECT_EQ(costs.count(), 640u * 480u);
  EXPECT_EQ(costs.sum(), 3'172'601u) << "busy clocks of block_top_test's one core";
}

TEST(CompareScenes, AreReadByEveryEngineThatHasTheKeys) {
  std::string why;
  EXPECT_TRUE(open_show_for(sphere_engine(), "common/balls", why));
  EXPECT_TRUE(open_show_for(block_engine(), "common/balls", why));
  EXPECT_EQ(why, "");
  EXPECT_FALSE(open_show_for(beam_engine(), "common/balls", why));
  EXPECT_THAT(why, HasSubstr("balls.toml:"));
  EXPECT_FALSE(open_show_for(block_engine(), "sphere/four", why));
  EXPECT_THAT(why, HasSubstr("four.toml:"));
  EXPECT_FALSE(open_show_for(sphere_engine(), "demo", why));
  EXPECT_EQ(why, "demo is built into beam");
  EXPECT_THROW(open_show_for(beam_engine(), "no_such_scene", why), UsageError);
}

}  // namespace
}  // namespace racebeam
