// The estimate of the worst line, held to the chip's cores in the scenes of the folder.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/line_estimate.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "tb/base/spread_frames.h"
#include "tb/bench/core_bench.h"
#include "tests/support/scene_text.h"

namespace racebeam {
namespace {

Show show_of(const std::string& text) { return {good_scene(text), ""}; }

Show shipped(const std::string& name) {
  SceneResult result = read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/" + name + ".toml");
  EXPECT_EQ(result.faults.text(name), "");
  return {std::move(result.scene), ""};
}

/// The show's knobs, with nothing to hurry for: every line gets the clocks it needs.
knobs patient(const Show& show) {
  knobs k = show.standard_knobs();
  k.hurry_threshold = -1;
  k.clocks_per_pixel = 8;
  k.fifo_entries = 64;
  return k;
}

/// All scenes of the folder but the demo's, which wraps and shows the ray pattern.
std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(RACEBEAM_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".toml" && entry.path().stem() != "demo")
      names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

class ShippedScene : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(LineEstimate, ShippedScene, testing::ValuesIn(shipped_scenes()),
                         [](const auto& info) { return info.param; });

TEST_P(ShippedScene, WorstLineIsWithinTenPercentOfTheChip) {
  constexpr double Share = 0.1;
  constexpr int Frames = 3;
  const Show show = shipped(GetParam());
  const knobs k = patient(show);
  std::vector<int> frames = spread_frames(show.frames(), Frames);
  frames.push_back(estimate_worst_line(show, show.standard_knobs()).frame);
  for (const int frame : frames) {
    const auto lines = CoreBench(k, frame, show.program()).render().stats.busy_clocks;
    const int chip = *std::max_element(lines.begin(), lines.end());
    EXPECT_NEAR(estimate_frame(show, frame, k).clocks, chip, Share * chip) << "frame " << frame;
  }
}

TEST_P(ShippedScene, NoFrameLooksWorseThanTheWorst) {
  const Show show = shipped(GetParam());
  const LineEstimate worst = estimate_worst_line(show, show.standard_knobs());
  constexpr int Others = 100;
  for (const int frame : spread_frames(show.frames(), Others)) {
    const LineEstimate line = estimate_frame(show, frame, show.standard_knobs());
    EXPECT_LE(line.clocks, worst.clocks * 1.005) << "frame " << frame << ", y " << line.y;
  }
  const LineEstimate again = estimate_frame(show, worst.frame, show.standard_knobs());
  EXPECT_EQ(again.clocks, worst.clocks);
  EXPECT_EQ(again.y, worst.y);
}

TEST(LineEstimateTest, CountsWhatALineShows) {
  const Show room = show_of("plan.storeys = \"@\"\n");
  const LineEstimate box = estimate_worst_line(room, room.standard_knobs());
  EXPECT_GE(box.intervals, 1);
  EXPECT_LE(box.intervals, 8) << "five faces, cut where a component of the ray changes its sign";
  EXPECT_LT(box.clocks, 200);
  const Show open =
      show_of("[plan]\nstoreys = \"\"\"\n@.....\n.#.#.#\n......\n.#.#.#\n......\n\"\"\"\n");
  EXPECT_GT(estimate_worst_line(open, open.standard_knobs()).clocks, box.clocks);
}

TEST(LineEstimateTest, AShallowStackCostsMore) {
  const Show show = shipped("grid");
  knobs k = show.standard_knobs();
  const int frame = show.frames() / 3;
  const int standard = estimate_frame(show, frame, k).clocks;
  k.interval_stack_depth = 1;
  EXPECT_GT(estimate_frame(show, frame, k).clocks, standard);
  EXPECT_GT(estimate_worst_line(show, k).clocks,
            estimate_worst_line(show, show.standard_knobs()).clocks);
}

TEST(LineEstimateTest, TheBudgetIsTheLineFromTheTracersStart) {
  knobs k;
  EXPECT_EQ(LineEstimate::budget(k), 1530);
  k.head_start = 320;
  EXPECT_EQ(LineEstimate::budget(k), 1210);
  k.clocks_per_pixel = 3;
  EXPECT_EQ(LineEstimate::budget(k), 2010);
}

}  // namespace
}  // namespace racebeam
